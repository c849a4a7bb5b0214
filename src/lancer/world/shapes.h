// Shapes as records.
#pragma once

#include <vector>

#include "lancer/base/diagnostic.h"
#include "lancer/world/flatten.h"
#include "lancer/world/world.h"

namespace lancer {

// Fills the tables of shapes and world.objects, kind by kind. Materials must have been compiled: a shape with a texture keeps its own space.
// Meshes become triangles in world space when all objects together are few, instances otherwise.
void compile_shapes(const std::vector<FlatObject>& flat, World& world, Diagnostics& diagnostics);

}  // namespace lancer
