// The tree by which one of many emitters is chosen, see kernel/emitter/light_tree.h.
#pragma once

#include "lancer/world/world.h"

namespace lancer {

// Fills world.light_nodes and light_ways from world.emitters, of which the first world.far_count are infinitely far and stay outside. Without any
// near emitter of some strength there is no tree.
void compile_light_tree(World& world);

}  // namespace lancer
