#include "statistics/chi_squared.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "lancer/image/probability.h"

namespace lancer::statistics {
namespace {

constexpr double fewest_expected = 8.0;

// Nodes and weights of Gauss and Legendre's rule with four points on [0, 1].
constexpr std::array<double, 4> nodes = {0.069431844202973712, 0.33000947820757187, 0.66999052179242813, 0.93056815579702629};
constexpr std::array<double, 4> weights = {0.17392742256872693, 0.32607257743127307, 0.32607257743127307, 0.17392742256872693};

Pair rule(const std::function<Pair(double, double)>& function, double x0, double x1, double y0, double y1) {
    Pair sum;
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
            const Pair p = function(x0 + (x1 - x0) * nodes[i], y0 + (y1 - y0) * nodes[j]);
            const double w = weights[i] * weights[j] * (x1 - x0) * (y1 - y0);
            sum.density += w * p.density;
            sum.value += w * p.value;
        }
    }
    return sum;
}

Pair refine(const std::function<Pair(double, double)>& function, double x0, double x1, double y0, double y1, double tolerance,
            const Pair& whole, int least_depth, int most_depth) {
    const double x = 0.5 * (x0 + x1);
    const double y = 0.5 * (y0 + y1);
    const std::array<Pair, 4> parts = {rule(function, x0, x, y0, y), rule(function, x, x1, y0, y), rule(function, x0, x, y, y1),
                                       rule(function, x, x1, y, y1)};
    Pair sum;
    for (const Pair& part : parts) {
        sum.density += part.density;
        sum.value += part.value;
    }
    const bool agree = std::abs(sum.density - whole.density) <= tolerance && std::abs(sum.value - whole.value) <= tolerance;
    if (most_depth == 0 || (agree && least_depth <= 0)) {
        return sum;
    }
    const auto deeper = [&](double a0, double a1, double b0, double b1, const Pair& part) {
        return refine(function, a0, a1, b0, b1, tolerance * 0.5, part, least_depth - 1, most_depth - 1);
    };
    Pair result;
    for (const Pair& part :
         {deeper(x0, x, y0, y, parts[0]), deeper(x, x1, y0, y, parts[1]), deeper(x0, x, y, y1, parts[2]), deeper(x, x1, y, y1, parts[3])}) {
        result.density += part.density;
        result.value += part.value;
    }
    return result;
}

}  // namespace

std::string Verdict::words() const {
    return trouble.empty() ? fmt::format("chi2 {:.1f} with {} degrees of freedom: chance {:.2e}", chi2, freedom, chance) : trouble;
}

Verdict compare_counts(const std::vector<double>& counts, const std::vector<double>& expected) {
    static int tests = 0;
    EXPECT_LE(++tests, most_tests) << "more tests than the false alarms were shared out over";
    std::vector<std::size_t> order(counts.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return expected[a] < expected[b]; });

    Verdict verdict;
    double pooled_count = 0.0;
    double pooled_expected = 0.0;
    int cells = 0;
    const auto close_pool = [&] {
        verdict.chi2 += (pooled_count - pooled_expected) * (pooled_count - pooled_expected) / pooled_expected;
        ++cells;
        pooled_count = 0.0;
        pooled_expected = 0.0;
    };
    for (const std::size_t i : order) {
        // A few draws may round into a cell next to their own.
        if (expected[i] < 1e-4 && counts[i] > 3.0) {
            verdict.trouble = fmt::format("cell {} expects {:.2e} draws and has {}", i, expected[i], counts[i]);
        }
        pooled_count += counts[i];
        pooled_expected += expected[i];
        if (pooled_expected >= fewest_expected) {
            close_pool();
        }
    }
    if (pooled_expected > 1e-3) {
        close_pool();
    }
    verdict.freedom = std::max(cells - 1, 1);
    verdict.chance = chi_squared_above(verdict.chi2, verdict.freedom);
    return verdict;
}

Pair integrate(const std::function<Pair(double, double)>& function, double x0, double x1, double y0, double y1, double tolerance,
               int least_depth, int most_depth) {
    return refine(function, x0, x1, y0, y1, tolerance, rule(function, x0, x1, y0, y1), least_depth, most_depth);
}

void Cells::count(double x, double y) {
    const auto place = [](double t, int cells) { return static_cast<std::size_t>(std::clamp(static_cast<int>(t * cells), 0, cells - 1)); };
    counts_[place(y, rows_) * std::size_t(columns_) + place(x, columns_)] += 1.0;
}

double Cells::total() const { return std::accumulate(counts_.begin(), counts_.end(), 0.0); }

std::vector<double> Cells::expect(const std::function<Pair(double, double)>& density, double tolerance, Pair& sum, int least_depth) const {
    std::vector<double> expected(counts_.size());
    sum = Pair{};
    const double all = total();
    for (int row = 0; row < rows_; ++row) {
        for (int column = 0; column < columns_; ++column) {
            const std::size_t i = std::size_t(row) * std::size_t(columns_) + std::size_t(column);
            const auto inside = [&](int depth) {
                return integrate(density, double(column) / columns_, double(column + 1) / columns_, double(row) / rows_,
                                 double(row + 1) / rows_, tolerance, depth, depth <= least_depth ? 7 : 10);
            };
            // Where draws have fallen otherwise than expected there may be a peak between the nodes of a coarse rule.
            Pair p = inside(least_depth);
            for (const int deeper : {2, 4, 6}) {
                if (std::abs(counts_[i] - p.density * all) > 3.0 * std::sqrt(p.density * all) + 1.0) {
                    p = inside(least_depth + deeper);
                }
            }
            expected[i] = p.density * all;
            sum.density += p.density;
            sum.value += p.value;
        }
    }
    expected.back() = std::max((1.0 - sum.density) * all, 0.0);
    return expected;
}

}  // namespace lancer::statistics
