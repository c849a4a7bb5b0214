// For scenes whose author left the view open.
#pragma once

#include <vector>

#include "lancer/scene/bounds.h"
#include "lancer/scene/scene.h"

namespace lancer {

// Sees all of `bounds` from the front, from the right and a little from above.
scene::Camera default_camera(const scene::Bounds& bounds);

// Two directional lights, one from the upper left and a weaker one from the right; their shares sum to 1.
std::vector<scene::Light> default_lights();

// Light grey, brighter above.
scene::Background default_background();

// For light that follows physics: grey surroundings, brighter above, that light a scene without lamps; a white surface that faces up is seen as white.
scene::Background neutral_surroundings();

}  // namespace lancer
