#include "lancer/app/cli/import_arguments.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "lancer/app/cli/values.h"

namespace lancer::app {

void add_import_options(CLI::App& app, ImportOptions& options) {
    constexpr const char* group = "Reading the scene";
    app.add_option_function<std::vector<std::string>>(
           "-D,--define",
           [&options](const std::vector<std::string>& words) {
               for (const std::string& word : words) {
                   const std::size_t equals = word.find('=');
                   if (equals == 0 || equals == std::string::npos) {
                       throw CLI::ValidationError(fmt::format("-D {}: expected NAME=VALUE", word));
                   }
                   options.defines[word.substr(0, equals)] = word.substr(equals + 1);
               }
           },
           "A value for a $parameter of the scene (Mitsuba)")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false)
        ->group(group);
    app.add_option("--frame", options.frame, "The moment of the scene's animations, in seconds (glTF)")->type_name("SECONDS")->group(group);
    app.add_option("--variant", options.variant, "Which of the scene's sets of materials (glTF)")->type_name("NAME")->group(group);
    app.add_option("--scene", options.scene, "Which of the file's scenes, by name or number from 0 (glTF)")
        ->type_name("NAME")
        ->group(group);
    app.add_option_function<std::string>(
           "--missing-textures",
           [&options](const std::string& word) {
               if (word != "error" && word != "magenta") {
                   throw CLI::ValidationError(fmt::format("--missing-textures {}: expected error or magenta", word));
               }
               options.magenta_textures = word == "magenta";
           },
           "What pictures that are missing are: an error (as without this), or magenta")
        ->type_name("error|magenta")
        ->group(group);
    app.add_flag("--sandbox", options.sandbox, "Open no file outside the scene's folder: for scenes from strangers")->group(group);
}

std::vector<std::string> words_of(const ImportOptions& options) {
    std::vector<std::string> words;
    const auto add = [&](const char* name, const std::string& value) {
        words.emplace_back(name);
        words.push_back(value);
    };
    for (const auto& [name, value] : options.defines) {
        add("-D", name + "=" + value);
    }
    if (options.frame != 0.0) {
        add("--frame", fmt::format("{}", options.frame));
    }
    if (!options.variant.empty()) {
        add("--variant", options.variant);
    }
    if (!options.scene.empty()) {
        add("--scene", options.scene);
    }
    if (options.magenta_textures) {
        add("--missing-textures", "magenta");
    }
    return words;
}

void tell_report(const ImportReport& report, const std::string& file, Diagnostics& diagnostics) {
    if (const std::string all = summary(report); !all.empty()) {
        diagnostics.note({file, 0, 0}, all);
    }
    for (const ImportEntry& entry : report.entries()) {
        if (entry.treatment == Treatment::dropped && entry.changes_picture) {
            diagnostics.warning(entry.first, fmt::format("{} is left out: {}", entry.feature, entry.how));
        }
    }
}

std::string scene_argument_help() {
    const std::vector<std::string> endings = scene_endings();
    std::string list;
    for (std::size_t i = 0; i < endings.size(); ++i) {
        list += (i == 0 ? "" : i + 1 == endings.size() ? " or " : ", ") + endings[i];
    }
    return "The scene: a " + list + " file";
}

}  // namespace lancer::app
