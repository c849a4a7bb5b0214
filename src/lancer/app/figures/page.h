// The page that shows all figures.
#pragma once

#include <string>
#include <vector>

#include "lancer/app/speedup.h"

namespace lancer::app {

// HTML that stands beside the pictures; `timings` may be empty.
std::string figures_page(const std::vector<Timing>& timings);

}  // namespace lancer::app
