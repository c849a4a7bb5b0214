// lancer convert SCENE -o scene.toml
#include <filesystem>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "lancer/app/cli/command_line.h"
#include "lancer/app/cli/import_arguments.h"
#include "lancer/app/exit_status.h"
#include "lancer/base/file.h"
#include "lancer/image/replace_file.h"
#include "lancer/import/import.h"

namespace lancer::app {

namespace {

struct Arguments {
    std::string scene;
    std::string output;
    bool quiet = false;
    ImportOptions options;
};

bool is_same_file(const std::string& a, const std::string& b) {
    std::error_code problem;
    return std::filesystem::equivalent(a, b, problem) && !problem;
}

std::string size_in_words(std::size_t bytes) {
    const double number = static_cast<double>(bytes);
    return number < 1e6 ? fmt::format("{:.1f} kB", number / 1e3) : fmt::format("{:.1f} MB", number / 1e6);
}

int convert_scene(const Arguments& arguments) {
    Diagnostics diagnostics;
    if (file_ending(arguments.output) != ".toml") {
        diagnostics.error({}, fmt::format("-o {}: our notation is written into a .toml file", arguments.output));
    } else if (is_same_file(arguments.scene, arguments.output)) {
        diagnostics.error({}, fmt::format("-o {}: this is the scene itself; choose another name", arguments.output));
    }
    ImportReport report;
    const auto scene = diagnostics.has_errors() ? std::nullopt : import_scene(arguments.scene, arguments.options, report, diagnostics);
    tell_report(report, arguments.scene, diagnostics);
    if (scene && scene->objects.empty() && scene->placements.empty()) {
        diagnostics.error({arguments.scene, 0, 0}, "there is nothing to see in this scene, and nothing to write");
    }
    print_diagnostics(diagnostics, arguments.quiet);
    if (!scene || diagnostics.has_errors()) {
        return exit_bad_input;
    }
    const WrittenScene written = write_toml(*scene, arguments.output);
    const std::filesystem::path folder = std::filesystem::path(arguments.output).parent_path();
    std::string beside;
    // The scene comes last: who reads it finds what it names.
    if (!written.mesh_file.empty()) {
        replace_file((folder / written.mesh_file).string(), written.meshes);
        beside += fmt::format(", {} ({})", written.mesh_file, size_in_words(written.meshes.size()));
    }
    for (const WrittenScene::Picture& picture : written.pictures) {
        replace_file((folder / picture.name).string(), *picture.bytes);
        beside += ", " + picture.name;
    }
    replace_file(arguments.output, written.toml);
    if (!arguments.quiet) {
        fmt::print("{} ({}){} written\n", arguments.output, size_in_words(written.toml.size()), beside);
    }
    return exit_done;
}

}  // namespace

void add_convert(CLI::App& program, Work& work) {
    CLI::App* app = program.add_subcommand("convert", "Write a scene of any format in our notation; it renders to the same picture");
    const auto arguments = std::make_shared<Arguments>();
    app->add_option("SCENE", arguments->scene, scene_argument_help())->type_name("");
    app->add_option("-o,--output", arguments->output, "Where it goes; meshes and pictures from within the scene are written beside it")
        ->type_name("FILE.toml");
    app->add_flag("--quiet", arguments->quiet, "Say nothing but warnings and errors");
    add_import_options(*app, arguments->options);
    app->footer("Example:\n  lancer convert scene.gltf -o scene.toml");
    app->callback([app, arguments, &work] {
        work = [app, arguments]() -> int {
            if (arguments->scene.empty()) {
                return refuse("which scene? For example: lancer convert scene.gltf -o scene.toml", *app);
            }
            if (arguments->output.empty()) {
                return refuse("where shall it go? For example: -o scene.toml", *app);
            }
            return convert_scene(*arguments);
        };
    });
}

}  // namespace lancer::app
