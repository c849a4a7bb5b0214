// Times of a render over the number of threads, as a plot.
#pragma once

#include <vector>

#include "lancer/app/figures/drawing.h"
#include "lancer/app/speedup.h"

namespace lancer::app {

// At least one timing; the first one, with one thread, is what the others are compared to.
Drawing plot_speedup(const std::vector<Timing>& timings);

}  // namespace lancer::app
