// Wavefront OBJ, as much of it as is shape: see SUPPORT.md.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lancer/base/diagnostic.h"
#include "lancer/scene/scene.h"

namespace lancer {

// All faces of the file as one mesh. `file` is for messages. Nothing when there are errors.
std::optional<scene::TriangleMesh> read_obj(std::string_view bytes, const std::string& file, Diagnostics& diagnostics);

}  // namespace lancer
