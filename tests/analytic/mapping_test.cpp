// How uv lies on shapes: the kernel's derivatives against differences between neighbouring rays.
#include <cmath>

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

#include "analytic/small_world.h"
#include "lancer/kernel/all_objects.h"
#include "lancer/kernel/material.h"
#include "lancer/world/compile.h"

namespace lancer::tests {
namespace {

using namespace kernel;

struct Met {
    Hit hit;
    SurfacePoint point;
};

Met meet(const WorldRecord& world, const Ray& ray, float width = 0.0f) {
    Met met{closest_of_all(world, ray, true), no_surface()};
    if (met.hit.object >= 0) {
        const ObjectRecord& object = world.objects[met.hit.object];
        met.point = textured_surface(world, object, MATERIAL_MAPPED, ray, met.hit, width, true);
    }
    return met;
}

Ray towards(const glm::vec3& from, const glm::vec3& to) {
    const glm::vec3 d = glm::normalize(to - from);
    return {{from.x, from.y, from.z}, {d.x, d.y, d.z}, FAR};
}

scene::Mesh skewed_triangle(bool with_uvs) {
    auto data = std::make_shared<scene::TriangleMesh>();
    data->positions = {{-1, -1, 0}, {1.2f, -0.8f, 0.2f}, {0.3f, 1.1f, -0.3f}};
    data->triangles = {{0, 1, 2}};
    if (with_uvs) {
        data->uvs = {{0.2f, 0.1f}, {0.5f, 0.9f}, {-0.3f, 0.6f}};
    }
    return {data, false};
}

struct Case {
    const char* name;
    scene::Shape shape;
    glm::dmat4 to_world;
    glm::vec3 target;
};

const glm::dmat4 bent =
    glm::rotate(glm::scale(glm::translate(glm::dmat4(1.0), {0.1, 0.2, -0.3}), {1.0, 1.3, 0.8}), 0.6, glm::normalize(glm::dvec3(1, 2, 3)));

std::vector<Case> cases() {
    const glm::dmat4 one(1.0);
    return {{"sphere", scene::Sphere{{0, 0, 0}, 1.5}, one, {0.3f, 0.4f, 0.0f}},
            {"bent sphere", scene::Sphere{{0, 0, 0}, 1.5}, bent, {0.3f, 0.4f, 0.0f}},
            {"box", scene::Box{{-1, -1, -1}, {1, 2, 1}}, one, {0.3f, 0.4f, 0.0f}},
            {"bent box", scene::Box{{-1, -1, -1}, {1, 2, 1}}, bent, {0.3f, 0.4f, 0.0f}},
            {"plane", scene::Plane{{0, 0, -1}, {0.2, 0.3, 1}}, one, {0.3f, 0.4f, -1.0f}},
            {"bent plane", scene::Plane{{0, 0, -1}, {0.2, 0.3, 1}}, bent, {0.3f, 0.4f, -1.0f}},
            {"disk", scene::Disk{{0, 0, 0}, {0.1, 0.3, 1}, 2}, bent, {0.3f, 0.4f, 0.0f}},
            {"cylinder", scene::Cylinder{{0, -2, 0}, {0, 2, 0}, 1}, one, {0.3f, 0.4f, 0.0f}},
            {"cone", scene::Cone{{0, -2, 0}, {0.3, 2, 0}, 1.5, 0.5}, bent, {0.3f, 0.4f, 0.0f}},
            {"triangle without uv", skewed_triangle(false), bent, {0.2f, -0.2f, 0.0f}},
            {"triangle", skewed_triangle(true), bent, {0.2f, -0.2f, 0.0f}}};
}

TEST(Mapping, DerivativesAreThoseOfNeighbours) {
    for (const Case& c : cases()) {
        SmallWorld small;
        small.scene.settings.integrator = "path";
        scene::Material material;
        material.model = scene::DiffuseMaterial{scene::Checker{}, 0.0};
        small.scene.materials.push_back(material);
        small.add(c.shape, 0, c.to_world);
        const auto world = small.compile();
        const WorldRecord record = world->record();
        const glm::vec3 eye(0.5f, 0.8f, 6.0f);
        const Met here = meet(record, towards(eye, c.target));
        ASSERT_GE(here.hit.object, 0) << c.name;
        const UvAxes axes{here.point.along_u, here.point.along_v};
        for (const glm::vec3 off : {glm::vec3(0.01f, 0.0f, 0.0f), glm::vec3(0.0f, 0.01f, 0.0f), glm::vec3(-0.008f, 0.006f, 0.0f)}) {
            // Both ways, so that curvature cancels.
            const Met one = meet(record, towards(eye, c.target + off));
            const Met two = meet(record, towards(eye, c.target - off));
            const Vec3 moved = one.point.position - two.point.position;
            const Vec2 predicted = uv_along(axes, moved);
            const float size = std::hypot(predicted.x, predicted.y);
            EXPECT_NEAR(one.point.uv.x - two.point.uv.x, predicted.x, 0.01f * size + 2e-5f) << c.name;
            EXPECT_NEAR(one.point.uv.y - two.point.uv.y, predicted.y, 0.01f * size + 2e-5f) << c.name;
            // And along them one gets to the neighbour.
            const Vec3 back = axes.u * predicted.x + axes.v * predicted.y;
            EXPECT_LT(length(back - moved), 0.02f * length(moved) + 1e-4f) << c.name;
        }
    }
}

// The ellipse that a cone of rays cuts out: its diameters against where the rays at its rim arrive.
TEST(Mapping, ABeamCoversWhatItsRimEncloses) {
    for (const Case& c : cases()) {
        SmallWorld small;
        small.scene.settings.integrator = "path";
        scene::Material material;
        material.model = scene::DiffuseMaterial{scene::Checker{}, 0.0};
        small.scene.materials.push_back(material);
        small.add(c.shape, 0, c.to_world);
        const auto world = small.compile();
        const WorldRecord record = world->record();
        const glm::vec3 eye(0.5f, 0.8f, 6.0f);
        const Ray ray = towards(eye, c.target);
        const float spread = 0.004f;
        const Hit hit = closest_of_all(record, ray, true);
        const Met met = meet(record, ray, spread * hit.t);
        // The square of the ellipse's size in uv: both diameters as columns of a matrix.
        const float area = met.point.across.x * met.point.down.y - met.point.across.y * met.point.down.x;
        const Frame frame = frame_around(ray.direction);
        float rim_area = 0.0f;
        Vec2 before{0.0f, 0.0f};
        for (int i = 0; i <= 32; ++i) {
            const float angle = static_cast<float>(i) * 2.0f * PI / 32.0f;
            const Vec3 off = (frame.x * std::cos(angle) + frame.y * std::sin(angle)) * (0.5f * spread);
            const Ray rim{ray.origin, normalize(ray.direction + off), FAR};
            const Met there = meet(record, rim);
            const Vec2 now{there.point.uv.x - met.point.uv.x, there.point.uv.y - met.point.uv.y};
            rim_area += i > 0 ? 0.5f * (before.x * now.y - before.y * now.x) : 0.0f;
            before = now;
        }
        EXPECT_NEAR(std::abs(area) * PI / 4.0f, std::abs(rim_area), 0.05f * std::abs(rim_area)) << c.name;
    }
}

}  // namespace
}  // namespace lancer::tests
