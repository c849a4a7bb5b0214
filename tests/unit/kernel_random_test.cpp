// Random numbers are a pure function, uniform, and neighbours know nothing of one another.
//
// The numbers are the same in every run, so a test that passes once passes always. The limits are those that fair numbers exceed once in a
// million times.
#include "lancer/kernel/random.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace lancer {
namespace {

constexpr double one_in_a_million = 4.753;  // standard deviations, one-sided

// Wilson and Hilferty's quantile of the chi-squared distribution.
double chi_squared_limit(int degrees) {
    const double a = 2.0 / (9.0 * degrees);
    return degrees * std::pow(1.0 - a + one_in_a_million * std::sqrt(a), 3.0);
}

// Two independent numbers at (pixel, sample, dimension) and somewhere near.
struct Step {
    const char* name;
    std::uint32_t seed, pixel, sample, dimension;
};

constexpr Step steps[] = {{"next seed", 1, 0, 0, 0},
                          {"next pixel", 0, 1, 0, 0},
                          {"pixel below", 0, 1920, 0, 0},
                          {"next sample", 0, 0, 1, 0},
                          {"next dimension", 0, 0, 0, 1},
                          {"pixel against sample", 0, 1, ~0u, 0},
                          {"sample against dimension", 0, 0, 1, ~0u}};

TEST(KernelRandom, IsAPureFunctionOfEachArgument) {
    const std::uint32_t here = kernel::random_bits(1, 2, 3, 4);
    EXPECT_EQ(kernel::random_bits(1, 2, 3, 4), here);
    EXPECT_NE(kernel::random_bits(2, 2, 3, 4), here);
    EXPECT_NE(kernel::random_bits(1, 3, 3, 4), here);
    EXPECT_NE(kernel::random_bits(1, 2, 4, 4), here);
    EXPECT_NE(kernel::random_bits(1, 2, 3, 5), here);
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

TEST(KernelRandom, LiesBelowOne) {
    float least = 1.0f, most = 0.0f;
    for (std::uint32_t i = 0; i < 1u << 20; ++i) {
        const float x = kernel::random_number(7, i, 0, 0);
        least = std::min(least, x);
        most = std::max(most, x);
    }
    EXPECT_GE(least, 0.0f);
    EXPECT_LT(least, 1e-4f);
    EXPECT_LT(most, 1.0f);
    EXPECT_GT(most, 0.9999f);
}

TEST(KernelRandom, IsUniform) {
    constexpr int cells = 1024;
    constexpr int count = 1 << 20;
    // Along each argument.
    for (int along = 0; along < 4; ++along) {
        std::vector<int> hits(cells, 0);
        for (std::uint32_t i = 0; i < count; ++i) {
            const float x = kernel::random_number(along == 0 ? i : 3, along == 1 ? i : 5, along == 2 ? i : 7, along == 3 ? i : 11);
            ++hits[static_cast<std::size_t>(x * cells)];
        }
        double chi_squared = 0.0;
        const double expected = static_cast<double>(count) / cells;
        for (const int n : hits) {
            chi_squared += (n - expected) * (n - expected) / expected;
        }
        EXPECT_LT(chi_squared, chi_squared_limit(cells - 1)) << "argument " << along;
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
            const std::uint32_t pixel = i % width * 2, sample = i / width + 1, dimension = 9;
            const float x = kernel::random_number(4, pixel, sample, dimension);
            const float y = kernel::random_number(4 + step.seed, pixel + step.pixel, sample + step.sample, dimension + step.dimension);
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

// Each input bit turns each output bit in half of the cases.
TEST(KernelRandom, BitsAvalanche) {
    constexpr int count = 4096;
    for (int argument = 0; argument < 4; ++argument) {
        for (int bit = 0; bit < 32; ++bit) {
            std::array<int, 32> turned{};
            for (std::uint32_t i = 0; i < count; ++i) {
                std::uint32_t in[4] = {i, i * 3, i * 5, i * 7};
                const std::uint32_t before = kernel::random_bits(in[0], in[1], in[2], in[3]);
                in[argument] ^= 1u << bit;
                const std::uint32_t changed = before ^ kernel::random_bits(in[0], in[1], in[2], in[3]);
                for (std::size_t k = 0; k < 32; ++k) {
                    turned[k] += static_cast<int>((changed >> k) & 1u);
                }
            }
            for (const int n : turned) {
                // 4096 pairs of bits are looked at: eight standard deviations are one in 10^12 for each.
                EXPECT_LT(std::abs(n - count / 2), 8.0 * std::sqrt(count) / 2.0) << "argument " << argument << ", bit " << bit;
            }
        }
    }
}

}  // namespace
}  // namespace lancer
