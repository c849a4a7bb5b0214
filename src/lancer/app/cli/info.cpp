// lancer info FILE
#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "lancer/app/cli/command_line.h"
#include "lancer/app/cli/import_arguments.h"
#include "lancer/app/cli/info_image.h"
#include "lancer/app/exit_status.h"
#include "lancer/app/inspect/oddities.h"
#include "lancer/app/prepare.h"
#include "lancer/base/file.h"
#include "lancer/import/import.h"
#include "lancer/scene/bounds.h"
#include "lancer/world/compile.h"
#include "lancer/world/spectra.h"

namespace lancer::app {

namespace {

constexpr std::array<const char*, std::variant_size_v<scene::Shape>> shape_names = {"sphere",   "box",  "plane", "disk",
                                                                                    "cylinder", "cone", "mesh"};
constexpr std::array<const char*, std::variant_size_v<decltype(scene::Light::model)>> light_names = {
    "point", "spot", "directional", "projector", "goniometric", "ies"};

// Everything that is seen, each group as often as it is placed.
struct Count {
    std::array<std::uint64_t, shape_names.size()> shapes{};
    std::uint64_t triangles = 0;

    void add(const scene::Object& object) {
        ++shapes[object.shape.index()];
        if (const auto* mesh = std::get_if<scene::Mesh>(&object.shape)) {
            triangles += mesh->data->triangles.size();
        }
    }
    void add(const Count& other) {
        for (std::size_t i = 0; i < shapes.size(); ++i) {
            shapes[i] += other.shapes[i];
        }
        triangles += other.triangles;
    }
};

Count count_shapes(const scene::Scene& scene) {
    std::vector<Count> groups;  // a group comes after every group it places
    for (const scene::Group& group : scene.groups) {
        Count& count = groups.emplace_back();
        for (const scene::Object& object : group.objects) {
            count.add(object);
        }
        for (const scene::Placement& placement : group.placements) {
            count.add(Count(groups[static_cast<std::size_t>(placement.group)]));
        }
    }
    Count count;
    for (const scene::Object& object : scene.objects) {
        count.add(object);
    }
    for (const scene::Placement& placement : scene.placements) {
        count.add(groups[static_cast<std::size_t>(placement.group)]);
    }
    return count;
}

std::string plural(std::uint64_t number, const std::string& word) {
    const std::string many = word == "box" || word == "mesh" ? word + "es" : word + "s";
    return fmt::format("{} {}", number, number == 1 ? word : many);
}

std::string bytes_in_words(std::size_t bytes) {
    const double number = static_cast<double>(bytes);
    return number < 1e6 ? fmt::format("{:.1f} kB", number / 1e3) : fmt::format("{:.1f} MB", number / 1e6);
}

std::string in_words(const scene::Bounds& bounds) {
    const glm::dvec3 size = bounds.high - bounds.low;
    return bounds.empty()
               ? "empty"
               : fmt::format("{:.4g} x {:.4g} x {:.4g} m, from ({:.4g}, {:.4g}, {:.4g}) to ({:.4g}, {:.4g}, {:.4g})", size.x, size.y,
                             size.z, bounds.low.x, bounds.low.y, bounds.low.z, bounds.high.x, bounds.high.y, bounds.high.z);
}

// How bright a light is: in physical scenes its power, else its share of the light.
double strength(const scene::Light& light) {
    if (!light.power) {
        return light.intensity;
    }
    const scene::Rgb power = emitted(*light.power);
    return (power.x + power.y + power.z) / 3.0;
}

void print_text(const scene::Scene& scene, const ImportReport& report, const Count& count, const World& world) {
    const scene::RenderSettings& settings = scene.settings;
    const auto row = [](const char* name, const std::string& text) { fmt::print("{:<10} {}\n", name, text); };
    row("scene", scene.file);
    row("hash", scene.hash);
    row("picture", fmt::format("{} x {}, {}, {}", settings.width, settings.height, antialiasing_in_words(scene),
                               plural(static_cast<std::uint64_t>(scene::bounces_of(scene)), "bounce")));
    row("light", scene::chosen_integrator(scene));
    row("bounds", in_words(scene::bounds(scene)));
    std::vector<std::string> cameras;
    for (const scene::Camera& camera : scene.cameras) {
        cameras.push_back(fmt::format("{} ({} degrees)", camera.name.empty() ? "unnamed" : camera.name, camera.fov));
    }
    row("cameras", fmt::format("{}", fmt::join(cameras, ", ")));
    std::vector<std::string> shapes;
    for (std::size_t i = 0; i < count.shapes.size(); ++i) {
        if (count.shapes[i] > 0) {
            shapes.push_back(plural(count.shapes[i], shape_names[i]));
        }
    }
    row("shapes", shapes.empty() ? "none" : fmt::format("{}", fmt::join(shapes, ", ")));
    if (count.triangles > 0) {
        row("triangles", fmt::format("{}", count.triangles));
    }
    if (!scene.groups.empty()) {
        row("groups", fmt::format("{}", scene.groups.size()));
    }
    const auto lamps = static_cast<std::size_t>(
        std::count_if(scene.materials.begin(), scene.materials.end(), [](const scene::Material& m) { return m.emission.has_value(); }));
    row("materials", fmt::format("{}{}", scene.materials.size(), lamps > 0 ? fmt::format(", {} of them shine", lamps) : ""));
    std::vector<std::string> lights;
    for (const scene::Light& light : scene.lights) {
        lights.push_back(
            fmt::format("{} {} ({:.3g})", light_names[light.model.index()], light.name.empty() ? "light" : light.name, strength(light)));
    }
    row("lights", lights.empty() ? "none" : fmt::format("{}", fmt::join(lights, ", ")));
    std::vector<std::string> animations;
    for (const AnimationFacts& animation : report.animations()) {
        animations.push_back(fmt::format("{} ({:.4g} s, {})", animation.name.empty() ? "unnamed" : animation.name, animation.seconds,
                                         plural(animation.channels, "channel")));
    }
    if (!animations.empty()) {
        row("animations", fmt::format("{}", fmt::join(animations, ", ")));
    }
    row("memory", fmt::format("{} of tables", bytes_in_words(world.memory())));
    row("tracing", world.is_small() ? "all objects at once, in SIMD lanes" : "a bounding volume hierarchy");
}

nlohmann::ordered_json to_json(const scene::Scene& scene, const ImportReport& report, const Count& count, const World& world,
                               const Diagnostics& diagnostics) {
    nlohmann::ordered_json json = {
        {"scene", scene.file},
        {"hash", scene.hash},
        {"width", scene.settings.width},
        {"height", scene.settings.height},
        {"bounces", scene::bounces_of(scene)},
        {"antialiasing", antialiasing_in_words(scene)},
    };
    for (const scene::Camera& camera : scene.cameras) {
        json["cameras"].push_back({{"name", camera.name}, {"fov", camera.fov}});
    }
    for (std::size_t i = 0; i < count.shapes.size(); ++i) {
        json["shapes"][shape_names[i]] = count.shapes[i];
    }
    json["triangles"] = count.triangles;
    if (const scene::Bounds bounds = scene::bounds(scene); !bounds.empty()) {
        json["bounds"] = {{"low", {bounds.low.x, bounds.low.y, bounds.low.z}}, {"high", {bounds.high.x, bounds.high.y, bounds.high.z}}};
    }
    json["groups"] = scene.groups.size();
    json["materials"] = scene.materials.size();
    json["lights"] = nlohmann::ordered_json::array();
    for (const scene::Light& light : scene.lights) {
        json["lights"].push_back({{"name", light.name}, {"type", light_names[light.model.index()]}, {"intensity", strength(light)}});
    }
    json["animations"] = nlohmann::ordered_json::array();
    for (const AnimationFacts& animation : report.animations()) {
        json["animations"].push_back({{"name", animation.name}, {"seconds", animation.seconds}, {"channels", animation.channels}});
    }
    json["bytes"] = world.memory();
    json["messages"] = nlohmann::ordered_json::array();
    for (const Diagnostic& diagnostic : diagnostics.list()) {
        json["messages"].push_back(to_string(diagnostic));
    }
    return json;
}

int show_info(const std::string& path, ImportOptions options, bool as_json) {
    options.magenta_textures = true;  // pictures that are missing are told of, and the rest of the scene as well
    Diagnostics diagnostics;
    ImportReport report;
    const std::optional<scene::Scene> scene = import_scene(path, options, report, diagnostics);
    std::shared_ptr<const World> world;
    if (scene) {
        find_oddities(*scene, diagnostics);
        world = compile_world(*scene, scene->cameras.front(), diagnostics);
    }
    if (!as_json || world == nullptr) {
        print_diagnostics(diagnostics);
    }
    if (world == nullptr) {
        return exit_bad_input;
    }
    const Count count = count_shapes(*scene);
    if (as_json) {
        fmt::print("{}\n",
                   to_json(*scene, report, count, *world, diagnostics).dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
    } else {
        print_text(*scene, report, count, *world);
    }
    return exit_done;
}

}  // namespace

void add_info(CLI::App& program, Work& work) {
    struct Arguments {
        std::string scene;
        bool json = false;
        ImportOptions options;
    };
    CLI::App* app = program.add_subcommand("info", "Tell what is in a scene, a mesh or a picture, how big it is, and what is odd about it");
    const auto arguments = std::make_shared<Arguments>();
    app->add_option("FILE", arguments->scene, scene_argument_help() + "; or a picture")->type_name("");
    app->add_flag("--json", arguments->json, "For programs");
    add_import_options(*app, arguments->options);
    app->footer("Example:\n  lancer info scenes/report/figure-1.toml");
    app->callback([app, arguments, &work] {
        work = [app, arguments]() -> int {
            if (arguments->scene.empty()) {
                return refuse("which file? For example: lancer info scene.toml", *app);
            }
            const std::vector<std::string> scenes = scene_endings();
            const std::string ending = file_ending(arguments->scene);
            if (std::find(scenes.begin(), scenes.end(), ending) == scenes.end()) {
                return show_image_info(arguments->scene, arguments->json);
            }
            return show_info(arguments->scene, arguments->options, arguments->json);
        };
    });
}

}  // namespace lancer::app
