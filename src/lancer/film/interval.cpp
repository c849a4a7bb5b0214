#include "lancer/film/interval.h"

#include <cmath>
#include <limits>

#include "lancer/image/probability.h"

namespace lancer {

namespace {

constexpr double heavy_share = 0.25;  // of the sum of squares, in one sample

// The t that is exceeded in size with chance 1 - confidence.
double student_quantile(double confidence, double freedom) {
    double low = 0.0, high = 1e6;
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        (student_two_sided(middle, freedom) > 1.0 - confidence ? low : high) = middle;
    }
    return high;
}

}  // namespace

IntervalRule::IntervalRule(double confidence) : quantile_(student_quantile(confidence, error_replicates - 1)) {}

Interval IntervalRule::of(const FilmSums& sums, std::size_t pixel) const {
    const ReplicateSums replicates = sums.replicates(pixel);
    Interval interval;
    interval.middle = replicates.mean();
    if (replicates.samples < error_replicates) {
        interval.half_width = std::numeric_limits<double>::infinity();
        return interval;
    }
    const double each = static_cast<double>(replicates.samples) / error_replicates;
    double middle = 0.0;
    for (const float sum : replicates.sums) {
        middle += static_cast<double>(sum);
    }
    middle /= error_replicates;
    double spread = 0.0;
    for (const float sum : replicates.sums) {
        const double off = static_cast<double>(sum) - middle;
        spread += off * off;
    }
    spread /= error_replicates - 1.0;
    interval.half_width = quantile_ * std::sqrt(spread / error_replicates) / each;
    const double largest = static_cast<double>(replicates.largest);
    interval.heavy = largest * largest > heavy_share * replicates.squares;
    return interval;
}

}  // namespace lancer
