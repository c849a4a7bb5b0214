// lancer figures [FOLDER], the report's -render-all
#include "lancer/app/figures/figures.h"

#include <memory>

#include <CLI/CLI.hpp>

#include "lancer/app/cli/command_line.h"
#include "lancer/app/cli/render_arguments.h"

namespace lancer::app {

void add_figures(CLI::App& program, Work& work) {
    CLI::App* app = program.add_subcommand("figures", "Write every figure of the report, made anew, and a page that shows them");
    const auto request = std::make_shared<FiguresRequest>();
    app->add_option("FOLDER", request->folder, "Where they go; made where it is missing")->type_name("")->capture_default_str();
    add_threads_option(*app, request->threads);
    add_choice(*app, "--progress", request->progress, {"bar", "plain", "json"}, "How progress is told, on standard error");
    app->add_flag("--quiet", request->quiet, "Say nothing but warnings and errors");
    app->add_option("--only", request->only, "Only these figures, by the names of their files; \"threads\" is the speed-up")
        ->type_name("NAME,NAME")
        ->delimiter(',')
        ->allow_extra_args(false);
    app->footer("Example:\n  lancer figures figures --only figure-1,prism,threads");
    app->callback([request, &work] { work = [request] { return write_figures(*request); }; });
}

}  // namespace lancer::app
