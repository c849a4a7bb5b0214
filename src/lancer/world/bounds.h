// Spheres around the objects of a small world.
#pragma once

#include "lancer/world/world.h"

namespace lancer {

// Fills world.bound_*: every point of object i that the kernel can report lies inside sphere i, with room for the rounding of whoever asks.
void compile_bounds(World& world);

}  // namespace lancer
