#include "lancer/image/significance.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "lancer/image/probability.h"

namespace lancer {
namespace {

// The variance of a sum of measured numbers and its freedom by Welch and Satterthwaite [Satterthwaite 1946].
class Pooled {
public:
    void add(double variance, double freedom) {
        variance_ += variance;
        if (std::isfinite(freedom) && variance > 0.0) {
            spread_ += variance * variance / freedom;
        }
    }
    double variance() const { return variance_; }
    double freedom() const { return spread_ > 0.0 ? variance_ * variance_ / spread_ : std::numeric_limits<double>::infinity(); }

private:
    double variance_ = 0.0;
    double spread_ = 0.0;
};

}  // namespace

bool is_finite(const NoisyChannel& channel, std::size_t pixel) {
    return std::all_of(channel.runs.begin(), channel.runs.end(), [pixel](const auto& run) { return std::isfinite(run[pixel]); }) &&
           (channel.variances.empty() || std::isfinite(channel.variances[pixel]));
}

double WelchTest::t() const {
    return error > 0.0 ? difference / error : difference == 0.0 ? 0.0 : std::copysign(std::numeric_limits<double>::infinity(), difference);
}

WelchTest welch_test(const Measured& a, const Measured& b) {
    Pooled pooled;
    pooled.add(a.variance, a.freedom);
    pooled.add(b.variance, b.freedom);
    WelchTest test{a.mean - b.mean, std::sqrt(pooled.variance()), pooled.freedom(), 1.0};
    test.p = student_two_sided(test.t(), test.freedom);
    return test;
}

Measured measure(const NoisyChannel& channel, int width, const Rectangle& rectangle, const std::vector<bool>& skip, std::uint64_t& count) {
    assert(!channel.runs.empty() && (channel.variances.empty() || channel.runs.size() == 1));
    const std::size_t runs = channel.runs.size();
    std::vector<double> sums(runs, 0.0);
    Pooled pixels;
    double rounding = 0.0;  // variance of the sums' mean
    count = 0;
    for (int y = rectangle.y0; y < rectangle.y1; ++y) {
        for (int x = rectangle.x0; x < rectangle.x1; ++x) {
            const std::size_t i = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
            if (!skip.empty() && skip[i]) {
                continue;
            }
            ++count;
            for (std::size_t run = 0; run < runs; ++run) {
                sums[run] += static_cast<double>(channel.runs[run][i]);
            }
            if (!channel.variances.empty()) {
                const double samples =
                    channel.samples.empty() ? std::numeric_limits<double>::infinity() : static_cast<double>(channel.samples[i]);
                pixels.add(std::max(0.0, static_cast<double>(channel.variances[i])), std::max(1.0, samples - 1.0));
            }
            const double step = channel.rounding * static_cast<double>(channel.runs[0][i]);
            rounding += step * step / 12.0;  // evenly spread over a step
        }
    }
    if (count == 0) {
        return {};
    }
    const double number = static_cast<double>(count), many = static_cast<double>(runs);
    Measured result;
    for (const double sum : sums) {
        result.mean += sum / number / many;
    }
    Pooled pooled;
    if (runs > 1) {
        double squares = 0.0;
        for (const double sum : sums) {
            const double d = sum / number - result.mean;
            squares += d * d;
        }
        pooled.add(squares / (many - 1.0) / many, many - 1.0);
    } else {
        pooled.add(pixels.variance() / (number * number), pixels.freedom());
    }
    pooled.add(rounding / (number * number), std::numeric_limits<double>::infinity());
    result.variance = pooled.variance();
    result.freedom = pooled.freedom();
    return result;
}

CellTests test_cells(const NoisyChannel& a, const NoisyChannel& b, int width, int height, int side) {
    std::vector<bool> skip(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (std::size_t i = 0; i < skip.size(); ++i) {
        skip[i] = !is_finite(a, i) || !is_finite(b, i);
    }
    CellTests result;
    result.side = side;
    double smallest_p = 2.0;
    std::uint64_t beyond = 0;
    for (int y = 0; y < height; y += side) {
        for (int x = 0; x < width; x += side) {
            const Rectangle cell{x, y, std::min(x + side, width), std::min(y + side, height)};
            std::uint64_t count_a = 0, count_b = 0;
            const Measured in_a = measure(a, width, cell, skip, count_a), in_b = measure(b, width, cell, skip, count_b);
            // Nothing can be learnt from two cells that are black in every run.
            if (count_a == 0 || (in_a.variance == 0.0 && in_b.variance == 0.0 && in_a.mean == in_b.mean)) {
                continue;
            }
            const WelchTest test = welch_test(in_a, in_b);
            const double z = std::isfinite(test.freedom) ? normal_from_two_sided(test.p) : std::min(std::fabs(test.t()), farthest_normal);
            result.chi2 += z * z;
            beyond += test.p < 0.05 ? 1 : 0;
            ++result.tested;
            if (test.p < smallest_p) {
                smallest_p = test.p;
                result.worst_z = std::copysign(z, test.difference);
                result.worst_x = x;
                result.worst_y = y;
            }
        }
    }
    if (result.tested > 0) {
        const double tested = static_cast<double>(result.tested);
        result.share_beyond_95 = static_cast<double>(beyond) / tested;
        result.chi2_p = chi_squared_above(result.chi2, tested);
        result.worst_p = std::min(1.0, smallest_p * tested);
    }
    return result;
}

}  // namespace lancer
