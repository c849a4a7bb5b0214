#include "lancer/app/prepare.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "lancer/app/cli/spelling.h"
#include "lancer/device/cpu/cpu.h"
#include "lancer/render/goal_plan.h"
#include "lancer/scene/integrator.h"
#include "lancer/world/compile.h"

namespace lancer::app {

namespace {

// "; did you mean ...?" or nothing.
std::string hint(const std::string& word, const std::vector<std::string>& candidates) {
    const std::string question = did_you_mean(word, candidates);
    return question.empty() ? "" : ";" + question;
}

void choose_camera(scene::Scene& scene, const std::string& name, Diagnostics& diagnostics) {
    std::vector<std::string> names;
    for (const scene::Camera& camera : scene.cameras) {
        if (camera.name == name) {
            scene.cameras = {scene::Camera(camera)};
            return;
        }
        if (!camera.name.empty()) {
            names.push_back(camera.name);
        }
    }
    const std::string known = names.empty() ? "none of its cameras has a name" : fmt::format("it has {}", fmt::join(names, ", "));
    diagnostics.error({}, fmt::format("--camera: {} has no camera \"{}\" ({}){}", scene.file, name, known, hint(name, names)));
}

// A light by its name, or by its number in the scene, from 1.
std::optional<std::size_t> find_light(const scene::Scene& scene, const std::string& name) {
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        if (scene.lights[i].name == name) {
            return i;
        }
    }
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        if (std::to_string(i + 1) == name) {
            return i;
        }
    }
    return std::nullopt;
}

void choose_lights(scene::Scene& scene, const std::vector<std::string>& names, Diagnostics& diagnostics) {
    std::vector<bool> wanted(scene.lights.size(), false);
    for (const std::string& name : names) {
        if (const std::optional<std::size_t> i = find_light(scene, name)) {
            wanted[*i] = true;
            continue;
        }
        std::vector<std::string> known;
        for (const scene::Light& light : scene.lights) {
            if (!light.name.empty()) {
                known.push_back(light.name);
            }
        }
        const std::string count = scene.lights.size() == 1 ? "one light" : fmt::format("{} lights", scene.lights.size());
        diagnostics.error({}, fmt::format("--lights: {} has no light \"{}\" (it has {}{}){}", scene.file, name, count,
                                          known.empty() ? "" : fmt::format(": {}", fmt::join(known, ", ")), hint(name, known)));
    }
    if (diagnostics.has_errors()) {
        return;
    }
    std::vector<scene::Light> kept;
    double sum = 0.0;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        if (wanted[i]) {
            kept.push_back(scene.lights[i]);
            sum += scene.lights[i].intensity;
        }
    }
    for (scene::Light& light : kept) {
        light.intensity = sum > 0.0 ? light.intensity / sum : light.intensity;
    }
    scene.lights = std::move(kept);
}

// A line for each file: its hash and its name.
std::string inputs_in_words(const scene::Scene& scene) {
    std::string lines;
    for (const scene::InputFile& input : scene.inputs) {
        lines += fmt::format("{}{} {}", lines.empty() ? "" : "\n", input.hash, input.path);
    }
    return lines;
}

// Samples a pixel: with other goals the scene's own number is none.
constexpr int many_samples = 1 << 16;

int samples_wanted(const scene::Scene& scene, const RenderArguments& arguments) {
    return arguments.spp || (!arguments.error && !arguments.seconds) ? scene.settings.spp : many_samples;
}

// What has to be kept of the samples for the goals.
void add_goals(const scene::Scene& scene, const RenderArguments& arguments, PictureContents& contents, Diagnostics& diagnostics) {
    if (!scene::follows_paths(scene) && (arguments.error || arguments.seconds || arguments.clamp)) {
        diagnostics.error({},
                          "--error, --time and --clamp are for light that follows paths, but this scene is rendered by Whitted's "
                          "integrator, which has no noise");
        return;
    }
    const bool has_intervals = std::find(contents.aovs.begin(), contents.aovs.end(), Aov::interval) != contents.aovs.end();
    contents.runs = arguments.error.has_value() || has_intervals;
    contents.confidence = arguments.confidence.value_or(0.95);
    contents.clamp = arguments.clamp.value_or(0.0);
}

std::string goal_in_words(const scene::Scene& scene, const RenderArguments& arguments) {
    if (!scene::follows_paths(scene) || (!arguments.error && !arguments.seconds)) {
        return antialiasing_in_words(scene);
    }
    std::vector<std::string> goals;
    if (arguments.error) {
        goals.push_back(
            fmt::format("an error of {}% for {}% of the pixels", *arguments.error * 100.0, arguments.confidence.value_or(0.95) * 100.0));
    }
    if (arguments.seconds) {
        goals.push_back(fmt::format("{} s", *arguments.seconds));
    }
    goals.push_back(fmt::format("{} samples a pixel", samples_wanted(scene, arguments)));
    return fmt::format("{}", fmt::join(goals, " or "));
}

Metadata describe(const scene::Scene& scene, const RenderArguments& arguments, const std::string& command) {
    const scene::RenderSettings& settings = scene.settings;
    return {
        {"Software", "lancer " LANCER_VERSION},
        {"lancer:version", LANCER_VERSION},
        {"lancer:command", command},
        {"lancer:scene", scene.file},
        {"lancer:hash", scene.hash},
        {"lancer:inputs", inputs_in_words(scene)},
        {"lancer:seed", fmt::format("{}", settings.seed)},
        {"lancer:camera", scene.cameras.front().name},
        {"lancer:integrator", scene::chosen_integrator(scene)},
        {"lancer:bounces", fmt::format("{}", scene::bounces_of(scene))},
        {"lancer:antialiasing", goal_in_words(scene, arguments)},
        {"lancer:exposure", fmt::format("{}", settings.exposure)},
        {"lancer:view", settings.view},
        {"lancer:color", "linear Rec. 709 primaries, D65 white; PNG and JPEG encoded as sRGB"},
    };
}

// What EXR files are to hold beside the picture.
PictureContents contents_of(const scene::Scene& scene, Diagnostics& diagnostics) {
    PictureContents contents;
    for (const std::string& name : scene.settings.aovs) {
        const std::optional<Aov> aov = find_aov(name);
        if (!aov) {
            diagnostics.error({},
                              fmt::format("--aov: there is no \"{}\" ({}){}", name, fmt::join(aov_names(), ", "), hint(name, aov_names())));
        } else if (std::find(contents.aovs.begin(), contents.aovs.end(), *aov) == contents.aovs.end()) {
            contents.aovs.push_back(*aov);
        }
    }
    contents.spectral_bins = scene.settings.spectral_bins;
    contents.wide = scene.settings.wide;
    const std::string integrator = scene::chosen_integrator(scene);
    if (const std::string lacks = scene::lacking(scene, integrator); !lacks.empty()) {
        diagnostics.error({}, fmt::format("the {} integrator does not make {}; --integrator path does", integrator, lacks));
    } else if (!scene::starts_at_lamps(integrator) && integrator != "path" && (!contents.aovs.empty() || contents.spectral_bins > 0)) {
        diagnostics.error(
            {},
            "--aov and --spectral-bins are for the path integrator, but this scene is rendered by Whitted's; --integrator path "
            "would choose the other");
    }
    if (scene.settings.rgb && contents.spectral_bins > 0) {
        diagnostics.error({}, "--spectral-bins needs paths that carry wavelengths, not RGB");
    }
    return contents;
}

PictureNames names_of(const World& world) {
    PictureNames names;
    for (std::size_t i = 0; i < world.objects.size(); ++i) {
        names.objects.push_back(world.object_name(static_cast<int>(i)));
    }
    for (std::size_t i = 0; i < world.materials.size(); ++i) {
        names.materials.push_back(world.material_name(static_cast<int>(i)));
    }
    return names;
}

Tracer tracer_named(const std::optional<std::string>& name) {
    if (name == "lanes") {
        return Tracer::all_objects;
    }
    return name == "bvh" ? Tracer::tree : Tracer::automatic;
}

}  // namespace

std::string antialiasing_in_words(const scene::Scene& scene) {
    const scene::RenderSettings& settings = scene.settings;
    if (scene::follows_paths(scene)) {
        return fmt::format("{} samples a pixel", settings.spp);
    }
    if (settings.antialiasing == scene::Antialiasing::adaptive) {
        return fmt::format("adaptive, threshold {}, depth {}", settings.adaptive_threshold, settings.adaptive_depth);
    }
    return fmt::format("{0} x {0} samples a pixel", settings.ssaa);
}

void apply_arguments(scene::Scene& scene, const RenderArguments& arguments, Diagnostics& diagnostics) {
    scene::RenderSettings& settings = scene.settings;
    if (arguments.size) {
        settings.width = arguments.size->width;
        settings.height = arguments.size->height;
    }
    settings.integrator = arguments.integrator.value_or(settings.integrator);
    if (arguments.bounces) {
        settings.bounces = arguments.bounces;
    }
    const auto limit = [](std::optional<int>& setting, const std::optional<int>& argument) { setting = argument ? argument : setting; };
    limit(settings.diffuse_bounces, arguments.diffuse_bounces);
    limit(settings.glossy_bounces, arguments.glossy_bounces);
    limit(settings.transmission_bounces, arguments.transmission_bounces);
    if (arguments.direct_samples) {
        settings.direct_samples = *arguments.direct_samples == "emitter" ? scene::DirectSamples::emitter
                                  : *arguments.direct_samples == "bsdf"  ? scene::DirectSamples::bsdf
                                                                         : scene::DirectSamples::mis;
    }
    settings.spp = arguments.spp.value_or(settings.spp);
    settings.seed = arguments.seed.value_or(settings.seed);
    settings.rgb = settings.rgb || arguments.rgb;
    settings.ssaa = arguments.ssaa.value_or(settings.ssaa);
    settings.adaptive_threshold = arguments.adaptive_threshold.value_or(settings.adaptive_threshold);
    settings.adaptive_depth = arguments.adaptive_depth.value_or(settings.adaptive_depth);
    settings.exposure = arguments.exposure.value_or(settings.exposure);
    settings.view = arguments.view.value_or(settings.view);
    settings.spectral_bins = arguments.spectral_bins.value_or(settings.spectral_bins);
    settings.wide = settings.wide || arguments.wide;
    if (!arguments.aovs.empty()) {
        settings.aovs = arguments.aovs;
    }

    // Who speaks of one kind of anti-aliasing wants that kind.
    const bool speaks_of_adaptive = arguments.adaptive_threshold || arguments.adaptive_depth;
    if (arguments.antialiasing) {
        settings.antialiasing = *arguments.antialiasing == "adaptive" ? scene::Antialiasing::adaptive : scene::Antialiasing::uniform;
        if (*arguments.antialiasing == "adaptive" && arguments.ssaa) {
            diagnostics.note({}, "--ssaa is for --aa uniform and has no effect here");
        } else if (*arguments.antialiasing == "uniform" && speaks_of_adaptive) {
            diagnostics.note({}, "--adaptive-threshold and --adaptive-depth are for --aa adaptive and have no effect here");
        }
    } else if (speaks_of_adaptive && arguments.ssaa) {
        diagnostics.error({}, "--ssaa is for uniform anti-aliasing and --adaptive-... for adaptive: say which with --aa");
    } else if (speaks_of_adaptive) {
        settings.antialiasing = scene::Antialiasing::adaptive;
    } else if (arguments.ssaa) {
        settings.antialiasing = scene::Antialiasing::uniform;
    }

    if (arguments.camera) {
        choose_camera(scene, *arguments.camera, diagnostics);
    }
    if (!arguments.lights.empty()) {
        choose_lights(scene, arguments.lights, diagnostics);
    }
}

std::optional<Prepared> prepare(scene::Scene scene, const RenderArguments& arguments, const std::string& command,
                                Diagnostics& diagnostics) {
    apply_arguments(scene, arguments, diagnostics);
    if (diagnostics.has_errors()) {
        return std::nullopt;
    }
    if (static_cast<long long>(scene.settings.width) * scene.settings.height > max_pixels) {
        diagnostics.error({scene.file, 0, 0}, fmt::format("a picture of {} x {} pixels: expected at most {} million pixels",
                                                          scene.settings.width, scene.settings.height, max_pixels / 1000000));
        return std::nullopt;
    }
    PictureContents contents = contents_of(scene, diagnostics);
    add_goals(scene, arguments, contents, diagnostics);
    const std::shared_ptr<const World> world = compile_world(scene, scene.cameras.front(), diagnostics);
    if (world == nullptr || diagnostics.has_errors()) {
        return std::nullopt;
    }

    Prepared prepared;
    prepared.options.width = scene.settings.width;
    prepared.options.height = scene.settings.height;
    prepared.options.threads = arguments.threads.value_or(hardware_threads());
    prepared.options.spp = scene::follows_paths(scene) ? samples_wanted(scene, arguments) : 0;
    prepared.options.intervals = contents.runs;
    prepared.options.goal.error = arguments.error.value_or(0.0);
    prepared.options.goal.confidence = contents.confidence;
    prepared.options.seconds = arguments.seconds.value_or(0.0);
    prepared.options.ssaa = scene.settings.ssaa;
    prepared.options.adaptive = scene.settings.antialiasing == scene::Antialiasing::adaptive;
    prepared.options.adaptive_threshold = scene.settings.adaptive_threshold;
    prepared.options.adaptive_depth = scene.settings.adaptive_depth;
    prepared.options.exposure = scene.settings.exposure;
    prepared.options.shuffle = 1;  // so that the time left is not guessed from the sky alone

    prepared.view = ViewTransform(find_view(scene.settings.view).value_or(View::srgb), scene.settings.exposure);
    prepared.contents = contents;
    if (layers_for(contents).ids) {
        prepared.names = names_of(*world);
    }
    prepared.world = world;
    prepared.threads = prepared.options.threads;

    CpuOptions cpu;
    cpu.tracer = tracer_named(arguments.trace);
    cpu.threads = prepared.options.threads;
    prepared.device = make_cpu_device(world, cpu);
    prepared.metadata = describe(scene, arguments, command);
    if (prepared.options.intervals) {
        prepared.options.goal = plan_goal(*prepared.device, prepared.options);
        prepared.contents.floor = prepared.options.goal.floor;
    }
    prepared.scene = std::move(scene);
    return prepared;
}

std::string render_command(const std::string& scene_file, const RenderArguments& arguments) {
    std::vector<std::string> words = {"lancer", "render", scene_file};
    const std::vector<std::string> options = words_of(arguments);
    words.insert(words.end(), options.begin(), options.end());
    return shell_quoted(words);
}

}  // namespace lancer::app
