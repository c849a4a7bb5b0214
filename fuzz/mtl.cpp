// Any bytes as the materials of an OBJ file: materials whose numbers are within reach, and no crash.
#include "lancer/import/obj/mtl.h"

#include <cstddef>
#include <cstdint>

#include "checked_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace lancer;
    // Beside a folder that is not there: no picture is found.
    const std::string path = "/nowhere/fuzz.mtl";
    Diagnostics diagnostics;
    ImportOptions options;
    options.magenta_textures = true;
    ImportReport report;
    SceneFiles files(path, options, diagnostics);
    ImportContext context{path, options, files, report, diagnostics};
    for (const obj::MaterialStatements& statements : obj::parse_materials({reinterpret_cast<const char*>(data), size}, path, context)) {
        const scene::Material material = obj::make_material(statements, path, context);
        require(material.opacity.texture || (material.opacity.number >= 0.0 && material.opacity.number <= 1.0));
    }
    return 0;
}
