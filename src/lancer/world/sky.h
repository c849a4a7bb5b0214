// The surroundings, as a record.
#pragma once

#include "lancer/base/diagnostic.h"
#include "lancer/scene/scene.h"
#include "lancer/world/surfaces.h"
#include "lancer/world/world.h"

namespace lancer {

// Fills world.sky, and reads or computes its image into world.sky_texels.
void compile_sky(const scene::Background& background, World& world, Colors& colors, Diagnostics& diagnostics);

// Makes the sky's image something to draw from, after compile_sky: fills world.distributions with cumulative shares of rows, and of the texels of each
// row, by luminance and solid angle. `compensated`: for multiple importance sampling, which leaves directions darker than the mean to the materials
// [Karlík et al. 2019]. Returns the mean luminance over all directions.
double compile_sky_shares(World& world, bool compensated);

}  // namespace lancer
