#include "lancer/import/gltf/gltf.h"

#include "lancer/base/file.h"
#include "lancer/import/default_view.h"
#include "lancer/import/gltf/build.h"

namespace lancer {

void read_gltf(ImportContext& context, scene::Scene& scene) {
    // Data in URIs takes four thirds of its size as text: what is larger belongs into a file of its own.
    constexpr std::size_t largest_text = std::size_t{1} << 30, largest_binary = (std::size_t{1} << 32) - 1;
    if (auto bytes = context.files.open(context.path, {}, file_ending(context.path) == ".glb" ? largest_binary : largest_text)) {
        read_gltf(std::move(*bytes), context, scene);
    }
}

void read_gltf(FileBytes bytes, ImportContext& context, scene::Scene& scene) {
    if (!context.options.is_part) {
        scene.settings.integrator = "path";  // a file says nothing of that; where it is a part the whole does
    }
    gltf::Document document(context.path, context.diagnostics, context.report);
    if (!document.load(std::move(bytes))) {
        return;
    }
    gltf::build(document, context, scene);
    if (document.has_errors() || context.diagnostics.has_errors()) {
        return;
    }
    if (scene.objects.empty() && scene.placements.empty()) {
        context.diagnostics.warning({context.path}, "there is nothing to be seen in this file");
    }
    if (context.options.is_part) {
        return;
    }
    if (scene.cameras.empty()) {
        scene.cameras.push_back(default_camera(scene::bounds(scene)));
        context.report.approximated("no camera", "one that sees everything stands in front of it", {context.path});
        context.diagnostics.note({context.path}, "there is no camera: one that sees everything is used");
    }
    if (scene.lights.empty()) {
        scene.background = neutral_surroundings();
        context.report.approximated("no light", "neutral surroundings, brighter above, light the scene", {context.path});
        context.diagnostics.note({context.path}, "there is no light: neutral surroundings, brighter above, are used");
    }
}

}  // namespace lancer
