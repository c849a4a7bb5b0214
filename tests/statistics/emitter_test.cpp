// Every emitter: where its samples fall is what its density says.
#include "lancer/kernel/emitter/emitter.h"

#include <cmath>
#include <random>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "lancer/kernel/all_objects.h"
#include "statistics/bsdf_cases.h"
#include "statistics/chi_squared.h"
#include "statistics/emitter_cases.h"

namespace lancer::statistics {
namespace {

using namespace kernel;

constexpr double pi = 3.14159265358979323846;

TEST(Emitter, EveryKindIsTested) {
    std::set<int> kinds, skies;
    for (const EmitterCase& c : emitter_cases()) {
        kinds.insert(c.kind);
        if (c.kind == EMITTER_ENVIRONMENT) {
            skies.insert(c.world->sky.kind);
        }
    }
    for (int kind = SKY_EVEN; kind < SKY_KINDS; ++kind) {
        EXPECT_TRUE(skies.count(kind)) << "sky kind " << kind << " has no case in tests/statistics/emitter_test.cpp";
    }
    for (int kind = 0; kind < EMITTER_KINDS; ++kind) {
        EXPECT_TRUE(kinds.count(kind)) << "emitter kind " << kind << " has no case in tests/statistics/emitter_test.cpp";
    }
}

TEST(Emitter, DrawsWithItsDensity) {
    std::mt19937 numbers(6);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    constexpr int draws = 30000;
    for (const EmitterCase& c : emitter_cases()) {
        SCOPED_TRACE(c.name);
        ASSERT_TRUE(c.world);
        const WorldRecord world = c.world->record();
        ASSERT_EQ(world.emitter_count, c.count);
        const EmitterRecord emitter = c.world->emitters.front();
        ASSERT_EQ(emitter.kind, c.kind);
        const Vec3 from = vec3_all(0.0f);
        Cells cells(28, 28);
        int wrong_densities = 0;
        for (int i = 0; i < draws; ++i) {
            const Vec2 u = vec2_of(std::min(uniform(numbers), 0.99999994f), std::min(uniform(numbers), 0.99999994f));
            const EmitterSample s = emitter_sample(world, emitter, from, u, true);
            ASSERT_TRUE(s.valid);
            ASSERT_NEAR(double(length(s.direction)), 1.0, 1e-5);
            if (s.discrete) {
                ASSERT_EQ(s.density, 1.0f);
                const Spectrum light = emitted_light(world, emitter, s, vec4_all(550.0f), true);
                ASSERT_GT(light.x, 0.0f);
                continue;
            }
            cells.count(std::atan2(double(s.direction.y), double(s.direction.x)) / (2.0 * pi) + 0.5, 0.5 * double(s.direction.z) + 0.5);
            if (c.kind != EMITTER_MESH) {  // which triangle it was is not told
                const float density = emitter_density(world, emitter, from, s.direction, s.point, 0, true);
                wrong_densities += std::abs(density - s.density) <= 0.005f * s.density ? 0 : 1;
            }
        }
        EXPECT_LE(wrong_densities, draws / 1000);
        if (cells.total() == 0.0) {
            continue;  // a light without size
        }
        Pair sum;
        const auto density = [&](double x, double y) {
            const Vec3 direction = direction_of(2.0 * y - 1.0, (2.0 * x - 1.0) * pi);
            double at = 0.0;
            if (c.kind == EMITTER_ENVIRONMENT) {
                at = double(emitter_density(world, emitter, from, direction, no_surface(), 0, true));
            } else {
                for (const Met& met : points_along(c, world, direction)) {
                    // The density has no bound at an outline, nor have rounding errors.
                    if (std::abs(dot(direction, met.point.normal)) < 1e-3f) {
                        continue;
                    }
                    at += double(emitter_density(world, emitter, from, direction, met.point, met.part, true));
                }
            }
            return Pair{at * 4.0 * pi, 0.0};
        };
        std::vector<double> expected = cells.expect(density, 1e-5, sum, 1);
        // At outlines the density grows without bound and the integral misses a little: up to 0.3 %, spread over all cells here.
        for (double& count : expected) {
            count /= sum.density;
        }
        expected.back() = 0.0;
        const Verdict verdict = compare_counts(cells.counts(), expected);
        EXPECT_TRUE(verdict.right()) << verdict.words();
        EXPECT_NEAR(sum.density, 1.0, 4e-3);
    }
}

}  // namespace
}  // namespace lancer::statistics
