// lancer figures: all pictures of the report and what came since, into one folder, with a page that shows them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lancer/app/figures/table.h"

namespace lancer::app {

struct FiguresRequest {
    std::string folder = "figures";  // made where it is missing
    std::vector<std::string> only;   // by their ids, or "threads" for the speed-up; empty: all of them
    std::optional<int> threads;
    std::optional<std::string> progress;
    bool quiet = false;
};

// Returns the exit status; throws MachineFailure.
int write_figures(const FiguresRequest& request);

// What makes the figure again in the folder of the figures.
std::string figure_command(const Figure& figure);

}  // namespace lancer::app
