// lancer view SCENE
#include <memory>

#include <CLI/CLI.hpp>

#include "lancer/app/cli/command_line.h"
#include "lancer/app/cli/import_arguments.h"
#include "lancer/app/window/show.h"

namespace lancer::app {

void add_view(CLI::App& program, Work& work) {
    struct Arguments {
        std::string scene;
        RenderArguments render;
    };
    CLI::App* app = program.add_subcommand("view", "Show a scene in a window: S saves lancer.png, Esc closes");
    const auto arguments = std::make_shared<Arguments>();
    app->add_option("SCENE", arguments->scene, scene_argument_help())->type_name("");
    add_render_options(*app, arguments->render);
    app->footer(
        "Where there is no display the picture is written to lancer.png instead.\n\n"
        "Example:\n  lancer view scenes/report/figure-1.toml --camera low-angle --aa adaptive");
    app->callback([app, arguments, &work] {
        work = [app, arguments]() -> int {
            if (arguments->scene.empty()) {
                return refuse("which scene? For example: lancer view scene.toml", *app);
            }
            return show_scene(arguments->scene, arguments->render);
        };
    });
}

}  // namespace lancer::app
