#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "lancer/base/file.h"
#include "lancer/import/default_view.h"
#include "lancer/import/gltf/gltf.h"
#include "lancer/import/import.h"
#include "lancer/import/mitsuba/mitsuba.h"
#include "lancer/import/pbrt/pbrt.h"
#include "lancer/import/reader.h"

namespace lancer {

namespace {

// The tree of values takes many times the text's size; large meshes belong into files of their own.
constexpr std::size_t largest_toml = std::size_t{32} << 20;

// An OBJ or PLY file alone.
void read_mesh_alone(ImportContext& context, scene::Scene& scene) {
    scene::Mesh mesh;
    mesh.data = context.files.mesh(context.path, {});
    if (!mesh.data) {
        return;
    }
    const SourcePosition position{context.path, 0, 0};
    scene.materials.push_back({{}, scene::WhittedMaterial{}, position});
    scene.objects.push_back({{}, mesh, 0, glm::dmat4(1.0), position});
    scene.lights = default_lights();
    scene.background = default_background();
    scene.cameras.push_back(default_camera(scene::bounds(scene)));
}

struct Format {
    std::string_view ending;
    Reader read;
};

// All formats but our own.
constexpr std::array formats = {
    Format{".gltf", read_gltf},      Format{".glb", read_gltf},  Format{".obj", read_mesh_alone},
    Format{".ply", read_mesh_alone}, Format{".pbrt", read_pbrt}, Format{".xml", read_mitsuba},
};

}  // namespace

std::vector<std::string> scene_endings() {
    std::vector<std::string> endings = {".toml"};
    for (const Format& format : formats) {
        endings.emplace_back(format.ending);
    }
    return endings;
}

std::optional<scene::Scene> import_scene(const std::string& path, const ImportOptions& options, ImportReport& report,
                                         Diagnostics& diagnostics) {
    const std::string ending = file_ending(path);
    if (ending == ".toml") {
        const auto bytes = read_file(path, {}, diagnostics, largest_toml);
        return bytes ? import_toml(bytes->view(), path, diagnostics) : std::nullopt;
    }
    const auto format = std::find_if(formats.begin(), formats.end(), [&](const Format& f) { return f.ending == ending; });
    if (format == formats.end()) {
        diagnostics.error({}, fmt::format("cannot tell what \"{}\" is: scenes end with one of {}", path, fmt::join(scene_endings(), ", ")));
        return std::nullopt;
    }
    Diagnostics ours;
    SceneFiles files(path, options, ours);
    scene::Scene scene;
    scene.file = path;
    ImportContext context{path, options, files, report, ours};
    format->read(context, scene);
    scene.hash = files.hash();
    scene.inputs = files.inputs();
    const bool failed = ours.has_errors();
    diagnostics.append(std::move(ours));
    return failed ? std::nullopt : std::optional<scene::Scene>(std::move(scene));
}

std::optional<scene::Scene> import_scene(const std::string& path, Diagnostics& diagnostics) {
    ImportReport report;
    return import_scene(path, {}, report, diagnostics);
}

}  // namespace lancer
