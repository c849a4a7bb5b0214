// Materials and textures as records.
#pragma once

#include "lancer/base/diagnostic.h"
#include "lancer/scene/scene.h"
#include "lancer/world/surfaces.h"
#include "lancer/world/textures.h"
#include "lancer/world/world.h"

namespace lancer {

// Fills world.materials, media, bands and has_transparency; scene.materials[i] becomes world.materials[i].
void compile_materials(const scene::Scene& scene, World& world, Textures& textures, Colors& colors, Diagnostics& diagnostics);

}  // namespace lancer
