// Reads a scene file of any format we know.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lancer/base/diagnostic.h"
#include "lancer/scene/scene.h"

namespace lancer {

// Chosen by the file's ending. Every problem is a diagnostic; nothing is returned when there are errors. OBJ and PLY files alone get a default
// camera and light.
std::optional<scene::Scene> import_scene(const std::string& path, Diagnostics& diagnostics);

// The TOML notation from memory; `path` is for messages and for files named in the text.
std::optional<scene::Scene> import_toml(std::string_view text, const std::string& path, Diagnostics& diagnostics);

// JSON Schema of the TOML notation, made from the tables that the reader uses.
std::string toml_schema();

}  // namespace lancer
