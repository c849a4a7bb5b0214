#include "lancer/app/window/show.h"

#include <cstdio>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "lancer/app/cli/command_line.h"
#include "lancer/app/cli/import_arguments.h"
#include "lancer/app/cli/interrupt.h"
#include "lancer/app/cli/outputs.h"
#include "lancer/app/cli/progress.h"
#include "lancer/app/default_scene.h"
#include "lancer/app/exit_status.h"
#include "lancer/app/prepare.h"
#include "lancer/app/window/window.h"
#include "lancer/import/import.h"

namespace lancer::app {

namespace {

constexpr const char* save_as = "lancer.png";

int write_instead(const Prepared& prepared, const std::string& reason) {
    Diagnostics diagnostics;
    check_pictures({save_as}, "no display, so the picture goes to a file:", diagnostics);
    print_diagnostics(diagnostics);
    if (diagnostics.has_errors()) {
        return exit_machine_failed;
    }
    Film film(prepared.options.width, prepared.options.height);
    RenderProgressPrinter printer(choose_progress({}, false), prepared.scene.file);
    const RenderStatistics done = render(*prepared.device, prepared.options, film, &printer, &interrupt_flag());
    printer.clear();
    write_film(save_as, film, prepared);
    fmt::print("There is no display ({}): the picture{} was written to {}, {}x{} in {}.\n", reason,
               done.finished ? "" : ", as far as it came,", save_as, prepared.options.width, prepared.options.height,
               in_words(done.seconds));
    return done.finished ? exit_done : exit_stopped;
}

int show(std::optional<Prepared> prepared, const Diagnostics& diagnostics) {
    print_diagnostics(diagnostics);
    if (!prepared) {
        return exit_bad_input;
    }
    const Display display;
    if (!display.is_there()) {
        return write_instead(*prepared, display.reason());
    }
    const std::string name = std::filesystem::path(prepared->scene.file).filename().string();
    run_window(display, *prepared, "lancer, " + name, save_as);
    return exit_done;
}

}  // namespace

int show_default_scene(const std::optional<int>& threads) {
    Diagnostics diagnostics;
    std::optional<scene::Scene> scene = import_default_scene(diagnostics);
    RenderArguments arguments;
    arguments.threads = threads;
    std::optional<Prepared> prepared;
    if (scene) {
        const std::string command = render_command(scene->file, {});
        prepared = prepare(std::move(*scene), arguments, command, diagnostics);
    }
    return show(std::move(prepared), diagnostics);
}

int show_scene(const std::string& path, const RenderArguments& arguments) {
    Diagnostics diagnostics;
    ImportReport report;
    std::optional<scene::Scene> scene = import_scene(path, arguments.import, report, diagnostics);
    tell_report(report, path, diagnostics);
    std::optional<Prepared> prepared;
    if (scene) {
        prepared = prepare(std::move(*scene), arguments, render_command(path, arguments), diagnostics);
    }
    return show(std::move(prepared), diagnostics);
}

}  // namespace lancer::app
