// What can be said on the command line about how a scene file is read.
#pragma once

#include <string>
#include <vector>

#include "lancer/base/diagnostic.h"
#include "lancer/import/import.h"

namespace CLI {
class App;
}  // namespace CLI

namespace lancer::app {

void add_import_options(CLI::App& app, ImportOptions& options);

// As words of a command line, without those that say nothing new.
std::vector<std::string> words_of(const ImportOptions& options);

// For whoever renders: one line that sums the report up, and a warning for each thing that was dropped and changes the picture.
void tell_report(const ImportReport& report, const std::string& file, Diagnostics& diagnostics);

// ", a .toml, .obj or .ply file" and the like, for help texts.
std::string scene_argument_help();

}  // namespace lancer::app
