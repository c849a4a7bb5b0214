// Media as records.
#pragma once

#include "lancer/base/diagnostic.h"
#include "lancer/scene/scene.h"
#include "lancer/world/surfaces.h"
#include "lancer/world/world.h"

namespace lancer {

// Fills world.volumes and world.grids, and tells the materials, which must have been compiled, what is inside of them. A medium that is even and only
// absorbs becomes part of its material: light through it is found without a draw.
void compile_volumes(const scene::Scene& scene, World& world, Colors& colors, Diagnostics& diagnostics);

}  // namespace lancer
