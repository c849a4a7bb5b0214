#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glm/geometric.hpp>

#include "lancer/base/file.h"
#include "lancer/base/overloaded.h"
#include "lancer/import/default_view.h"
#include "lancer/import/gltf/gltf.h"
#include "lancer/import/import.h"
#include "lancer/import/mitsuba/mitsuba.h"
#include "lancer/import/obj/obj.h"
#include "lancer/import/pbrt/pbrt.h"
#include "lancer/import/reader.h"

namespace lancer {

namespace {

// What a mesh that stands alone is seen by, unless the file says more.
void add_view(ImportContext& context, scene::Scene& scene) {
    if (context.options.is_part || context.diagnostics.has_errors()) {
        return;
    }
    const bool is_physical = std::any_of(scene.materials.begin(), scene.materials.end(), scene::is_physical);
    const bool shines = std::any_of(scene.materials.begin(), scene.materials.end(), [](const auto& m) { return m.emission.has_value(); });
    if (!is_physical) {
        scene.lights = default_lights();
        scene.background = default_background();
    } else if (!shines) {
        scene.background = neutral_surroundings();
        context.report.approximated("no light", "neutral surroundings, brighter above, light the scene", {context.path});
        context.diagnostics.note({context.path}, "there is no light: neutral surroundings, brighter above, are used");
    }
    scene.cameras.push_back(default_camera(scene::bounds(scene)));
}

// A PLY file alone.
void read_mesh_alone(ImportContext& context, scene::Scene& scene) {
    scene::Mesh mesh;
    mesh.data = context.files.mesh(context.path, {});
    if (!mesh.data) {
        return;
    }
    const SourcePosition position{context.path, 0, 0};
    scene.materials.push_back({{}, scene::WhittedMaterial{}, position, std::nullopt, true});
    scene.objects.push_back({{}, mesh, 0, glm::dmat4(1.0), position});
    add_view(context, scene);
}

void read_obj_alone(ImportContext& context, scene::Scene& scene) {
    read_obj_scene(context, scene);
    add_view(context, scene);
}

// Of length 1, and the same bits when it is that already but for rounding: what is written down and read again stays as it is.
void straighten(glm::dvec3& direction) {
    const double length_2 = glm::dot(direction, direction);
    if (length_2 > 0.0 && std::isfinite(length_2) && std::abs(length_2 - 1.0) > 1e-15) {
        direction /= std::sqrt(length_2);
    }
}

void straighten(scene::Scene& scene) {
    for (scene::Camera& camera : scene.cameras) {
        straighten(camera.direction);
        straighten(camera.up);
    }
    for (scene::Light& light : scene.lights) {
        std::visit(Overloaded{[](scene::PointLight&) {}, [](scene::DirectionalLight& sun) { straighten(sun.direction); },
                              [](scene::IesLight& lamp) {
                                  straighten(lamp.direction);
                                  straighten(lamp.forward);
                              },
                              [](auto& thrown) {
                                  straighten(thrown.direction);
                                  straighten(thrown.up);
                              }},
                   light.model);
    }
}

struct Format {
    std::string_view ending;
    Reader read;
};

constexpr std::array formats = {
    Format{".toml", read_toml},      Format{".gltf", read_gltf}, Format{".glb", read_gltf},    Format{".obj", read_obj_alone},
    Format{".ply", read_mesh_alone}, Format{".pbrt", read_pbrt}, Format{".xml", read_mitsuba},
};

}  // namespace

std::vector<std::string> scene_endings() {
    std::vector<std::string> endings;
    for (const Format& format : formats) {
        endings.emplace_back(format.ending);
    }
    return endings;
}

void read_scene(ImportContext& context, const SourcePosition& named_at, scene::Scene& scene) {
    const std::string ending = file_ending(context.path);
    const auto format = std::find_if(formats.begin(), formats.end(), [&](const Format& f) { return f.ending == ending; });
    if (format == formats.end()) {
        context.diagnostics.error(
            named_at, fmt::format("cannot tell what \"{}\" is: scenes end with one of {}", context.path, fmt::join(scene_endings(), ", ")));
    } else if (context.files.enter(context.path, named_at)) {
        scene.file = context.path;
        format->read(context, scene);
        context.files.leave();
    }
}

std::optional<scene::Scene> import_scene(const std::string& path, const ImportOptions& options, ImportReport& report,
                                         Diagnostics& diagnostics) {
    Diagnostics ours;
    SceneFiles files(path, options, ours);
    scene::Scene scene;
    ImportContext context{path, options, files, report, ours};
    read_scene(context, {}, scene);
    straighten(scene);
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
