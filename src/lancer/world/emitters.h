// Everything that gives light, as records.
#pragma once

#include "lancer/base/diagnostic.h"
#include "lancer/scene/scene.h"
#include "lancer/world/surfaces.h"
#include "lancer/world/world.h"

namespace lancer {

// Fills world.emitters, distributions and the surroundings, and says in world.objects which are lamps. Surfaces and shapes must have been
// compiled.
void compile_emitters(const scene::Scene& scene, World& world, Textures& textures, Colors& colors, Diagnostics& diagnostics);

}  // namespace lancer
