// lancer import FILE --report
#include <memory>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "lancer/app/cli/command_line.h"
#include "lancer/app/cli/import_arguments.h"
#include "lancer/app/exit_status.h"
#include "lancer/import/import.h"

namespace lancer::app {

namespace {

const char* word(Treatment treatment) {
    switch (treatment) {
        case Treatment::honoured:
            return "honoured";
        case Treatment::approximated:
            return "approximated";
        case Treatment::dropped:
            break;
    }
    return "dropped";
}

void print_text(const ImportReport& report) {
    for (const Treatment treatment : {Treatment::honoured, Treatment::approximated, Treatment::dropped}) {
        for (const ImportEntry& entry : report.entries()) {
            if (entry.treatment == treatment) {
                const std::string times = entry.count > 1 ? fmt::format(" ({} times)", entry.count) : "";
                const std::string how = entry.how.empty() ? "" : ": " + entry.how;
                fmt::print("{:<13}{}{}{}\n", word(treatment), entry.feature, times, how);
                if (treatment != Treatment::honoured) {
                    fmt::print("{:<13}at {}\n", "", to_string(entry.first));
                }
            }
        }
    }
    const std::string all = summary(report);
    fmt::print("{}\n", all.empty() ? "Our own notation: all of it is honoured, or it is an error" : all);
}

nlohmann::ordered_json to_json(const ImportReport& report, const Diagnostics& diagnostics) {
    nlohmann::ordered_json json = {{"features", nlohmann::ordered_json::array()}, {"messages", nlohmann::ordered_json::array()}};
    for (const ImportEntry& entry : report.entries()) {
        nlohmann::ordered_json one = {{"feature", entry.feature}, {"treatment", word(entry.treatment)},       {"how", entry.how},
                                      {"count", entry.count},     {"changes_picture", entry.changes_picture}, {"file", entry.first.file}};
        if (entry.first.line > 0) {
            one["line"] = entry.first.line;
            one["column"] = entry.first.column;
        } else if (entry.first.byte >= 0) {
            one["byte"] = entry.first.byte;
        }
        json["features"].push_back(std::move(one));
    }
    for (const Diagnostic& diagnostic : diagnostics.list()) {
        json["messages"].push_back(to_string(diagnostic));
    }
    return json;
}

struct Arguments {
    std::string scene;
    bool report = false;
    bool json = false;
    ImportOptions options;
};

int show_import(const Arguments& arguments) {
    Diagnostics diagnostics;
    ImportReport report;
    const bool opened = import_scene(arguments.scene, arguments.options, report, diagnostics).has_value();
    if (arguments.json) {
        fmt::print("{}\n", to_json(report, diagnostics).dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
    } else {
        print_diagnostics(diagnostics);
        if (opened && arguments.report) {
            print_text(report);
        } else if (opened) {
            const std::string all = summary(report);
            fmt::print("{} can be read{}\n", arguments.scene, all.empty() ? "" : ": " + all);
        }
    }
    return opened ? exit_done : exit_bad_input;
}

}  // namespace

void add_import(CLI::App& program, Work& work) {
    CLI::App* app = program.add_subcommand("import", "Read a scene and tell what became of each thing in it");
    const auto arguments = std::make_shared<Arguments>();
    app->add_option("SCENE", arguments->scene, scene_argument_help())->type_name("");
    app->add_flag("--report", arguments->report, "Each feature that the file uses: honoured, approximated (how) or dropped (why, where)");
    app->add_flag("--json", arguments->json, "The same for programs");
    add_import_options(*app, arguments->options);
    app->footer("Example:\n  lancer import scene.gltf --report");
    app->callback([app, arguments, &work] {
        work = [app, arguments]() -> int {
            return arguments->scene.empty() ? refuse("which scene? For example: lancer import scene.gltf --report", *app)
                                            : show_import(*arguments);
        };
    });
}

}  // namespace lancer::app
