// From Material directives to materials of the scene.
#pragma once

#include <functional>
#include <string>

#include "lancer/import/pbrt/graphics_state.h"
#include "lancer/import/pbrt/textures.h"
#include "lancer/scene/materials.h"

namespace lancer::pbrt {

// The number of another material by its name, for those that are mixed from others.
using FindMaterial = std::function<int(const std::string& name, const Recipe& asking)>;

// Without emission.
scene::Material build_material(const Recipe& recipe, const Textures& textures, const FindMaterial& find);
scene::Material build_old_material(const Recipe& recipe, const Textures& textures, const FindMaterial& find);  // of version 3

// Where neither version knows its kind.
scene::Material grey_material(const SourcePosition& position);

// Normal maps, bumps; "opacity" of a shape's "alpha".
void add_relief(const Recipe& recipe, const Textures& textures, scene::Material& material);

}  // namespace lancer::pbrt
