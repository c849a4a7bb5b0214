// Grids as records.
#pragma once

#include "lancer/base/diagnostic.h"
#include "lancer/scene/media.h"
#include "lancer/world/world.h"

namespace lancer {

// Fills world.grids and world.voxels; returns the grid's number. `position`: of the medium that it belongs to.
int compile_grid(const scene::Grid& grid, const SourcePosition& position, World& world, Diagnostics& diagnostics);

}  // namespace lancer
