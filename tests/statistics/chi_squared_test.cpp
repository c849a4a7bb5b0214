// The test itself: it accepts what is right and refuses what is slightly wrong.
#include "statistics/chi_squared.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "lancer/image/probability.h"

namespace lancer::statistics {
namespace {

Verdict test_of_slope(double drawn, double stated) {
    // Density 1 + s (2 x - 1) on [0, 1), drawn by inverting x + s (x^2 - x) = u.
    std::mt19937 numbers(7);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    Cells cells(20, 10);
    for (int i = 0; i < 200000; ++i) {
        const double u = uniform(numbers);
        const double a = drawn;
        const double x = a == 0.0 ? u : (a - 1.0 + std::sqrt((1.0 - a) * (1.0 - a) + 4.0 * a * u)) / (2.0 * a);
        cells.count(x, uniform(numbers));
    }
    Pair sum;
    const auto expected = cells.expect([&](double x, double) { return Pair{1.0 + stated * (2.0 * x - 1.0), 1.0}; }, 1e-9, sum);
    EXPECT_NEAR(sum.density, 1.0, 1e-9);
    EXPECT_NEAR(sum.value, 1.0, 1e-9);
    return compare_counts(cells.counts(), expected);
}

TEST(ChiSquared, AcceptsWhatIsRight) {
    EXPECT_TRUE(test_of_slope(0.0, 0.0).right());
    EXPECT_TRUE(test_of_slope(0.5, 0.5).right());
}

TEST(ChiSquared, RefusesASlopeThatIsWrongByFivePercent) {
    EXPECT_FALSE(test_of_slope(0.55, 0.5).right());
    EXPECT_FALSE(test_of_slope(0.0, 0.05).right());
}

TEST(ChiSquared, RefusesDrawsWhereNoneMayBe) {
    const std::vector<double> counts = {1000.0, 1000.0, 5.0};
    EXPECT_FALSE(compare_counts(counts, {1000.0, 1005.0, 0.0}).right());
}

TEST(ChiSquared, IntegratesAPeakBetweenTheNodes) {
    const auto peak = [](double x, double y) {
        const double d2 = (x - 0.37) * (x - 0.37) + (y - 0.61) * (y - 0.61);
        return Pair{std::exp(-d2 / 2e-4), 0.0};
    };
    EXPECT_NEAR(integrate(peak, 0.0, 1.0, 0.0, 1.0, 1e-9, 3, 12).density, 3.14159265 * 2e-4, 1e-8);
}

}  // namespace
}  // namespace lancer::statistics
