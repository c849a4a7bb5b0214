// What is allowed in a scene and yet is rarely meant.
#pragma once

#include "lancer/base/diagnostic.h"
#include "lancer/scene/scene.h"

namespace lancer::app {

// Warnings about: closed meshes whose faces point inwards, open meshes as bodies of glass, lamps and cameras inside of opaque bodies, lights without
// power, colours that reflect more than arrives, sizes that look like millimetres taken for metres.
void find_oddities(const scene::Scene& scene, Diagnostics& diagnostics);

}  // namespace lancer::app
