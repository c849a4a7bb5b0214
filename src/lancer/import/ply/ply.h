// Polygon File Format, ascii and binary: see SUPPORT.md.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lancer/base/diagnostic.h"
#include "lancer/scene/shapes.h"

namespace lancer {

// `file` is for messages. Nothing when there are errors.
std::optional<scene::TriangleMesh> read_ply(std::string_view bytes, const std::string& file, Diagnostics& diagnostics);

}  // namespace lancer
