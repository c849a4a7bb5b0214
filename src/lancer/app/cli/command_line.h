// The whole command line: subcommands, help, and what is said when it can't be understood.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lancer/base/diagnostic.h"

namespace CLI {
class App;
}  // namespace CLI

namespace lancer::app {

// What was asked for. Each subcommand puts its work here when it is chosen; the result is an exit status.
using Work = std::function<int()>;

// Reads the words after the program's name and does what they ask. Returns the exit status; throws MachineFailure.
int run_command_line(const std::vector<std::string>& words);

// Subcommands, each in its own file. `work` must outlive `program`.
void add_view(CLI::App& program, Work& work);
void add_render(CLI::App& program, Work& work);
void add_info(CLI::App& program, Work& work);
void add_import(CLI::App& program, Work& work);
void add_convert(CLI::App& program, Work& work);
void add_compare(CLI::App& program, Work& work);
void add_figures(CLI::App& program, Work& work);
void add_schema(CLI::App& program, Work& work);
void add_bench(CLI::App& program, Work& work);
void add_resume(CLI::App& program, Work& work);
void add_merge(CLI::App& program, Work& work);
void add_reproduce(CLI::App& program, Work& work);

// Prints what is wrong and where help is; returns the exit status.
int refuse(const std::string& sentence, const CLI::App& app);

// One line a message, on standard error. `quiet` leaves notes out.
void print_diagnostics(const Diagnostics& diagnostics, bool quiet = false);

}  // namespace lancer::app
