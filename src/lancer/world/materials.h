// Materials and textures as records.
#pragma once

#include "lancer/base/diagnostic.h"
#include "lancer/scene/scene.h"
#include "lancer/world/world.h"

namespace lancer {

// Fills world.materials, textures, texels, bands and has_transparency; scene.materials[i] becomes world.materials[i].
void compile_materials(const scene::Scene& scene, World& world, Diagnostics& diagnostics);

}  // namespace lancer
