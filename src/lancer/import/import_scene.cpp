#include <fmt/format.h>

#include "lancer/base/file.h"
#include "lancer/import/default_view.h"
#include "lancer/import/import.h"
#include "lancer/import/scene_files.h"

namespace lancer {

namespace {

// The tree of values takes many times the text's size; large meshes belong into files of their own.
constexpr std::size_t largest_text = std::size_t{32} << 20;

std::optional<scene::Scene> import_mesh(const std::string& path, Diagnostics& diagnostics) {
    SceneFiles files(diagnostics);
    scene::Mesh mesh;
    mesh.data = files.mesh(path, {});
    if (!mesh.data) {
        return std::nullopt;
    }
    const SourcePosition position{path, 0, 0};
    scene::Scene scene;
    scene.file = path;
    scene.hash = files.hash();
    scene.materials.push_back({{}, scene::WhittedMaterial{}, position});
    scene.objects.push_back({{}, mesh, 0, glm::dmat4(1.0), position});
    scene.lights = default_lights();
    scene.background = default_background();
    scene.cameras.push_back(default_camera(scene::bounds(scene)));
    return scene;
}

}  // namespace

std::optional<scene::Scene> import_scene(const std::string& path, Diagnostics& diagnostics) {
    const std::string ending = file_ending(path);
    if (ending == ".obj" || ending == ".ply") {
        return import_mesh(path, diagnostics);
    }
    if (ending != ".toml") {
        diagnostics.error({}, fmt::format("cannot tell what \"{}\" is: scenes end with .toml, .obj or .ply", path));
        return std::nullopt;
    }
    const auto bytes = read_file(path, {}, diagnostics, largest_text);
    if (!bytes) {
        return std::nullopt;
    }
    return import_toml(bytes->view(), path, diagnostics);
}

}  // namespace lancer
