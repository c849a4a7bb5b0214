// Phase functions: draw with the density that they state, scatter all light and no more, and turn it by the mean cosine that is asked for.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "lancer/kernel/volume/phase.h"
#include "statistics/chi_squared.h"

namespace lancer::statistics {
namespace {

using namespace kernel;

constexpr double pi = 3.14159265358979323846;

struct PhaseCase {
    const char* name;
    int kind;
    float asymmetry;
};

constexpr PhaseCase cases[] = {{"isotropic", PHASE_HENYEY_GREENSTEIN, 0.0f},     {"a little forwards", PHASE_HENYEY_GREENSTEIN, 1e-4f},
                               {"forwards", PHASE_HENYEY_GREENSTEIN, 0.7f},      {"backwards", PHASE_HENYEY_GREENSTEIN, -0.5f},
                               {"far forwards", PHASE_HENYEY_GREENSTEIN, 0.95f}, {"rayleigh", PHASE_RAYLEIGH, 0.0f}};

Vec3 direction(double z, double around) {
    const double r = std::sqrt(std::max(1.0 - z * z, 0.0));
    return {static_cast<float>(r * std::cos(around)), static_cast<float>(r * std::sin(around)), static_cast<float>(z)};
}

TEST(Phase, DrawsWithItsDensity) {
    constexpr int draws = 100000;
    std::mt19937 numbers(5);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (const PhaseCase& c : cases) {
        SCOPED_TRACE(c.name);
        const Closure closure = phase_closure(c.kind, c.asymmetry);
        const Vec3 wo = direction(0.4, 2.0);
        Cells cells(24, 16);
        double turned = 0.0;
        for (int i = 0; i < draws; ++i) {
            const BsdfSample s = phase_sample(closure, wo, vec2_of(float(uniform(numbers)), float(uniform(numbers))));
            ASSERT_TRUE(s.valid);
            ASSERT_NEAR(double(length(s.wi)), 1.0, 2e-5);
            ASSERT_EQ(s.weight.x, 1.0f);
            const float density = phase_density(closure, wo, s.wi);
            ASSERT_NEAR(s.density / density, 1.0f, 0.02f);
            cells.count(std::atan2(double(s.wi.y), double(s.wi.x)) / (2.0 * pi) + 0.5, 0.5 * double(s.wi.z) + 0.5);
            turned += -double(dot(wo, s.wi));
        }
        Pair sum;
        const auto density = [&](double x, double y) {
            const BsdfValue v = phase_value(closure, wo, direction(2.0 * y - 1.0, (2.0 * x - 1.0) * pi));
            return Pair{double(v.density) * 4.0 * pi, double(v.value.y) * 4.0 * pi};
        };
        const Verdict verdict = compare_counts(cells.counts(), cells.expect(density, 1e-5, sum, 2));
        EXPECT_TRUE(verdict.right()) << verdict.words();
        EXPECT_NEAR(sum.density, 1.0, 1e-3);
        EXPECT_NEAR(sum.value, 1.0, 1e-3);
        // The mean cosine is g; no cosine's variance is above 1, and five deviations are one false alarm in two million.
        EXPECT_NEAR(turned / draws, double(c.asymmetry), 5.0 / std::sqrt(draws));
    }
}

// Over all directions, by Simpson's rule in the cosine: 1.
TEST(Phase, ScattersAllLight) {
    for (const PhaseCase& c : cases) {
        SCOPED_TRACE(c.name);
        constexpr int steps = 200000;
        double sum = 0.0;
        for (int i = 0; i <= steps; ++i) {
            const float cosine = static_cast<float>(-1.0 + 2.0 * i / steps);
            const double weight = i == 0 || i == steps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
            sum += weight * double(c.kind == PHASE_RAYLEIGH ? rayleigh(cosine) : henyey_greenstein(c.asymmetry, cosine));
        }
        EXPECT_NEAR(sum * (2.0 / steps) / 3.0 * 2.0 * pi, 1.0, 2e-5);
    }
}

// The same in double precision: the usual formula with its division by 2 g.
TEST(Phase, CosinesAreThoseOfTheInverse) {
    for (const double g : {-0.9, -0.3, 0.01, 0.3, 0.9}) {
        for (const double u : {0.0, 0.1, 0.5, 0.9, 0.999}) {
            const double s = (1.0 - g * g) / (1.0 - g + 2.0 * g * u);
            const double expected = (1.0 + g * g - s * s) / (2.0 * g);
            EXPECT_NEAR(double(henyey_greenstein_cosine(float(g), float(u))), expected, 3e-5) << g << " " << u;
        }
    }
    for (const double u : {0.0, 0.1, 0.5, 0.9, 0.999}) {
        const double x = double(rayleigh_cosine(float(u)));
        EXPECT_NEAR((4.0 + 3.0 * x + x * x * x) / 8.0, u, 2e-6);
    }
}

}  // namespace
}  // namespace lancer::statistics
