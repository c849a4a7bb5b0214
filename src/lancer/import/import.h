// Reads a scene file of any format we know.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lancer/base/diagnostic.h"
#include "lancer/import/report.h"
#include "lancer/scene/scene.h"

namespace lancer {

// What a user may say about how a file is to be read. Formats pass over what means nothing to them.
struct ImportOptions {
    double frame = 0.0;                          // seconds at which animations are evaluated
    std::map<std::string, std::string> defines;  // of $parameters, by name
    std::string variant;                         // of materials; empty: the file's own
    std::string scene;                           // of files with several; empty: the file's default
    bool sandbox = false;                        // files outside the scene's folder are not opened
    bool magenta_textures = false;               // pictures that are missing become magenta instead of errors
    bool is_part = false;                        // of another scene: neither camera nor light are given to a file without
};

// The format is chosen by the file's ending. Every problem is a diagnostic; nothing is returned when there are errors. Files without a camera or
// light get default ones.
std::optional<scene::Scene> import_scene(const std::string& path, const ImportOptions& options, ImportReport& report,
                                         Diagnostics& diagnostics);
std::optional<scene::Scene> import_scene(const std::string& path, Diagnostics& diagnostics);

// The endings of files that can be read, with their dots.
std::vector<std::string> scene_endings();

// The TOML notation from memory; `path` is for messages and for files named in the text.
std::optional<scene::Scene> import_toml(std::string_view text, const std::string& path, Diagnostics& diagnostics);

// A scene in our notation, and the files beside it.
struct WrittenScene {
    struct Picture {
        std::string name;
        std::shared_ptr<const std::string> bytes;
    };

    std::string toml;
    std::string mesh_file;          // its name; empty when there is none
    std::string meshes;             // its bytes
    std::vector<Picture> pictures;  // from within the scene; and grids of numbers
};

// Reading the result gives a scene that renders to the same picture. `path` is where the text will stand: other files are named as seen from
// there. Writes no files.
WrittenScene write_toml(const scene::Scene& scene, const std::string& path);

// JSON Schema of the TOML notation, made from the tables that the reader uses.
std::string toml_schema();

}  // namespace lancer
