// Reads glTF 2.0, .gltf and .glb [Khronos 2021].
#pragma once

#include "lancer/base/file.h"
#include "lancer/import/reader.h"

namespace lancer {

void read_gltf(ImportContext& context, scene::Scene& scene);

// The same for bytes in memory; other files are named beside `context.path`.
void read_gltf(FileBytes bytes, ImportContext& context, scene::Scene& scene);

}  // namespace lancer
