// The clear sky of kernel/emitter/sky_model.h.
#pragma once

#include "lancer/scene/lights.h"
#include "lancer/world/surfaces.h"
#include "lancer/world/world.h"

namespace lancer {

// Fills world.sky, its table, and its image in RGB.
void compile_clear_sky(const scene::ClearSky& sky, double strength, World& world, Colors& colors);

}  // namespace lancer
