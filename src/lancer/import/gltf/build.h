// From a glTF document to a scene.
#pragma once

#include "lancer/import/gltf/document.h"
#include "lancer/import/reader.h"

namespace lancer::gltf {

// Cameras and lights of the chosen scene, and everything that is to be seen. Problems go to the document.
void build(Document& document, ImportContext& context, scene::Scene& scene);

}  // namespace lancer::gltf
