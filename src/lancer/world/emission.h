// What paths of light need beside the emitters themselves.
#pragma once

#include "lancer/world/world.h"

namespace lancer {

// Finds a sphere around everything that is not infinite, and appends to world.distributions the cumulative shares of each emitter's power, about.
// After all emitters have been compiled.
void compile_emission(World& world);

}  // namespace lancer
