#include "lancer/image/significance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "lancer/image/probability.h"

namespace {

using namespace lancer;

TEST(Probability, OfStudentHasItsClosedForms) {
    for (const double t : {0.01, 0.5, 1.0, 3.0, 40.0}) {
        EXPECT_NEAR(student_two_sided(t, 1.0), 2.0 / std::numbers::pi * std::atan(1.0 / t), 1e-13) << t;
        EXPECT_NEAR(student_two_sided(t, 2.0), 1.0 - t / std::sqrt(2.0 + t * t), 1e-13) << t;
        EXPECT_NEAR(student_two_sided(-t, 2.0), student_two_sided(t, 2.0), 1e-15) << t;
        EXPECT_NEAR(student_two_sided(t, 1e9), std::erfc(t / std::numbers::sqrt2), 1e-8) << t;
        EXPECT_NEAR(student_two_sided(t, std::numeric_limits<double>::infinity()), std::erfc(t / std::numbers::sqrt2), 1e-15) << t;
    }
    EXPECT_NEAR(student_two_sided(3.0, 1e5), student_two_sided(3.0, 1.00001e5), 1e-9);  // where the method changes
    EXPECT_EQ(student_two_sided(0.0, 5.0), 1.0);
    EXPECT_EQ(student_two_sided(std::numeric_limits<double>::infinity(), 5.0), 0.0);
    EXPECT_NEAR(student_two_sided(2.570581835636314, 5.0), 0.05, 1e-12);  // the table's 2.571
}

TEST(Probability, OfBetaAndGammaHasItsClosedForms) {
    for (const double x : {0.001, 0.3, 0.5, 0.97}) {
        EXPECT_NEAR(incomplete_beta(x, 1.0, 4.5), 1.0 - std::pow(1.0 - x, 4.5), 1e-13);
        EXPECT_NEAR(incomplete_beta(x, 3.0, 1.0), x * x * x, 1e-13);
        EXPECT_NEAR(incomplete_beta(x, 2.5, 700.0) + incomplete_beta(1.0 - x, 700.0, 2.5), 1.0, 1e-12);
    }
    for (const double x : {0.01, 1.0, 2.5, 20.0}) {
        EXPECT_NEAR(upper_incomplete_gamma(1.0, x), std::exp(-x), 1e-13);
        EXPECT_NEAR(upper_incomplete_gamma(0.5, x), std::erfc(std::sqrt(x)), 1e-13);
        EXPECT_NEAR(upper_incomplete_gamma(3.0, x), std::exp(-x) * (1.0 + x + 0.5 * x * x), 1e-13);
    }
    EXPECT_EQ(incomplete_beta(0.0, 2.0, 3.0), 0.0);
    EXPECT_EQ(incomplete_beta(1.0, 2.0, 3.0), 1.0);
    EXPECT_NEAR(chi_squared_above(3.841458820694124, 1.0), 0.05, 1e-12);
    // Where the approximation for many degrees takes over.
    EXPECT_NEAR(chi_squared_above(1.005e5, 1e5), chi_squared_above(1.005e5 + 1.0, 1e5 + 1.0), 1e-3);
}

TEST(Probability, OfTheNormalIsTurnedRound) {
    for (const double z : {0.0, 1e-6, 0.1, 1.0, 5.0, 20.0, 36.0}) {
        EXPECT_NEAR(normal_from_two_sided(std::erfc(z / std::numbers::sqrt2)), z, 1e-9);
    }
    EXPECT_EQ(normal_from_two_sided(0.0), farthest_normal);
}

// By hand: variances 1 and 4 of means of 4 and 5 numbers.
TEST(Welch, FollowsItsFormulas) {
    const WelchTest test = welch_test({10.0, 0.25, 3.0}, {8.0, 0.8, 4.0});
    EXPECT_DOUBLE_EQ(test.difference, 2.0);
    EXPECT_DOUBLE_EQ(test.error, std::sqrt(1.05));
    EXPECT_DOUBLE_EQ(test.freedom, 1.05 * 1.05 / (0.0625 / 3.0 + 0.64 / 4.0));
    EXPECT_DOUBLE_EQ(test.p, student_two_sided(2.0 / std::sqrt(1.05), test.freedom));
    EXPECT_EQ(welch_test({1.0}, {1.0}).p, 1.0);
    EXPECT_EQ(welch_test({1.0}, {2.0}).p, 0.0);
}

// Pictures of noise with spread 1 around a mean, and the noise that a renderer would tell.
struct Noise {
    std::vector<std::vector<float>> runs;
    std::vector<float> variances;

    Noise(unsigned seed, int count, std::size_t pixels, float mean) : variances(pixels, 1.0f) {
        std::mt19937 random(seed);
        std::normal_distribution<float> normal(mean, 1.0f);
        for (int i = 0; i < count; ++i) {
            std::vector<float>& run = runs.emplace_back(pixels);
            for (float& value : run) {
                value = normal(random);
            }
        }
    }
    NoisyChannel channel() const {
        NoisyChannel result;
        for (const auto& run : runs) {
            result.runs.emplace_back(run);
        }
        if (runs.size() == 1) {
            result.variances = variances;
        }
        return result;
    }
};

double p_of_means(const NoisyChannel& a, const NoisyChannel& b, int width, int height) {
    std::uint64_t count = 0;
    const Rectangle whole{0, 0, width, height};
    return welch_test(measure(a, width, whole, {}, count), measure(b, width, whole, {}, count)).p;
}

// With nothing to find, p is even in [0, 1]: below 0.1 in a tenth of the tries. 400 tries: 40 +- 6, so 18 to 62 is 3.7 standard deviations,
// a false alarm once in 4000 changes of the code (the seeds are fixed).
TEST(Significance, OfEqualPicturesIsEven) {
    for (const int runs : {1, 3}) {
        int small_mean = 0, small_worst = 0, small_chi2 = 0;
        for (unsigned i = 0; i < 400; ++i) {
            const Noise a(2 * i, runs, 24 * 16, 5.0f), b(2 * i + 1, runs, 24 * 16, 5.0f);
            small_mean += p_of_means(a.channel(), b.channel(), 24, 16) < 0.1 ? 1 : 0;
            const CellTests cells = test_cells(a.channel(), b.channel(), 24, 16, 4);
            EXPECT_EQ(cells.tested, 24u);
            small_worst += cells.worst_p < 0.1 ? 1 : 0;
            small_chi2 += cells.chi2_p < 0.1 ? 1 : 0;
        }
        for (const int small : {small_mean, small_worst, small_chi2}) {
            // Welch's freedom is an estimate, which errs to the safe side with three runs.
            EXPECT_GE(small, runs == 1 ? 18 : 8) << runs << " runs";
            EXPECT_LE(small, 62) << runs << " runs";
        }
    }
}

// 384 pixels of spread 1: means are known to 0.051, their difference to 0.072; 0.5 is 7 standard deviations.
TEST(Significance, OfABiasIsFound) {
    const Noise a(1, 1, 24 * 16, 5.5f), b(2, 1, 24 * 16, 5.0f);
    EXPECT_LT(p_of_means(a.channel(), b.channel(), 24, 16), 1e-6);
    const Noise more(3, 4, 24 * 16, 5.5f), others(4, 5, 24 * 16, 5.0f);
    EXPECT_LT(p_of_means(more.channel(), others.channel(), 24, 16), 1e-3);
    NoisyChannel exact = b.channel();
    exact.variances = {};
    EXPECT_TRUE(exact.is_exact());
    EXPECT_LT(p_of_means(others.channel(), exact, 24, 16), 1.0);
}

TEST(Significance, OfALocalDifferenceIsFoundWhereItIs) {
    Noise a(1, 1, 24 * 16, 5.0f), b(2, 1, 24 * 16, 5.0f);
    for (std::size_t y = 8; y < 12; ++y) {
        for (std::size_t x = 20; x < 24; ++x) {
            a.runs[0][24 * y + x] -= 3.0f;
        }
    }
    const CellTests cells = test_cells(a.channel(), b.channel(), 24, 16, 4);
    EXPECT_LT(cells.worst_p, 1e-6);
    EXPECT_LT(cells.chi2_p, 1e-4);
    EXPECT_LT(cells.worst_z, -5.0);
    EXPECT_EQ(cells.worst_x, 20);
    EXPECT_EQ(cells.worst_y, 8);
}

// Two samples a pixel say little of their variance; many pixels say more.
TEST(Significance, KnowsHowWellTheVarianceIsKnown) {
    const std::vector<float> values(100, 1.0f), variances(100, 0.25f), samples(100, 3.0f);
    NoisyChannel channel;
    channel.runs = {values};
    channel.variances = variances;
    channel.samples = samples;
    channel.rounding = 0.0;
    std::uint64_t count = 0;
    EXPECT_NEAR(measure(channel, 10, {0, 0, 1, 1}, {}, count).freedom, 2.0, 1e-9);
    const Measured all = measure(channel, 10, {0, 0, 10, 10}, {}, count);
    EXPECT_NEAR(all.freedom, 200.0, 1e-6);
    EXPECT_NEAR(all.variance, 0.25 / 100.0, 1e-12);
    EXPECT_EQ(count, 100u);
}

// What the file rounds is no difference.
TEST(Significance, ForgivesRoundingButNothingMore) {
    const std::vector<float> a(64, 1.0f), near(64, 1.0f + 0x1p-11f), far(64, 1.01f);
    NoisyChannel one, two, three;
    one.runs = {a};
    two.runs = {near};
    three.runs = {far};
    one.rounding = two.rounding = three.rounding = 0x1p-10;
    EXPECT_GT(test_cells(one, two, 8, 8, 1).worst_p, 0.5);
    EXPECT_LT(test_cells(one, three, 8, 8, 1).worst_p, 1e-6);
}

TEST(Significance, LeavesOutWhatIsNoNumber) {
    Noise a(1, 2, 64, 1.0f), b(2, 2, 64, 1.0f);
    a.runs[1][5] = std::numeric_limits<float>::quiet_NaN();
    const CellTests cells = test_cells(a.channel(), b.channel(), 8, 8, 1);
    EXPECT_EQ(cells.tested, 63u);
    EXPECT_TRUE(std::isfinite(cells.chi2));
}

}  // namespace
