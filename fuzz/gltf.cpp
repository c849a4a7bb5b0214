// Any bytes as glTF: a sound scene or at least one error, and nothing else.
#include "lancer/import/gltf/gltf.h"

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "checked_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace lancer;
    // Beside a folder that is not there: no other file is found.
    const std::string path = "/nowhere/fuzz.gltf";
    Diagnostics diagnostics;
    ImportOptions options;
    options.frame = 0.5;
    options.sandbox = true;
    ImportReport report;
    SceneFiles files(path, options, diagnostics);
    ImportContext context{path, options, files, report, diagnostics};
    FileBytes bytes{std::make_unique<char[]>(size), size};
    std::memcpy(bytes.data.get(), data, size);
    scene::Scene scene;
    read_gltf(std::move(bytes), context, scene);
    if (diagnostics.has_errors()) {
        return 0;
    }
    for (const scene::Object& object : scene.objects) {
        check_sound_mesh(std::get<scene::Mesh>(object.shape).data.get());
    }
    return 0;
}
