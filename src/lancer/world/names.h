// What objects and materials are called.
#pragma once

#include "lancer/scene/scene.h"
#include "lancer/world/flatten.h"
#include "lancer/world/world.h"

namespace lancer {

// Fills World::names, one for each of `flat`, and World::material_names.
void compile_names(const scene::Scene& scene, const std::vector<FlatObject>& flat, World& world);

// "sphere", "mesh", ...
const char* kind_of(const scene::Shape& shape);

}  // namespace lancer
