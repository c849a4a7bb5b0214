// What a glance at the lamps of a scene tells of how their light is best followed.
#pragma once

#include "lancer/scene/scene.h"

namespace lancer::scene {

// Whether all surfaces that shine are small beside the scene, and together outshine what surrounds it. False where none shines. Seen as boxes: many
// small lamps in one mesh are a large one.
bool has_small_lamps_only(const Scene& scene);

// The least distance of a lamp without size from a thing that is not in a group, over that of the lamp from the camera; infinite where there is none.
// Seen as boxes: what the lamp stands within, as in a room, is left out.
double nearest_to_lamp(const Scene& scene);

}  // namespace lancer::scene
