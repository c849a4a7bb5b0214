// KHR_draco_mesh_compression: a primitive's vertices and triangles, compressed by Google's Draco.
#pragma once

#include "lancer/import/gltf/attributes.h"

namespace lancer::gltf {

// `draco` is the extension's object. False after a message.
bool read_draco(Document& document, Accessors& accessors, Json primitive, Json draco, const Wishes& wishes, Attributes& attributes);

}  // namespace lancer::gltf
