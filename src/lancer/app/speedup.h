// How much faster more threads are.
#pragma once

#include <atomic>
#include <functional>
#include <vector>

#include "lancer/app/prepare.h"

namespace lancer::app {

struct Timing {
    int threads = 0;
    double seconds = 0.0;  // the fastest of the tries
    std::uint64_t rays = 0;
};

// 1, 2, 3, ... threads; beyond 16 only some, and always the last.
std::vector<int> thread_counts(int last);

// Renders the picture `tries` times; `told` hears after each try. Fewer timings when cancelled.
std::vector<Timing> time_threads(const Prepared& prepared, const std::vector<int>& thread_counts, int tries,
                                 const std::function<void(int threads)>& told, const std::atomic<bool>& cancel);

}  // namespace lancer::app
