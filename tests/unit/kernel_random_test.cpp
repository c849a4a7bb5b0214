// Random numbers are a pure function of seed, pixel, sample and decision, and neighbours in each know nothing of one another.
//
// The numbers are the same in every run, so a test that passes once passes always. The limits are those that fair numbers exceed once in a
// million times.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "lancer/kernel/sampler.h"

namespace lancer {
namespace {

constexpr double one_in_a_million = 4.753;  // standard deviations, one-sided

// Wilson and Hilferty's quantile of the chi-squared distribution.
double chi_squared_limit(int degrees) {
    const double a = 2.0 / (9.0 * degrees);
    return degrees * std::pow(1.0 - a + one_in_a_million * std::sqrt(a), 3.0);
}

float number_of(std::uint32_t seed, std::uint32_t column, std::uint32_t row, std::uint32_t sample, std::uint32_t decision) {
    return kernel::sample_pair(kernel::start_sampler(kernel::pixel_key(column, row, seed), sample), decision).x;
}

// Two independent numbers: somewhere, and somewhere near.
struct Step {
    const char* name;
    std::uint32_t seed, column, row, decision;
};

constexpr Step steps[] = {{"next seed", 1, 0, 0, 0},     {"next pixel", 0, 1, 0, 0},           {"pixel below", 0, 0, 1, 0},
                          {"next decision", 0, 0, 0, 1}, {"pixel against seed", ~0u, 1, 0, 0}, {"pixel against decision", 0, 1, 0, ~0u}};

TEST(KernelRandom, IsAPureFunctionOfEachArgument) {
    const float here = number_of(1, 2, 3, 4, 5);
    EXPECT_EQ(number_of(1, 2, 3, 4, 5), here);
    EXPECT_NE(number_of(2, 2, 3, 4, 5), here);
    EXPECT_NE(number_of(1, 3, 3, 4, 5), here);
    EXPECT_NE(number_of(1, 2, 4, 4, 5), here);
    EXPECT_NE(number_of(1, 2, 3, 5, 5), here);
    EXPECT_NE(number_of(1, 2, 3, 4, 6), here);
    EXPECT_EQ(kernel::scramble(0u), 129708002u) << "pictures depend on these bits";
}

TEST(KernelRandom, ScrambleIsAPermutation) {
    // Of 32 bits; shown on a stretch: no value comes twice.
    std::vector<std::uint32_t> values;
    for (std::uint32_t i = 0; i < 1u << 20; ++i) {
        values.push_back(kernel::scramble(i * 4097u));
    }
    std::sort(values.begin(), values.end());
    EXPECT_EQ(std::adjacent_find(values.begin(), values.end()), values.end());
}

// Pixels of one picture hardly ever have the key of a pixel of another seed's picture: of two sets of n random keys, n^2 / 2^32 pairs are equal.
TEST(KernelRandom, SeedsShareNoKeys) {
    constexpr std::uint32_t side = 512;
    const auto keys = [](std::uint32_t seed) {
        std::vector<std::uint32_t> all;
        for (std::uint32_t row = 0; row < side; ++row) {
            for (std::uint32_t column = 0; column < side; ++column) {
                all.push_back(kernel::pixel_key(column, row, seed));
            }
        }
        std::sort(all.begin(), all.end());
        return all;
    };
    const std::vector<std::uint32_t> first = keys(0);
    const double expected = std::pow(side, 4.0) / 4294967296.0;  // 16
    for (const std::uint32_t seed : {1u, 2u, 512u, 65536u}) {
        std::vector<std::uint32_t> shared;
        const std::vector<std::uint32_t> second = keys(seed);
        std::set_intersection(first.begin(), first.end(), second.begin(), second.end(), std::back_inserter(shared));
        EXPECT_LT(static_cast<double>(shared.size()), expected + 6.0 * std::sqrt(expected)) << "seed " << seed;
    }
}

// Pairs of neighbours fill the square evenly.
TEST(KernelRandom, NeighboursAreIndependent) {
    constexpr int cells = 32;
    constexpr std::uint32_t width = 1024;
    for (const Step& step : steps) {
        std::vector<int> hits(cells * cells, 0);
        double product = 0.0;
        for (std::uint32_t i = 0; i < width * width; ++i) {
            const std::uint32_t column = i % width * 2, row = i / width * 2;
            const float x = number_of(4, column, row, 3, 9);
            const float y = number_of(4 + step.seed, column + step.column, row + step.row, 3, 9 + step.decision);
            ++hits[static_cast<std::size_t>(x * cells) * cells + static_cast<std::size_t>(y * cells)];
            product += (static_cast<double>(x) - 0.5) * (static_cast<double>(y) - 0.5);
        }
        const double count = static_cast<double>(width) * width;
        double chi_squared = 0.0;
        for (const int n : hits) {
            chi_squared += (n - count / (cells * cells)) * (n - count / (cells * cells)) / (count / (cells * cells));
        }
        EXPECT_LT(chi_squared, chi_squared_limit(cells * cells - 1)) << step.name;
        // The product of two uniform numbers around 0 has the variance 1/144.
        EXPECT_LT(std::abs(product), one_in_a_million * std::sqrt(count) / 12.0) << step.name;
    }
}

// Each bit of the pixel and of the seed turns each bit of the key in half of the cases.
TEST(KernelRandom, BitsAvalanche) {
    constexpr int count = 4096;
    for (int argument = 0; argument < 3; ++argument) {
        for (int bit = 0; bit < 16; ++bit) {
            std::array<int, 32> turned{};
            for (std::uint32_t i = 0; i < count; ++i) {
                std::uint32_t from[3] = {i, i * 3, i * 5};
                const std::uint32_t before = kernel::pixel_key(from[0] & 65535u, from[1] & 65535u, from[2]);
                from[argument] ^= 1u << bit;
                const std::uint32_t changed = before ^ kernel::pixel_key(from[0] & 65535u, from[1] & 65535u, from[2]);
                for (std::size_t k = 0; k < 32; ++k) {
                    turned[k] += static_cast<int>((changed >> k) & 1u);
                }
            }
            for (const int n : turned) {
                // 1536 bits are looked at: eight standard deviations are one in 10^12 for each.
                EXPECT_LT(std::abs(n - count / 2), 8.0 * std::sqrt(count) / 2.0) << "argument " << argument << ", bit " << bit;
            }
        }
    }
}

}  // namespace
}  // namespace lancer
