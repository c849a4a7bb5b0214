// What every reader of a format is given.
#pragma once

#include <string>

#include "lancer/base/diagnostic.h"
#include "lancer/import/import.h"
#include "lancer/import/scene_files.h"
#include "lancer/scene/scene.h"

namespace lancer {

struct ImportContext {
    const std::string& path;  // as named by the user
    const ImportOptions& options;
    SceneFiles& files;  // all other files are opened through this: it hashes them and keeps to the sandbox
    ImportReport& report;
    Diagnostics& diagnostics;
};

// Fills a new scene with what the file holds, but for `file` and `hash`. Errors are diagnostics; the scene is then thrown away. Readers give
// default cameras and lights by themselves, since they know what their format means by leaving them out.
using Reader = void (*)(ImportContext& context, scene::Scene& scene);

// Calls the reader for the ending of context.path. Errors are diagnostics at `named_at`, where the file was named.
void read_scene(ImportContext& context, const SourcePosition& named_at, scene::Scene& scene);

// Our own notation.
void read_toml(ImportContext& context, scene::Scene& scene);

}  // namespace lancer
