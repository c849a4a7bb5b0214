// Sample points: uniform, evenly spread over powers of two, and independent from decision to decision.
#include "lancer/kernel/sampler.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "statistics/chi_squared.h"

namespace lancer::statistics {
namespace {

using namespace kernel;

// Over pixels with one sample each the points are independent draws.
TEST(Sampler, IsUniformOverPixels) {
    for (const std::uint32_t decision : {0u, 1u, 7u, 100u}) {
        for (const std::uint32_t number : {0u, 1u, 1000u}) {
            std::vector<double> counts(32 * 32);
            constexpr int pixels = 100000;
            for (std::uint32_t pixel = 0; pixel < pixels; ++pixel) {
                const Vec2 u = sample_pair(start_sampler(scramble(pixel), number), decision);
                ASSERT_TRUE(u.x >= 0.0f && u.x < 1.0f && u.y >= 0.0f && u.y < 1.0f);
                counts[static_cast<std::size_t>(u.x * 32.0f) * 32 + static_cast<std::size_t>(u.y * 32.0f)] += 1.0;
            }
            const Verdict verdict = compare_counts(counts, std::vector<double>(counts.size(), pixels / 1024.0));
            EXPECT_TRUE(verdict.right()) << "decision " << decision << ", sample " << number << ": " << verdict.words();
        }
    }
}

// Any aligned 2^k samples: one in each of the boxes of area 2^-k, however they are cut.
TEST(Sampler, IsEvenlySpreadOverPowersOfTwo) {
    for (const std::uint32_t key : {1u, 0xdeadbeefu}) {
        for (const std::uint32_t decision : {0u, 3u, 50u}) {
            for (const int log_count : {2, 4, 6, 8}) {
                const int count = 1 << log_count;
                for (const int block : {0, 1, 5}) {
                    for (int cut = 0; cut <= log_count; ++cut) {
                        std::set<int> boxes;
                        const int columns = 1 << cut;
                        const int rows = 1 << (log_count - cut);
                        for (int i = 0; i < count; ++i) {
                            const Vec2 u = sample_pair(start_sampler(key, static_cast<std::uint32_t>(block * count + i)), decision);
                            boxes.insert(static_cast<int>(u.x * static_cast<float>(columns)) * rows +
                                         static_cast<int>(u.y * static_cast<float>(rows)));
                        }
                        ASSERT_EQ(boxes.size(), static_cast<std::size_t>(count))
                            << "key " << key << " decision " << decision << " cut " << cut;
                    }
                }
            }
        }
    }
}

TEST(Sampler, QuarteredNumbersAreUniform) {
    std::vector<double> counts(64);
    constexpr int pixels = 100000;
    for (std::uint32_t pixel = 0; pixel < pixels; ++pixel) {
        const float u = quartered_number(start_sampler(scramble(pixel), 5), 5, 2);
        ASSERT_TRUE(u >= 0.0f && u < 1.0f);
        counts[static_cast<std::size_t>(u * 64.0f)] += 1.0;
    }
    const Verdict verdict = compare_counts(counts, std::vector<double>(counts.size(), pixels / 64.0));
    EXPECT_TRUE(verdict.right()) << verdict.words();
}

// With those a quarter, a half and three quarters away they are evenly spaced; and as many begin in each quarter.
TEST(Sampler, QuarteredNumbersFormALattice) {
    for (const std::uint32_t key : {1u, 77u, 0xdeadbeefu}) {
        for (const std::uint32_t count : {1u, 4u, 16u, 64u}) {
            std::vector<double> all;
            int begin_in[4] = {};
            for (std::uint32_t i = 0; i < count; ++i) {
                const double u = double(quartered_number(start_sampler(key, i), i, 2));
                ++begin_in[static_cast<int>(4.0 * u)];
                for (const double turn : {0.0, 0.25, 0.5, 0.75}) {
                    all.push_back(std::fmod(u + turn, 1.0));
                }
            }
            std::sort(all.begin(), all.end());
            for (std::size_t i = 1; i < all.size(); ++i) {
                ASSERT_NEAR(all[i] - all[i - 1], 0.25 / count, 2e-7) << key << " " << count;
            }
            for (const int begin : begin_in) {
                EXPECT_TRUE(count == 1 || begin == static_cast<int>(count / 4)) << key << " " << count;
            }
        }
    }
}

// The first ones alone fill [0, 1), too, as paths need that keep one wavelength: of a pixel's 4096 samples, in each 256th 16 or nearly so.
TEST(Sampler, QuarteredNumbersAreEvenAlone) {
    for (const std::uint32_t key : {1u, 77u, 0xdeadbeefu}) {
        int counts[256] = {};
        for (std::uint32_t i = 0; i < 4096; ++i) {
            ++counts[static_cast<int>(256.0 * double(quartered_number(start_sampler(key, i), i, 2)))];
        }
        for (const int count : counts) {
            EXPECT_NEAR(count, 16, 4) << key;
        }
    }
}

// Within one pixel: the numbers of two decisions together fill the square (and cube) as independent ones do, or better.
TEST(Sampler, DecisionsAreIndependent) {
    constexpr int side = 16;
    for (const auto& [a, b] : {std::pair{0u, 1u}, {4u, 5u}, {5u, 6u}, {6u, 10u}, {3u, 103u}}) {
        // Over many pixels, 16 samples each: correlation between the places of the same sample.
        std::vector<double> first(side * side);
        std::vector<double> second(side * side);
        constexpr int pixels = 4000;
        for (std::uint32_t pixel = 0; pixel < pixels; ++pixel) {
            for (std::uint32_t number = 0; number < 16; ++number) {
                const Sampler s = start_sampler(scramble(pixel * 7919u + 13u), number);
                const Vec2 u = sample_pair(s, a);
                const Vec2 v = sample_pair(s, b);
                first[static_cast<std::size_t>(u.x * side) * side + static_cast<std::size_t>(v.x * side)] += 1.0;
                second[static_cast<std::size_t>(u.x * side) * side + static_cast<std::size_t>(v.y * side)] += 1.0;
            }
        }
        for (const auto& counts : {first, second}) {
            const Verdict verdict = compare_counts(counts, std::vector<double>(counts.size(), pixels * 16.0 / (side * side)));
            EXPECT_TRUE(verdict.right()) << "decisions " << a << " and " << b << ": " << verdict.words();
        }
    }
}

// The mean over 256 samples of a product of functions of different decisions comes close to the product of their means.
TEST(Sampler, ProductsOfDecisionsIntegrate) {
    double squared = 0.0;
    constexpr int pixels = 400;
    for (std::uint32_t pixel = 0; pixel < pixels; ++pixel) {
        double sum = 0.0;
        for (std::uint32_t number = 0; number < 256; ++number) {
            const Sampler s = start_sampler(scramble(pixel), number);
            sum += double(sample_pair(s, 1).x) * double(sample_pair(s, 2).y);
        }
        squared += (sum / 256.0 - 0.25) * (sum / 256.0 - 0.25);
    }
    // Independent draws: variance 7 / 144 over 256, root 0.01378. Half of it is left to stratification: each factor alone is nearly exact.
    EXPECT_LT(std::sqrt(squared / pixels), 0.01378);
    EXPECT_GT(std::sqrt(squared / pixels), 1e-4);
}

}  // namespace
}  // namespace lancer::statistics
