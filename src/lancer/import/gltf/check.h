// What a schema can't say: what one part of a file promises about another.
#pragma once

#include "lancer/import/gltf/accessors.h"
#include "lancer/import/gltf/nodes.h"

namespace lancer::gltf {

// Every accessor is opened and held against its own minimum and maximum; meshes, skins and animations are looked at. What can be read all the same is
// a warning.
void check(Document& document, Accessors& accessors, const Nodes& nodes);

// Its parts.
void check_meshes(Document& document);
void check_skins(Document& document, Accessors& accessors, const Nodes& nodes);
void check_animations(Document& document, Accessors& accessors);

// The part about values: minimum, maximum, numbers that are not finite.
void check_values(Document& document, const Accessor& accessor);

}  // namespace lancer::gltf
