// Where cameras of each kind see things, with Whitted's integrator: each has its own closed form.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "analytic/small_world.h"

namespace lancer::tests {
namespace {

SmallWorld with_camera(scene::Projection projection, int width, int height) {
    SmallWorld world;
    world.scene.settings.width = width;
    world.scene.settings.height = height;
    world.scene.cameras[0].projection = projection;
    world.scene.ambient = glm::dvec3(1.0);
    return world;
}

bool sees_red(const SmallWorld& world, double x, double y) { return world.at({x, y}).x > 0.5; }

TEST(Camera, OrthographicSeesABallAsItsCircleHoweverFar) {
    for (const double distance : {2.0, 50.0}) {
        SmallWorld world = with_camera(scene::Projection::orthographic, 200, 100);
        world.scene.cameras[0].extent = 8.0;  // 25 pixels a metre
        world.add(scene::Sphere{{1.0, 0.5, 5.0 - distance}, 1.0}, world.add(glowing(1.0, {1.0, 0.0, 0.0})));
        const glm::dvec2 middle(125.0, 37.5);
        for (const double angle : {0.0, 0.8, 1.6, 2.4, 3.2, 4.0, 4.8, 5.6}) {
            const glm::dvec2 out(std::cos(angle), std::sin(angle));
            const glm::dvec2 within = middle + 24.9 * out, beyond = middle + 25.1 * out;
            EXPECT_TRUE(sees_red(world, within.x, within.y)) << angle;
            EXPECT_FALSE(sees_red(world, beyond.x, beyond.y)) << angle;
        }
    }
}

TEST(Camera, PanoramaSeesAllAround) {
    struct Place {
        glm::dvec3 direction;
        double x, y;
    };
    // It looks along -z; +x is to the right.
    const Place places[] = {{{0.0, 0.0, -1.0}, 200.0, 100.0}, {{1.0, 0.0, 0.0}, 300.0, 100.0}, {{-1.0, 0.0, 0.0}, 100.0, 100.0},
                            {{0.0, 0.0, 1.0}, 0.5, 100.0},    {{0.0, 1.0, 0.0}, 37.0, 0.5},    {{0.0, -1.0, 0.0}, 211.0, 199.5},
                            {{1.0, 1.0, 0.0}, 300.0, 50.0}};
    for (const Place& place : places) {
        SmallWorld world = with_camera(scene::Projection::panorama, 400, 200);
        const glm::dvec3 towards = glm::normalize(place.direction);
        world.add(scene::Sphere{glm::dvec3(0.0, 0.0, 5.0) + 3.0 * towards, 0.1}, world.add(glowing(1.0, {1.0, 0.0, 0.0})));
        EXPECT_TRUE(sees_red(world, place.x, place.y)) << place.x << ", " << place.y;
        EXPECT_FALSE(sees_red(world, 250.0, 120.0));
        // A radius of 0.1 at 3 m is an angle of asin(1/30): 2.12 pixels along the horizon.
        if (place.direction.y == 0.0 && place.x > 1.0) {
            const double radius = std::asin(0.1 / 3.0) / (2.0 * std::numbers::pi) * 400.0;
            EXPECT_TRUE(sees_red(world, place.x + radius - 0.05, place.y));
            EXPECT_FALSE(sees_red(world, place.x + radius + 0.05, place.y));
        }
    }
}

TEST(Camera, WhittedLooksThroughTheMiddleOfTheLens) {
    SmallWorld world = with_camera(scene::Projection::perspective, 101, 101);
    world.add(scene::Sphere{{0.3, 0.2, 0.0}, 1.0}, world.add(glowing(1.0, {1.0, 0.0, 0.0})));
    const auto sharp = world.picture(41);
    world.scene.cameras[0].aperture = 1.0;
    world.scene.cameras[0].focus_distance = 2.0;
    EXPECT_EQ(world.picture(41), sharp);
}

}  // namespace
}  // namespace lancer::tests
