// Any bytes as a pbrt file: a scene or at least one error, and nothing else.
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "lancer/import/import.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    // Readers open files by themselves: each process has one of its own, in memory where the system has such a place.
    static const std::string path = "/dev/shm/lancer-fuzz-" + std::to_string(::getpid()) + ".pbrt";
    std::FILE* file = std::fopen(path.c_str(), "wb");
    if (file == nullptr || std::fwrite(data, 1, size, file) != size || std::fclose(file) != 0) {
        return 0;
    }
    lancer::ImportOptions options;
    options.sandbox = true;
    lancer::ImportReport report;
    lancer::Diagnostics diagnostics;
    const auto scene = lancer::import_scene(path, options, report, diagnostics);
    ::unlink(path.c_str());
    if (scene.has_value() == diagnostics.has_errors()) {
        std::abort();
    }
    if (scene) {
        for (const auto& object : scene->objects) {
            if (object.material < 0 || static_cast<std::size_t>(object.material) >= scene->materials.size()) {
                std::abort();
            }
        }
        for (const auto& placement : scene->placements) {
            if (placement.group < 0 || static_cast<std::size_t>(placement.group) >= scene->groups.size()) {
                std::abort();
            }
        }
        if (scene->cameras.empty()) {
            std::abort();
        }
    }
    return 0;
}
