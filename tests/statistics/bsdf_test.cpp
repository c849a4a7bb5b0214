// Every BSDF: draws with the density that it states, loses and gains no light that it should not, and is the same both ways.
#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "statistics/bsdf_cases.h"
#include "statistics/chi_squared.h"

namespace lancer::statistics {
namespace {

using namespace kernel;

constexpr double cosines[] = {0.9, 0.2};
constexpr double pi = 3.14159265358979323846;

// A direction of a place on the unit square: y from -z to +z, x around.
Vec3 on_square(double x, double y) { return direction_of(2.0 * y - 1.0, (2.0 * x - 1.0) * pi); }

bool same(float a, float b, float relative, float absolute) {
    return std::abs(a - b) <= absolute + relative * std::max(std::abs(a), std::abs(b));
}

TEST(Bsdf, EveryKindIsTested) {
    std::set<int> kinds;
    for (const BsdfCase& c : bsdf_cases()) {
        kinds.insert(c.closure.kind);
    }
    for (int kind = 0; kind < BSDF_KINDS; ++kind) {
        EXPECT_TRUE(kinds.count(kind)) << "BSDF kind " << kind << " has no case in tests/statistics/bsdf_cases.cpp";
    }
}

// Where the draws fall is what the density says; it and what is not drawn make 1; the mean weight is the integral of the value.
class BsdfKind : public testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(Each, BsdfKind, testing::Range(0, BSDF_KINDS));

TEST_P(BsdfKind, DrawsWithItsDensity) {
    constexpr int draws = 40000;
    std::mt19937 numbers(1);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (const BsdfCase& c : bsdf_cases()) {
        if (c.closure.kind != GetParam()) {
            continue;
        }
        for (const double cosine : cosines) {
            SCOPED_TRACE(c.name + " seen at cosine " + std::to_string(cosine));
            const Vec3 wo = direction_of(cosine, 0.7);
            Cells cells(24, 16);
            double weight = 0.0;
            double weight_2 = 0.0;
            int wrong_weights = 0;
            for (int i = 0; i < draws; ++i) {
                const BsdfSample s = sample_of(c.closure, wo, uniform(numbers), uniform(numbers), uniform(numbers));
                if (!s.valid) {
                    cells.count_elsewhere();
                    continue;
                }
                ASSERT_TRUE(std::isfinite(s.weight.x) && s.weight.x >= 0.0f && std::isfinite(s.density) && s.density >= 0.0f);
                const double x = double(s.weight.x);
                ASSERT_EQ(s.transmits, s.wi.z < 0.0f);
                ASSERT_NEAR(double(length(s.wi)), 1.0, 2e-5);
                if (s.discrete) {
                    ASSERT_EQ(s.density, 0.0f);
                    cells.count_elsewhere();
                    weight += x;
                    weight_2 += x * x;
                    continue;
                }
                cells.count(std::atan2(double(s.wi.y), double(s.wi.x)) / (2.0 * pi) + 0.5, 0.5 * double(s.wi.z) + 0.5);
                weight += x;
                weight_2 += x * x;
                const BsdfValue v = value_of(c.closure, wo, s.wi);
                // The half vector loses digits where wi is all but opposite to wo: a few draws may differ more.
                wrong_weights += same(v.density, s.density, 0.01f, 1e-6f) && same(v.value.x, s.weight.x * s.density, 0.01f, 1e-6f) &&
                                         same(v.value.w, s.weight.w * s.density, 0.01f, 1e-6f)
                                     ? 0
                                     : 1;
            }
            EXPECT_LE(wrong_weights, draws / 2000);
            Pair sum;
            const auto density = [&](double x, double y) {
                const BsdfValue v = value_of(c.closure, wo, on_square(x, y));
                return Pair{double(v.density) * 4.0 * pi, double(v.value.x) * 4.0 * pi};
            };
            const auto expected = cells.expect(density, 1e-5, sum);
            const Verdict verdict = compare_counts(cells.counts(), expected);
            EXPECT_TRUE(verdict.right()) << verdict.words() << "; density integrates to " << sum.density << ", drawn elsewhere "
                                         << cells.counts().back() / draws;
            EXPECT_LE(sum.density, 1.0 + 2e-3);
            // Of what has a density only, as mirrors are left out of the integral.
            if (!is_smooth(c.closure)) {
                const double mean_weight = weight / draws;
                const double error = std::sqrt(std::max(weight_2 / draws - mean_weight * mean_weight, 0.0) / draws);
                if (expected.back() < 1.0 || !c.closure.kind) {
                    EXPECT_NEAR(mean_weight, sum.value, 5.0 * error + 1e-3);
                }
            }
        }
    }
}

// Directions along the surface, numbers at the ends of their range, roughness at the end of what counts as rough.
TEST(Bsdf, EveryNumberIsFinite) {
    constexpr double last = 0.99999994;
    for (const BsdfCase& c : bsdf_cases()) {
        BsdfCase barely = c;
        barely.closure.roughness_x = barely.closure.roughness_y = 1.001e-3f;
        for (const Closure& closure : {c.closure, barely.closure}) {
            for (const double cosine : {1.0, 1e-2, 1e-4, 1e-7}) {
                const Vec3 wo = direction_of(cosine, 0.4);
                for (const double choice : {0.0, 0.3, 0.7, last}) {
                    for (const double u : {0.0, 0.5, last}) {
                        for (const double v : {0.0, 0.25, last}) {
                            const BsdfSample s = sample_of(closure, wo, choice, u, v);
                            if (!s.valid) {
                                continue;
                            }
                            for (const float x : {s.wi.x, s.wi.y, s.wi.z, s.weight.x, s.weight.w, s.density}) {
                                ASSERT_TRUE(std::isfinite(x)) << c.name << " " << cosine << " " << choice << " " << u << " " << v;
                            }
                            ASSERT_GE(s.weight.x, 0.0f);
                            const BsdfValue value = value_of(closure, wo, s.wi);
                            ASSERT_TRUE(std::isfinite(value.value.x) && value.value.x >= 0.0f && std::isfinite(value.density)) << c.name;
                        }
                    }
                }
            }
        }
    }
}

// f(a, b) = f(b, a); through a border the radiance is divided by the squared index of its side.
TEST(Bsdf, IsTheSameBothWays) {
    std::mt19937 numbers(2);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (const BsdfCase& c : bsdf_cases()) {
        if (!c.reciprocal) {
            continue;
        }
        SCOPED_TRACE(c.name);
        for (int i = 0; i < 2000; ++i) {
            const Vec3 a = direction_of(0.02 + 0.98 * uniform(numbers), 2.0 * pi * uniform(numbers));
            Vec3 b = direction_of(0.02 + 0.98 * uniform(numbers), 2.0 * pi * uniform(numbers));
            const Spectrum there = value_of(c.closure, a, b).value / b.z;
            const Spectrum back = value_of(c.closure, b, a).value / a.z;
            ASSERT_TRUE(same(there.x, back.x, 2e-3f, 1e-5f) && same(there.z, back.z, 2e-3f, 1e-5f)) << there.x << " " << back.x;
            // From below: the frame is turned over.
            const Vec3 below = vec3_of(b.x, -b.y, -b.z);
            const Vec3 turned = vec3_of(below.x, -below.y, -below.z);
            const Vec3 a_turned = vec3_of(a.x, -a.y, -a.z);
            const Spectrum through = value_of(c.closure, a, below).value / b.z;
            if (!c.transmits) {
                ASSERT_EQ(through.x, 0.0f);
                ASSERT_EQ(value_of(c.closure, a, below).density, 0.0f);
                continue;
            }
            const Spectrum through_back = value_of(c.other_side, turned, a_turned).value / a.z;
            const float eta_2 = is_clear(c.closure) ? c.closure.index.x * c.closure.index.x : 1.0f;
            ASSERT_TRUE(same(through.x * eta_2, through_back.x, 3e-3f, 1e-4f)) << through.x * eta_2 << " " << through_back.x;
        }
    }
}

struct Furnace {
    double mean = 0.0;
    double error = 0.0;  // root mean square, of the mean
};

// What comes back from a surface in a furnace of radiance 1, index squared times 1 inside of a body.
Furnace in_furnace(const Closure& closure, double cosine, int side, std::mt19937& numbers) {
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    const Vec3 wo = direction_of(cosine, 0.3);
    const double eta = is_clear(closure) ? double(closure.index.x) : 1.0;
    double sum = 0.0;
    double sum_2 = 0.0;
    for (int i = 0; i < side * side; ++i) {
        const double u = (i % side + uniform(numbers)) / side;
        const double v = (i / side + uniform(numbers)) / side;
        const BsdfSample s = sample_of(closure, wo, uniform(numbers), u, v);
        const double weight = s.valid ? double(s.weight.x) * (s.transmits ? eta * eta : 1.0) : 0.0;
        sum += weight;
        sum_2 += weight * weight;
    }
    Furnace furnace;
    furnace.mean = sum / (side * side);
    furnace.error = std::sqrt(std::max(sum_2 / (side * side) - furnace.mean * furnace.mean, 0.0)) / side;
    return furnace;
}

// A surface that swallows nothing can't be told from the furnace.
TEST(Bsdf, WhiteFurnaceStaysWhite) {
    std::mt19937 numbers(4);
    for (const BsdfCase& c : white_cases()) {
        for (const double cosine : {1.0, 0.7, 0.4, 0.15, 0.05}) {
            SCOPED_TRACE(c.name + " seen at cosine " + std::to_string(cosine));
            const Furnace furnace = in_furnace(c.closure, cosine, 130, numbers);
            EXPECT_NEAR(furnace.mean, 1.0, c.furnace + 4.0 * furnace.error);
        }
    }
}

// No surface gives back more than arrives, whatever its layers, with every colour at its brightest.
TEST(Bsdf, NoLightIsMade) {
    std::mt19937 numbers(5);
    for (const BsdfCase& c : bsdf_cases()) {
        BsdfCase bright = c;
        bright.closure.color = vec4_all(1.0f);
        // The table is coarser for stretched facets, worst for a clear body from within.
        const bool stretched = c.closure.roughness_x != c.closure.roughness_y;
        const double coarse = !stretched ? 0.0 : !is_clear(c.closure) ? 0.0065 : c.closure.index.x < 1.0f ? 0.02 : 0.0065;
        const double most = 1.0 + std::max(c.furnace, coarse);
        for (const double cosine : {1.0, 0.5, 0.2, 0.03}) {
            const Furnace furnace = in_furnace(bright.closure, cosine, 60, numbers);
            EXPECT_LE(furnace.mean, most + 4.0 * furnace.error) << c.name << " seen at cosine " << cosine;
        }
    }
}

}  // namespace
}  // namespace lancer::statistics
