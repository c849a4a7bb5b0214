// The page that shows all figures.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lancer/app/figures/table.h"
#include "lancer/app/speedup.h"

namespace lancer::app {

// HTML that stands beside the pictures. Figures for which `is_made` is false, and timings where there are none, are left out.
std::string figures_page(const std::function<bool(const Figure&)>& is_made, const std::vector<Timing>& timings);

}  // namespace lancer::app
