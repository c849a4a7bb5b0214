// lancer schema
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "lancer/app/cli/command_line.h"
#include "lancer/app/exit_status.h"
#include "lancer/import/import.h"

namespace lancer::app {

void add_schema(CLI::App& program, Work& work) {
    CLI::App* app = program.add_subcommand("schema", "Print the JSON Schema of the scene notation, for editors");
    app->footer("Example:\n  lancer schema > lancer.schema.json");
    app->callback([&work] {
        work = [] {
            fmt::print("{}\n", toml_schema());
            return exit_done;
        };
    });
}

}  // namespace lancer::app
