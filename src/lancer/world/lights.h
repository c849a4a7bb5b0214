// Lights without size, as records.
#pragma once

#include "lancer/kernel/records.h"
#include "lancer/scene/lights.h"

namespace lancer {

// Cosines of the angles from a spot's axis at which its light ends and begins to fade; they differ, so that nothing divides by zero.
struct SpotCone {
    float cos_outer = 0.0f;
    float cos_inner = 1.0f;
};

SpotCone spot_cone(const scene::SpotLight& spot);
int fade_of(const scene::SpotLight& spot);  // FADE_*

// For Whitted's integrator: its share of the light.
kernel::LightRecord light_record(const scene::Light& light);

}  // namespace lancer
