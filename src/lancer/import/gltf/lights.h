// Cameras and lamps that hang on nodes.
#pragma once

#include "lancer/import/gltf/nodes.h"
#include "lancer/scene/scene.h"

namespace lancer::gltf {

// The camera or lamp of a node, if it has one, added to the scene.
void add_camera(Document& document, const Node& node, scene::Scene& scene);
void add_light(Document& document, const Node& node, scene::Scene& scene);

}  // namespace lancer::gltf
