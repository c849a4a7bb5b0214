// lancer figures: all pictures of the report and what came since, into one folder, with a page that shows them.
#pragma once

#include <optional>
#include <string>

#include "lancer/app/figures/table.h"

namespace lancer::app {

// Makes the folder where it is missing. Returns the exit status; throws MachineFailure.
int write_figures(const std::string& folder, const std::optional<int>& threads, const std::optional<std::string>& progress, bool quiet);

// What makes the figure again in the folder of the figures.
std::string figure_command(const Figure& figure);

}  // namespace lancer::app
