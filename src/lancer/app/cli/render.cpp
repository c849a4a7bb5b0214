// lancer render SCENE -o out.png
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "lancer/app/cli/command_line.h"
#include "lancer/app/cli/import_arguments.h"
#include "lancer/app/cli/interrupt.h"
#include "lancer/app/cli/outputs.h"
#include "lancer/app/cli/progress.h"
#include "lancer/app/exit_status.h"
#include "lancer/app/prepare.h"
#include "lancer/base/failure.h"
#include "lancer/image/replace_file.h"
#include "lancer/import/import.h"
#include "lancer/scene/integrator.h"

namespace lancer::app {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

struct Arguments {
    std::vector<std::string> files;  // the scene, and pictures that follow an -o
    std::vector<std::string> outputs;
    std::optional<std::string> sample_map;
    std::optional<std::string> stats;
    std::optional<std::string> progress;
    bool quiet = false;
    RenderArguments render;
};

struct Times {  // seconds
    double load = 0.0;
    double prepare = 0.0;
    double render = 0.0;
    double write = 0.0;
    double processor = 0.0;  // of all threads, while rendering
};

nlohmann::ordered_json bad_samples_json(const BadSamples& bad, const World& world);

nlohmann::ordered_json statistics_json(const Prepared& prepared, const RenderStatistics& done, const Times& times,
                                       const std::vector<std::string>& written) {
    return {
        {"version", LANCER_VERSION},
        {"command", prepared.metadata.at("lancer:command")},
        {"scene", prepared.scene.file},
        {"hash", prepared.scene.hash},
        {"width", prepared.options.width},
        {"height", prepared.options.height},
        {"antialiasing", prepared.metadata.at("lancer:antialiasing")},
        {"device", prepared.device->description()},
        {"threads", done.threads},
        {"finished", done.finished},
        {"samples", done.samples},
        {"rays",
         {{"camera", done.rays.camera}, {"secondary", done.rays.secondary}, {"shadow", done.rays.shadow}, {"total", done.rays.total()}}},
        {"rays_per_second", static_cast<double>(done.rays.total()) / std::max(times.render, 1e-9)},
        {"pixels_that_are_not_numbers", done.bad_pixels},
        {"bad_samples", bad_samples_json(done.bad_samples, *prepared.world)},
        {"seconds", {{"load", times.load}, {"prepare", times.prepare}, {"render", times.render}, {"write", times.write}}},
        {"processor_seconds", times.processor},
        {"written", written},
    };
}

// Writes what can be written, even after one file failed. False when any did.
bool write_all(const Arguments& arguments, const Prepared& prepared, const Film& film, const FilmSums* sums,
               std::vector<std::string>& written) {
    bool complete = true;
    const auto attempt = [&](const std::string& path, const auto& write) {
        try {
            write();
            written.push_back(path);
        } catch (const MachineFailure& failure) {
            fmt::print(stderr, "lancer: error: {}\n", failure.what());
            complete = false;
        }
    };
    for (const std::string& path : arguments.outputs) {
        attempt(path, [&] { write_film(path, film, prepared, sums); });
    }
    if (arguments.sample_map) {
        attempt(*arguments.sample_map, [&] { write_sample_map(*arguments.sample_map, film, prepared.metadata); });
    }
    return complete;
}

std::string summary(const Prepared& prepared, const RenderStatistics& done, const Times& times, const std::vector<std::string>& written) {
    const std::string work = fmt::format("{}x{} in {} ({}, {} a second, {} {}; {})", prepared.options.width, prepared.options.height,
                                         in_words(times.render), with_prefix(static_cast<double>(done.samples), "samples"),
                                         with_prefix(static_cast<double>(done.rays.total()) / std::max(times.render, 1e-9), "rays"),
                                         done.threads, done.threads == 1 ? "thread" : "threads", prepared.device->description());
    const std::string files = written.empty() ? "Nothing" : fmt::format("{}", fmt::join(written, ", "));
    const std::uint64_t bad = done.bad_samples.count();
    const std::string without = bad == 0 ? "" : fmt::format("; without {} bad {}", bad, bad == 1 ? "sample" : "samples");
    return done.finished ? fmt::format("{} written: {}{}", files, work, without)
                         : fmt::format("Stopped; {} written as far as it came: {}", files, work);
}

// Positional words beside the scene are pictures: `-o out.exr out.png`.
std::optional<std::string> sort_files(Arguments& arguments) {
    std::vector<std::string> scenes;
    for (const std::string& file : arguments.files) {
        if (is_picture(file) && !arguments.outputs.empty()) {
            arguments.outputs.push_back(file);
        } else {
            scenes.push_back(file);
        }
    }
    if (scenes.empty()) {
        return "which scene? For example: lancer render scene.toml -o picture.png";
    }
    if (scenes.size() > 1) {
        return fmt::format("one scene at a time, not {}", fmt::join(scenes, " and "));
    }
    if (arguments.outputs.empty()) {
        return fmt::format("where shall the picture go? For example: -o picture.png");
    }
    arguments.files = scenes;
    return std::nullopt;
}

void print_aovs() {
    for (const AovKind& kind : aov_kinds()) {
        fmt::print("{:<12} {:<22} {}\n", kind.name, kind.channels, kind.help);
    }
}

// What only EXR files can hold needs one.
void check_contents(const Arguments& arguments, const PictureContents& contents, Diagnostics& diagnostics) {
    const bool has_more = !contents.aovs.empty() || contents.spectral_bins > 0;
    if (!has_more || std::any_of(arguments.outputs.begin(), arguments.outputs.end(), holds_layers)) {
        return;
    }
    const std::string sentence = "only EXR files hold AOVs and spectra, and none is written: name one, such as -o picture.exr";
    if (!arguments.render.aovs.empty() || arguments.render.spectral_bins) {
        diagnostics.error({}, sentence);
    } else {
        diagnostics.warning({}, sentence);
    }
}

const char* in_words(PathFault::What what) {
    switch (what) {
        case PathFault::What::not_a_number:
            return "not a number";
        case PathFault::What::infinite:
            return "infinite";
        case PathFault::What::negative:
            return "negative";
        case PathFault::What::none:
            break;
    }
    return "wrong";
}

std::string where(const PathFault& fault, const World& world) {
    return fault.object < 0
               ? std::string("from the surroundings")
               : fmt::format("at vertex {}, on the {} \"{}\" of material \"{}\"", fault.vertex + 1, world.object_kind(fault.object),
                             world.object_name(fault.object), world.material_name(fault.material));
}

void report_bad_samples(const BadSamples& bad, const World& world) {
    if (bad.count() == 0) {
        return;
    }
    fmt::print(stderr, "lancer: warning: the light of {} was not a number, infinite or negative; the picture is made without {}\n",
               bad.count() == 1 ? "1 sample" : fmt::format("{} samples", bad.count()), bad.count() == 1 ? "it" : "them");
    for (const BadSample& sample : bad.first()) {
        fmt::print(stderr, "  pixel ({}, {}), sample {}: {} {}\n", sample.x, sample.y, sample.sample, in_words(sample.fault.what),
                   where(sample.fault, world));
    }
    if (bad.count() > bad.first().size()) {
        fmt::print(stderr, "  and {} more\n", bad.count() - bad.first().size());
    }
}

nlohmann::ordered_json bad_samples_json(const BadSamples& bad, const World& world) {
    nlohmann::ordered_json first = nlohmann::ordered_json::array();
    for (const BadSample& sample : bad.first()) {
        first.push_back({{"x", sample.x},
                         {"y", sample.y},
                         {"sample", sample.sample},
                         {"what", in_words(sample.fault.what)},
                         {"vertex", sample.fault.vertex + 1},
                         {"object", sample.fault.object < 0 ? "" : world.object_name(sample.fault.object)},
                         {"kind", sample.fault.object < 0 ? "" : world.object_kind(sample.fault.object)},
                         {"material", sample.fault.object < 0 ? "" : world.material_name(sample.fault.material)}});
    }
    return {{"count", bad.count()}, {"first", first}};
}

int render_scene(const CLI::App& app, Arguments arguments) {
    if (arguments.render.aovs == std::vector<std::string>{"list"}) {
        print_aovs();
        return exit_done;
    }
    if (const auto sentence = sort_files(arguments)) {
        return refuse(*sentence, app);
    }
    const std::atomic<bool>& interrupted = interrupt_flag();
    // Whatever is wrong is said before anything is rendered or written.
    const std::string& file = arguments.files.front();
    Diagnostics diagnostics;
    check_pictures(arguments.outputs, "-o", diagnostics);
    if (arguments.sample_map) {
        check_pictures({*arguments.sample_map}, "--sample-map", diagnostics);
    }
    if (arguments.stats) {
        check_file(*arguments.stats, "--stats", diagnostics);
    }
    Times times;
    const auto load_start = Clock::now();
    ImportReport report;
    std::optional<scene::Scene> scene = import_scene(file, arguments.render.import, report, diagnostics);
    tell_report(report, file, diagnostics);
    times.load = seconds_since(load_start);
    const auto prepare_start = Clock::now();
    std::optional<Prepared> prepared;
    if (scene && !diagnostics.has_errors()) {
        prepared = prepare(std::move(*scene), arguments.render, render_command(file, arguments.render), diagnostics);
    }
    times.prepare = seconds_since(prepare_start);
    if (prepared) {
        check_contents(arguments, prepared->contents, diagnostics);
    }
    print_diagnostics(diagnostics, arguments.quiet);
    if (!prepared || diagnostics.has_errors()) {
        return exit_bad_input;
    }

    const ProgressStyle style = choose_progress(arguments.progress, arguments.quiet);
    if (prepared->scene.settings.integrator == "auto" && scene::follows_paths(prepared->scene) && !arguments.quiet &&
        style != ProgressStyle::json) {
        const scene::IntegratorChoice choice = scene::choose_integrator(prepared->scene);
        fmt::print("Light is followed by {}, because {}\n", choice.name, choice.why);
    }
    Film film(prepared->options.width, prepared->options.height);
    std::optional<FilmSums> sums;
    if (!prepared->contents.is_plain()) {
        FilmLayers layers = layers_for(prepared->contents);
        layers.splats = prepared->device->makes_splats();
        sums.emplace(film.width, film.height, layers);
    }
    RenderProgressPrinter printer(style, file);
    const std::clock_t processor_start = std::clock();
    const RenderStatistics done = render(*prepared->device, prepared->options, film, &printer, &interrupted, sums ? &*sums : nullptr);
    printer.clear();
    times.render = done.seconds;
    times.processor = static_cast<double>(std::clock() - processor_start) / CLOCKS_PER_SEC;
    report_bad_samples(done.bad_samples, *prepared->world);
    if (done.bad_pixels > 0) {
        fmt::print(stderr, "lancer: warning: {} of the picture {} not a number; the first is at ({}, {}), counted from the upper left\n",
                   done.bad_pixels == 1 ? "1 pixel" : fmt::format("{} pixels", done.bad_pixels), done.bad_pixels == 1 ? "is" : "are",
                   done.bad_x, done.bad_y);
    }

    const auto write_start = Clock::now();
    std::vector<std::string> written;
    bool complete = write_all(arguments, *prepared, film, sums ? &*sums : nullptr, written);
    times.write = seconds_since(write_start);
    const nlohmann::ordered_json statistics = statistics_json(*prepared, done, times, written);
    if (arguments.stats) {
        try {
            replace_file(*arguments.stats, statistics.dump(2) + "\n");
        } catch (const MachineFailure& failure) {
            fmt::print(stderr, "lancer: error: {}\n", failure.what());
            complete = false;
        }
    }
    if (style == ProgressStyle::json) {
        fmt::print(stderr, "{}\n", nlohmann::ordered_json{{"event", "done"}, {"statistics", statistics}}.dump());
    } else if (!arguments.quiet) {
        fmt::print("{}\n", summary(*prepared, done, times, written));
    }
    return !complete ? exit_machine_failed : done.finished ? exit_done : exit_stopped;
}

}  // namespace

void add_render(CLI::App& program, Work& work) {
    CLI::App* app = program.add_subcommand("render", "Render a scene into picture files, without a window");
    const auto arguments = std::make_shared<Arguments>();
    app->add_option("SCENE", arguments->files, scene_argument_help())->type_name("");
    app->add_option("-o,--output", arguments->outputs, "Where the picture goes: .png .jpg .exr .hdr or .tif; may be given several times")
        ->type_name("FILE")
        ->allow_extra_args(false);
    add_text(*app, "--sample-map", arguments->sample_map, "FILE", "A second picture: how many samples each pixel took, bright where many");
    add_text(*app, "--stats", arguments->stats, "FILE", "Numbers about the render, as JSON");
    add_choice(*app, "--progress", arguments->progress, {"bar", "plain", "json"}, "How progress is told, on standard error");
    app->add_flag("--quiet", arguments->quiet, "Say nothing but warnings and errors");
    add_render_options(*app, arguments->render);
    add_file_options(*app, arguments->render);
    app->footer("Example:\n  lancer render scenes/report/figure-1.toml --size 1920x1080 --ssaa 4 -o figure-1.png -o figure-1.exr");
    app->callback([app, arguments, &work] { work = [app, arguments] { return render_scene(*app, *arguments); }; });
}

}  // namespace lancer::app
