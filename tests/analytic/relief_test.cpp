// Bent normals: seen from the camera's side, mirroring to above the surface, and no farther bent back than that asks.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "lancer/kernel/relief.h"

namespace lancer::tests {
namespace {

using namespace kernel;

Vec3 random_direction(std::mt19937& random, bool above) {
    std::normal_distribution<float> normal;
    const Vec3 v = normalize(Vec3{normal(random), normal(random), normal(random)});
    return above && v.z < 0.0f ? Vec3{v.x, v.y, -v.z} : v;
}

TEST(BentNormals, MirrorToAboveTheSurface) {
    std::mt19937 random(11);
    const Vec3 up{0.0f, 0.0f, 1.0f};
    int bent = 0;
    for (int i = 0; i < 100000; ++i) {
        const Vec3 view = random_direction(random, true);
        const Vec3 shading = random_direction(random, true);
        const Vec3 n = seen_normal(up, shading, view);
        EXPECT_NEAR(length(n), 1.0f, 1e-5f);
        EXPECT_GT(dot(n, view), 0.0f);
        const float rise = 2.0f * dot(n, view) * n.z - view.z;
        const float least = std::min(0.9f * view.z, 0.01f);
        EXPECT_GT(rise, least - 2e-5f);
        const float before = 2.0f * dot(shading, view) * shading.z - view.z;
        if (dot(shading, view) > 0.0f && before >= least) {
            EXPECT_EQ(n.x, shading.x) << "what is good stays";
            EXPECT_EQ(n.z, shading.z);
        } else {
            ++bent;
            EXPECT_NEAR(rise, least, 2e-4f) << "and what is not is bent just far enough";
            EXPECT_NEAR(dot(cross(up, shading), n), 0.0f, 1e-4f) << "in the plane of both";
        }
    }
    EXPECT_GT(bent, 10000);
}

TEST(BentNormals, OfTheSurfaceItselfStay) {
    std::mt19937 random(5);
    for (int i = 0; i < 10000; ++i) {
        const Vec3 n = random_direction(random, true);
        Vec3 view = random_direction(random, false);
        view = dot(view, n) < 0.0f ? -view : view;
        if (dot(view, n) > 1e-4f) {
            EXPECT_EQ(seen_normal(n, n, view).x, n.x);
        }
    }
}

}  // namespace
}  // namespace lancer::tests
