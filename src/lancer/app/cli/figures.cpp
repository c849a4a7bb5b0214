// lancer figures [FOLDER], the report's -render-all
#include "lancer/app/figures/figures.h"

#include <memory>

#include <CLI/CLI.hpp>

#include "lancer/app/cli/command_line.h"
#include "lancer/app/cli/render_arguments.h"

namespace lancer::app {

void add_figures(CLI::App& program, Work& work) {
    struct Arguments {
        std::string folder = "figures";
        std::optional<int> threads;
        std::optional<std::string> progress;
        bool quiet = false;
    };
    CLI::App* app = program.add_subcommand("figures", "Write every figure of the report, made anew, and a page that shows them");
    const auto arguments = std::make_shared<Arguments>();
    app->add_option("FOLDER", arguments->folder, "Where they go; made where it is missing")->type_name("")->capture_default_str();
    add_threads_option(*app, arguments->threads);
    add_choice(*app, "--progress", arguments->progress, {"bar", "plain", "json"}, "How progress is told, on standard error");
    app->add_flag("--quiet", arguments->quiet, "Say nothing but warnings and errors");
    app->footer("Example:\n  lancer figures figures");
    app->callback([arguments, &work] {
        work = [arguments] { return write_figures(arguments->folder, arguments->threads, arguments->progress, arguments->quiet); };
    });
}

}  // namespace lancer::app
