// Any bytes as a Mitsuba scene: a scene that can be used, or at least one error.
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "lancer/import/import.h"

namespace {

// The reader opens files, so the bytes go into one, in a folder of this process alone.
const std::string& scene_file() {
    static const std::string file = [] {
        const auto folder = std::filesystem::temp_directory_path() / ("lancer-fuzz-mitsuba-" + std::to_string(getpid()));
        std::filesystem::create_directories(folder);
        return (folder / "scene.xml").string();
    }();
    return file;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::ofstream(scene_file(), std::ios::binary).write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    lancer::ImportOptions options;
    options.sandbox = true;
    lancer::ImportReport report;
    lancer::Diagnostics diagnostics;
    const auto scene = lancer::import_scene(scene_file(), options, report, diagnostics);
    if (scene.has_value() == diagnostics.has_errors() || (scene && scene->cameras.empty())) {
        std::abort();
    }
    if (scene) {
        for (const auto& object : scene->objects) {
            if (object.material < 0 || static_cast<std::size_t>(object.material) >= scene->materials.size()) {
                std::abort();
            }
        }
    }
    return 0;
}
