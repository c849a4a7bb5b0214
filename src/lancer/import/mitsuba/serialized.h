// Mitsuba's own binary meshes, several in a file, each compressed.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lancer/base/diagnostic.h"
#include "lancer/scene/shapes.h"

namespace lancer::mitsuba {

// The mesh with this number, from 0. `file` is for messages. Nothing when there are errors.
std::optional<scene::TriangleMesh> read_serialized(std::string_view bytes, int number, const std::string& file, Diagnostics& diagnostics);

}  // namespace lancer::mitsuba
