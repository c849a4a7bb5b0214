// From a Material directive to a material of the scene.
#pragma once

#include "lancer/import/pbrt/graphics_state.h"
#include "lancer/import/pbrt/textures.h"
#include "lancer/scene/scene.h"

namespace lancer::pbrt {

// Without emission. Names of other materials, in a mix, are looked up with `find`, null where there is none; at most `depth` deep.
scene::Material build_material(const Recipe& recipe, const Textures& textures, bool version3);

}  // namespace lancer::pbrt
