// lancer bench [SCENE]
#include <cstdio>
#include <memory>
#include <utility>

#include <unistd.h>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "lancer/app/cli/command_line.h"
#include "lancer/app/cli/interrupt.h"
#include "lancer/app/default_scene.h"
#include "lancer/app/exit_status.h"
#include "lancer/app/prepare.h"
#include "lancer/app/speedup.h"
#include "lancer/import/import.h"

namespace lancer::app {

namespace {

struct Arguments {
    std::string scene;
    std::optional<int> tries;
    RenderArguments render;
};

int bench(const Arguments& arguments) {
    Diagnostics diagnostics;
    std::optional<scene::Scene> scene =
        arguments.scene.empty() ? import_default_scene(diagnostics) : import_scene(arguments.scene, diagnostics);
    std::optional<Prepared> prepared;
    if (scene) {
        prepared = prepare(std::move(*scene), arguments.render, "", diagnostics);
    }
    print_diagnostics(diagnostics);
    if (!prepared) {
        return exit_bad_input;
    }
    const std::vector<int> counts = thread_counts(arguments.render.threads.value_or(hardware_threads()));
    const int tries = arguments.tries.value_or(3);
    fmt::print("{}, {}x{}, {}; {}; the fastest of {}\n", prepared->scene.file, prepared->options.width, prepared->options.height,
               prepared->metadata.at("lancer:antialiasing"), prepared->device->description(), tries);
    fmt::print("threads   seconds   times faster   M rays/s\n");
    std::fflush(stdout);
    const std::vector<Timing> timings = time_threads(
        *prepared, counts, tries, [](int) {}, interrupt_flag());
    for (const Timing& timing : timings) {
        fmt::print("{:7} {:9.3f} {:14.2f} {:10.1f}\n", timing.threads, timing.seconds, timings.front().seconds / timing.seconds,
                   1e-6 * static_cast<double>(timing.rays) / timing.seconds);
    }
    return timings.size() == counts.size() ? exit_done : exit_stopped;
}

}  // namespace

void add_bench(CLI::App& program, Work& work) {
    CLI::App* app = program.add_subcommand("bench", "Time a scene with 1, 2, ... threads");
    const auto arguments = std::make_shared<Arguments>();
    app->add_option("SCENE", arguments->scene, "The scene; the one of Figure 1 if not given")->type_name("");
    add_whole(*app, "--tries", arguments->tries, 1, 1000, "How often each is timed; the fastest counts");
    add_render_options(*app, arguments->render);
    app->footer("With --threads N it ends at N threads.\n\nExample:\n  lancer bench scenes/benchmark/whitted.toml --tries 5");
    app->callback([arguments, &work] { work = [arguments] { return bench(*arguments); }; });
}

}  // namespace lancer::app
