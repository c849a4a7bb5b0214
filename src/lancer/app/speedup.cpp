#include "lancer/app/speedup.h"

#include <algorithm>

namespace lancer::app {

std::vector<int> thread_counts(int last) {
    std::vector<int> counts;
    for (int threads = 1; threads < last; threads += std::max(1, threads / 8)) {
        counts.push_back(threads);
    }
    counts.push_back(last);
    return counts;
}

std::vector<Timing> time_threads(const Prepared& prepared, const std::vector<int>& thread_counts, int tries,
                                 const std::function<void(int threads)>& told, const std::atomic<bool>& cancel) {
    Film film(prepared.options.width, prepared.options.height);
    std::vector<Timing> timings;
    for (const int threads : thread_counts) {
        RenderOptions options = prepared.options;
        options.threads = threads;
        Timing timing{threads, 0.0, 0};
        for (int i = 0; i < tries; ++i) {
            const RenderStatistics done = render(*prepared.device, options, film, nullptr, &cancel);
            if (!done.finished) {
                return timings;
            }
            timing.seconds = i == 0 ? done.seconds : std::min(timing.seconds, done.seconds);
            timing.rays = done.rays.total();
            told(threads);
        }
        timings.push_back(timing);
    }
    return timings;
}

}  // namespace lancer::app
