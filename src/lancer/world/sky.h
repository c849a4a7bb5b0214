// The surroundings, as a record.
#pragma once

#include "lancer/base/diagnostic.h"
#include "lancer/scene/lights.h"
#include "lancer/world/surfaces.h"
#include "lancer/world/world.h"

namespace lancer {

// Fills world.sky, and reads or computes its image into world.sky_texels.
void compile_sky(const scene::Background& background, World& world, Colors& colors, Diagnostics& diagnostics);

// Mean luminances over all directions.
struct SkyLight {
    double mean = 0.0;   // of all light
    double asked = 0.0;  // of what is worth asking for; the rest is left to the materials, which find it by themselves
};

// Makes the sky's image something to draw from, after compile_sky: fills world.distributions with cumulative shares of rows, and of the texels of each
// row, by luminance and solid angle. `compensated`: for multiple importance sampling, which leaves directions darker than the mean to the materials,
// and so an even sky as a whole [Karlík et al. 2019].
SkyLight compile_sky_shares(World& world, bool compensated);

}  // namespace lancer
