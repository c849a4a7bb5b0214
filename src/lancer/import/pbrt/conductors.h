// Metals.
#pragma once

#include <string>

#include "lancer/import/pbrt/textures.h"
#include "lancer/scene/materials.h"
#include "lancer/scene/textures.h"

namespace lancer::pbrt {

// From "eta" and "k" or "reflectance", and the roughness; copper where none is given. `prefix`: of the parameters, such as "conductor.".
scene::ConductorMaterial read_conductor(const Recipe& recipe, const Textures& textures, const std::string& prefix, double roughness,
                                        bool version3);

// What it reflects of light that falls on it at right angles.
scene::Texture head_on_color(const scene::ConductorMaterial& metal);

}  // namespace lancer::pbrt
