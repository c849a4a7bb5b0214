// Points seen by the camera are the points that its rays go to, as often as its density says.
#include "lancer/kernel/importance.h"

#include <cmath>

#include <gtest/gtest.h>

#include "analytic/small_world.h"
#include "lancer/world/compile.h"

namespace lancer::tests {
namespace {

using namespace kernel;

CameraRecord camera_of(scene::Projection projection, double aperture) {
    SmallWorld world;
    scene::Camera& camera = world.scene.cameras[0];
    camera.position = {1.0, 2.0, 3.0};
    camera.direction = {0.3, -0.2, -1.0};
    camera.projection = projection;
    camera.aperture = aperture;
    camera.focus_distance = 4.0;
    camera.fov = 70.0;
    world.scene.settings.width = 40;
    world.scene.settings.height = 24;
    world.add(scene::Sphere{{0.0, 0.0, 0.0}, 1.0}, world.add(matte()));
    return world.compile()->camera;
}

class Importance : public testing::TestWithParam<std::pair<scene::Projection, double>> {};

TEST_P(Importance, APointIsSeenWhereItsRayBegan) {
    const CameraRecord camera = camera_of(GetParam().first, GetParam().second);
    for (const float x : {0.5f, 13.0f, 39.2f}) {
        for (const float y : {0.7f, 11.0f, 23.0f}) {
            for (const float distance : {0.5f, 9.0f}) {
                const Vec2 lens = vec2_of(0.3f, -0.6f);
                const Ray ray = lens_ray(camera, x, y, lens);
                const Vec3 point = ray.origin + ray.direction * distance;
                const CameraSight s = see_point(camera, point, lens, 1.0f);
                ASSERT_TRUE(s.valid);
                EXPECT_NEAR(double(s.film.x), double(x), 2e-4);
                EXPECT_NEAR(double(s.film.y), double(y), 2e-4);
                EXPECT_NEAR(double(s.distance), double(distance), 1e-5);
                EXPECT_NEAR(double(dot(s.direction, ray.direction)), -1.0, 1e-6);
                // How far the point moves across the ray with the point of the film.
                const float step = 0.25f;
                const auto across = [&](float dx, float dy) {
                    const Ray a = lens_ray(camera, x + dx, y + dy, lens);
                    const Ray b = lens_ray(camera, x - dx, y - dy, lens);
                    return (a.origin + a.direction * distance - b.origin - b.direction * distance) / (2.0f * step);
                };
                const Vec3 area = cross(across(step, 0.0f), across(0.0f, step));
                EXPECT_NEAR(double(s.density * std::abs(dot(area, ray.direction))), 1.0, 2e-3);
            }
        }
    }
}

TEST_P(Importance, WhatLiesBehindIsNotSeen) {
    const CameraRecord camera = camera_of(GetParam().first, GetParam().second);
    const Vec3 behind = broadcast(camera.position) - broadcast(camera.forward) * 2.0f;
    EXPECT_EQ(see_point(camera, behind, vec2_of(0.0f, 0.0f), 1.0f).valid, GetParam().first == scene::Projection::panorama);
}

INSTANTIATE_TEST_SUITE_P(Cameras, Importance,
                         testing::Values(std::pair{scene::Projection::perspective, 0.0}, std::pair{scene::Projection::perspective, 0.3},
                                         std::pair{scene::Projection::orthographic, 0.0}, std::pair{scene::Projection::panorama, 0.0}));

}  // namespace
}  // namespace lancer::tests
