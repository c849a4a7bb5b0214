// Points and directions made of two uniform numbers, and visible facets.
#include "lancer/kernel/warp.h"

#include <cmath>
#include <functional>
#include <random>

#include <gtest/gtest.h>

#include "lancer/kernel/bsdf/microfacet.h"
#include "statistics/bsdf_cases.h"
#include "statistics/chi_squared.h"

namespace lancer::statistics {
namespace {

using namespace kernel;

constexpr double pi = 3.14159265358979323846;

struct Place {
    double x, y;
};

Verdict check(const std::function<Place(Vec2)>& draw, const std::function<double(double, double)>& density) {
    std::mt19937 numbers(3);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    Cells cells(30, 20);
    for (int i = 0; i < 200000; ++i) {
        const float u = std::min(uniform(numbers), 0.99999994f);
        const Place place = draw(vec2_of(u, std::min(uniform(numbers), 0.99999994f)));
        cells.count(place.x, place.y);
    }
    Pair sum;
    const auto expected = cells.expect([&](double x, double y) { return Pair{density(x, y), 0.0}; }, 1e-7, sum);
    EXPECT_NEAR(sum.density, 1.0, 1e-3);
    return compare_counts(cells.counts(), expected);
}

Place place_of(const Vec3& w) { return {std::atan2(double(w.y), double(w.x)) / (2.0 * pi) + 0.5, 0.5 * double(w.z) + 0.5}; }

TEST(Warp, Disk) {
    const Verdict verdict = check(
        [](Vec2 u) {
            const Vec2 p = on_disk(u);
            const double x = double(p.x);
            const double y = double(p.y);
            EXPECT_LE(x * x + y * y, 1.000001);
            return Place{x * x + y * y, std::atan2(y, x) / (2.0 * pi) + 0.5};
        },
        [](double, double) { return 1.0; });
    EXPECT_TRUE(verdict.right()) << verdict.words();
}

TEST(Warp, CosineHemisphere) {
    const Verdict verdict =
        check([](Vec2 u) { return place_of(cosine_hemisphere(u)); }, [](double, double y) { return std::max(4.0 * (2.0 * y - 1.0), 0.0); });
    EXPECT_TRUE(verdict.right()) << verdict.words();
}

TEST(Warp, Sphere) {
    const Verdict verdict = check([](Vec2 u) { return place_of(on_sphere(u)); }, [](double, double) { return 1.0; });
    EXPECT_TRUE(verdict.right()) << verdict.words();
}

TEST(Warp, Triangle) {
    // (b1, b2) with b1 + b2 <= 1: s = b1 + b2 has density 2 s, b1 / s is uniform.
    const Verdict verdict = check(
        [](Vec2 u) {
            const Vec2 b = on_triangle(u);
            EXPECT_GE(b.x, 0.0f);
            EXPECT_GE(b.y, 0.0f);
            const double s = double(b.x) + double(b.y);
            return Place{s, s > 0.0 ? double(b.x) / s : 0.0};
        },
        [](double x, double) { return 2.0 * x; });
    EXPECT_TRUE(verdict.right()) << verdict.words();
}

Facets facets(float x, float y, bool beckmann) {
    Facets f;
    f.x = x;
    f.y = y;
    f.beckmann = beckmann;
    f.separate = false;
    f.once = false;
    return f;
}

TEST(Warp, VisibleNormals) {
    for (const bool beckmann : {false, true}) {
        for (const auto& [x, y] : {std::pair{0.1f, 0.1f}, {0.5f, 0.5f}, {1.0f, 1.0f}, {0.1f, 0.6f}, {1.0f, 0.3f}}) {
            for (const double cosine : {1.0, 0.7, 0.2, 0.02}) {
                SCOPED_TRACE(testing::Message() << (beckmann ? "Beckmann's " : "GGX ") << x << " " << y << " from cosine " << cosine);
                const Facets f = facets(x, y, beckmann);
                const Vec3 wo = direction_of(cosine, 0.9);
                const Verdict verdict = check([&](Vec2 u) { return place_of(facets_visible_normal(f, wo, u)); },
                                              [&](double across, double up) {
                                                  const Vec3 m = direction_of(2.0 * up - 1.0, (2.0 * across - 1.0) * pi);
                                                  return m.z > 0.0f ? double(facets_visible_density(f, wo, m)) * 4.0 * pi : 0.0;
                                              });
                EXPECT_TRUE(verdict.right()) << verdict.words();
            }
        }
    }
}

// What is seen of all facets together is the surface itself: the integral of D (n.m) is 1.
TEST(Warp, FacetsCoverTheSurface) {
    for (const bool beckmann : {false, true}) {
        for (const auto& [a, b] : {std::pair{0.05f, 0.05f}, {0.5f, 0.5f}, {1.0f, 1.0f}, {0.1f, 0.6f}}) {
            const Facets f = facets(a, b, beckmann);
            const auto covered = [&](double x, double y) {
                const Vec3 m = direction_of(y, 2.0 * pi * x);
                return Pair{double(facets_density(f, m)) * y * 2.0 * pi, 0.0};
            };
            EXPECT_NEAR(integrate(covered, 0.0, 1.0, 0.0, 1.0, 1e-6, 4, 12).density, 1.0, 1e-4) << a << " " << b;
        }
    }
}

}  // namespace
}  // namespace lancer::statistics
