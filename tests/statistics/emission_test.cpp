// Every emitter, as a place where light begins: points, directions and their densities.
#include "lancer/kernel/emitter/emission.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "statistics/bsdf_cases.h"
#include "statistics/chi_squared.h"
#include "statistics/emitter_cases.h"

namespace lancer::statistics {
namespace {

using namespace kernel;

constexpr double pi = 3.14159265358979323846;
constexpr int draws = 30000;

class Numbers {
public:
    float one() { return std::min(uniform_(numbers_), 0.99999994f); }
    Vec2 two() { return vec2_of(one(), one()); }

private:
    std::mt19937 numbers_{8};
    std::uniform_real_distribution<float> uniform_{0.0f, 1.0f};
};

std::vector<double> evenly(const Cells& cells, std::size_t count) {
    std::vector<double> expected(count + 1, cells.total() / static_cast<double>(count));
    expected.back() = 0.0;
    return expected;
}

void count_direction(const Vec3& d, Cells& cells) {
    cells.count(std::min(std::atan2(double(d.y), double(d.x)) / (2.0 * pi) + 0.5, 0.9999999), std::min(0.5 * double(d.z) + 0.5, 0.9999999));
}

TEST(Emission, DirectionsHaveTheirDensity) {
    Numbers numbers;
    for (const EmitterCase& c : emitter_cases()) {
        SCOPED_TRACE(c.name);
        const WorldRecord world = c.world->record();
        const EmitterRecord emitter = c.world->emitters.front();
        Cells around_normal(20, 20);  // of lamps: by the squared sine, evenly
        Cells in_world(24, 24);
        int wrong = 0;
        for (int i = 0; i < draws; ++i) {
            const EmissionSample s = emission_sample(world, emitter, numbers.two(), numbers.two(), numbers.one(), vec4_all(550.0f), true);
            if (!s.valid) {
                continue;  // exactly along the surface
            }
            ASSERT_NEAR(double(length(s.direction)), 1.0, 1e-5);
            ASSERT_TRUE(s.far || !is_black(s.light) || emitter.textured != 0);
            const Vec3 ahead = s.point.position + s.direction * (0.01f * world.scene_radius);
            const EmissionDensity d = emission_density(world, emitter, s.point, s.direction, ahead, s.density.place, true);
            wrong +=
                std::abs(d.direction - s.density.direction) <= 1e-3f * s.density.direction + 1e-5f && d.place == s.density.place ? 0 : 1;
            if (emitter.object >= 0) {
                const Vec3 local = to_local(frame_around(s.point.normal), s.direction);
                around_normal.count(std::min(std::atan2(double(local.y), double(local.x)) / (2.0 * pi) + 0.5, 0.9999999),
                                    std::min(double(local.x * local.x + local.y * local.y), 0.9999999));
            } else if (c.kind != EMITTER_DIRECTIONAL) {
                count_direction(s.direction, in_world);
            } else {
                ASSERT_NEAR(double(dot(s.direction, broadcast(emitter.direction))), 1.0, 1e-6);
            }
        }
        EXPECT_LE(wrong, draws / 1000);
        if (emitter.object >= 0) {
            const Verdict verdict = compare_counts(around_normal.counts(), evenly(around_normal, 400));
            EXPECT_TRUE(verdict.right()) << verdict.words();
        } else if (c.kind != EMITTER_DIRECTIONAL) {
            Pair sum;
            const auto density = [&](double x, double y) {
                const Vec3 direction = direction_of(2.0 * y - 1.0, (2.0 * x - 1.0) * pi);
                const EmissionDensity d = emission_density(world, emitter, no_surface(), direction, vec3_all(0.0f), 1.0f, true);
                return Pair{double(d.direction) * 4.0 * pi, 0.0};
            };
            std::vector<double> expected = in_world.expect(density, 1e-5, sum,
                                                           c.kind == EMITTER_SPOT || c.kind == EMITTER_PROJECTOR ? 5
                                                           : is_thrown(emitter)                                  ? 3
                                                                                                                 : 1);
            EXPECT_NEAR(sum.density, 1.0, 4e-3);
            for (double& count : expected) {
                count /= sum.density;
            }
            expected.back() = 0.0;
            const Verdict verdict = compare_counts(in_world.counts(), expected);
            EXPECT_TRUE(verdict.right()) << verdict.words();
        }
    }
}

TEST(Emission, PlacesHaveTheirDensity) {
    Numbers numbers;
    for (const EmitterCase& c : emitter_cases()) {
        SCOPED_TRACE(c.name);
        const WorldRecord world = c.world->record();
        const EmitterRecord emitter = c.world->emitters.front();
        Cells on_disk_of_scene(20, 20);
        Cells seen(24, 24);  // from the origin
        for (int i = 0; i < draws; ++i) {
            const EmissionSample s = emission_sample(world, emitter, numbers.two(), numbers.two(), numbers.one(), vec4_all(550.0f), true);
            if (s.far) {
                const Vec3 off = s.point.position - broadcast(world.scene_middle) + s.direction * world.scene_radius;
                const Vec3 local = to_local(frame_around(s.direction), off) / world.scene_radius;
                ASSERT_NEAR(double(local.z), 0.0, 1e-4);
                ASSERT_TRUE(comes_through_disk(world, s.point.position + s.direction * 0.01f, s.direction) || length(local) > 0.999f);
                on_disk_of_scene.count(std::min(std::atan2(double(local.y), double(local.x)) / (2.0 * pi) + 0.5, 0.9999999),
                                       std::min(double(dot(local, local)), 0.9999999));
            } else if (emitter.object < 0) {
                ASSERT_EQ(length(s.point.position - broadcast(emitter.position)), 0.0f);
            } else {
                count_direction(normalize(s.point.position), seen);
            }
        }
        if (c.kind == EMITTER_DIRECTIONAL || c.kind == EMITTER_ENVIRONMENT) {
            const Verdict verdict = compare_counts(on_disk_of_scene.counts(), evenly(on_disk_of_scene, 400));
            EXPECT_TRUE(verdict.right()) << verdict.words();
        }
        if (emitter.object < 0) {
            continue;
        }
        Pair sum;
        const auto density = [&](double x, double y) {
            const Vec3 direction = direction_of(2.0 * y - 1.0, (2.0 * x - 1.0) * pi);
            double at = 0.0;
            for (const Met& met : points_along(c, world, direction, true)) {
                const float cosine = std::abs(dot(direction, met.point.normal));
                if (cosine >= 1e-3f) {
                    at += double(place_density(world, emitter, met.point, met.part, true) * dot(met.point.position, met.point.position) /
                                 cosine);
                }
            }
            return Pair{at * 4.0 * pi, 0.0};
        };
        std::vector<double> expected = seen.expect(density, 1e-5, sum, 1);
        // At outlines the density grows without bound and the integral misses a little.
        EXPECT_NEAR(sum.density, 1.0, 6e-3);
        for (double& count : expected) {
            count /= sum.density;
        }
        expected.back() = 0.0;
        const Verdict verdict = compare_counts(seen.counts(), expected);
        EXPECT_TRUE(verdict.right()) << verdict.words();
    }
}

}  // namespace
}  // namespace lancer::statistics
