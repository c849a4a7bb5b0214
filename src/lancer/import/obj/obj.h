// Wavefront OBJ, as much of it as is shape: see SUPPORT.md.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lancer/import/reader.h"

namespace lancer {

// All faces of the file as one mesh. `file` is for messages. Nothing when there are errors.
std::optional<scene::TriangleMesh> read_obj(std::string_view bytes, const std::string& file, Diagnostics& diagnostics);

// The file as a scene: an object for each material of each object or group, with the materials of its .mtl files.
void read_obj_scene(ImportContext& context, scene::Scene& scene);

}  // namespace lancer
