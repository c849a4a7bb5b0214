#include "lancer/app/default_scene.h"

#include <algorithm>
#include <string>

#include "lancer/app/embedded_scenes.h"
#include "lancer/import/import.h"

namespace lancer::app {

std::optional<scene::Scene> import_default_scene(Diagnostics& diagnostics) {
    for (const EmbeddedFile& file : embedded_scenes()) {
        if (file.path == default_scene_path) {
            return import_toml(file.bytes, std::string(file.path), diagnostics);
        }
    }
    diagnostics.error({}, "the program was built without its scenes");
    return std::nullopt;
}

}  // namespace lancer::app
