// The CPU as a device: which variants there are, what it says of itself, any number of points.
#include "lancer/device/cpu/cpu.h"

#include <cstring>
#include <thread>

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

#include "lancer/base/failure.h"
#include "lancer/device/cpu/follow.h"
#include "lancer/world/compile.h"

namespace lancer {
namespace {

std::shared_ptr<const World> spheres(int count) {
    scene::Scene scene;
    scene.cameras.emplace_back();
    scene.materials.emplace_back();
    scene.settings.width = 64;
    scene.settings.height = 48;
    scene.background = {glm::dvec3(0.2, 0.4, 0.9), glm::dvec3(0.8), glm::dvec3(0.1)};
    for (int i = 0; i < count; ++i) {
        scene.objects.push_back({"", scene::Sphere{{(i % 10) - 4.5, (i / 10) - 4.5, -0.3 * i}, 0.45}, 0, glm::dmat4(1.0), {}});
    }
    scene.lights.push_back({"", scene::PointLight{{3.0, 5.0, 9.0}}, glm::dvec3(1.0), 1.0, {}});
    Diagnostics diagnostics;
    return compile_world(scene, scene.cameras[0], diagnostics);
}

std::vector<glm::vec3> follow(const Device& device, const std::vector<glm::vec2>& points) {
    std::vector<glm::vec3> radiance(points.size(), glm::vec3(-1.0f));
    RayCounts counts;
    device.follow(points, radiance, counts);
    EXPECT_EQ(counts.camera, points.size());
    return radiance;
}

std::vector<glm::vec2> all_points() {
    std::vector<glm::vec2> points;
    for (int i = 0; i < 64 * 48; ++i) {
        points.emplace_back(static_cast<float>(i % 64) + 0.5f, static_cast<float>(i / 64) + 0.5f);
    }
    return points;
}

bool same(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(glm::vec3)) == 0;
}

TEST(CpuDevice, VariantsHaveTheLanesAskedFor) {
    const CpuVariant* best = find_cpu_variant();
    ASSERT_NE(best, nullptr);
    for (const int lanes : {4, 8, 16}) {
        if (const CpuVariant* variant = find_cpu_variant(lanes)) {
            EXPECT_EQ(variant->lanes, lanes);
            EXPECT_LE(lanes, best->lanes);
        } else {
            EXPECT_GT(lanes, best->lanes);
        }
    }
    EXPECT_NE(find_cpu_variant(4), nullptr);
    EXPECT_EQ(find_cpu_variant(5), nullptr);
    EXPECT_THROW(make_cpu_device(spheres(1), {.lanes = 5}), MachineFailure);
}

TEST(CpuDevice, SaysWhatItIs) {
    const auto description = [](int count, Tracer tracer) { return make_cpu_device(spheres(count), {.tracer = tracer})->description(); };
    EXPECT_NE(description(3, Tracer::automatic).find("all objects"), std::string::npos);
    EXPECT_NE(description(3, Tracer::tree).find("Embree"), std::string::npos);
    EXPECT_NE(description(100, Tracer::automatic).find("Embree"), std::string::npos);
    EXPECT_NE(description(100, Tracer::all_objects).find("Embree"), std::string::npos) << "more than can be asked one by one";
    EXPECT_EQ(make_cpu_device(spheres(1), {.lanes = 4})->lanes(), 4);
}

TEST(CpuDevice, FewAndManyObjects) {
    for (const int count : {0, 1, 15, 16, 17, 63, 64, 65, 100}) {
        const auto world = spheres(count);
        const auto by_tree = follow(*make_cpu_device(world, {.tracer = Tracer::tree}), all_points());
        EXPECT_TRUE(same(follow(*make_cpu_device(world), all_points()), by_tree)) << count;
        EXPECT_TRUE(same(follow(*make_cpu_device(world, {.tracer = Tracer::all_objects}), all_points()), by_tree)) << count;
    }
}

TEST(CpuDevice, APointDoesNotDependOnItsNeighbours) {
    for (const int count : {20, 100}) {
        const auto device = make_cpu_device(spheres(count));
        const std::vector<glm::vec2> points = all_points();
        const std::vector<glm::vec3> together = follow(*device, points);
        EXPECT_TRUE(follow(*device, {}).empty());
        for (const std::size_t length : {1u, 3u, 15u, 16u, 17u, 100u}) {
            for (const std::size_t first : {0u, 700u, 1533u}) {
                const std::vector<glm::vec2> some(points.begin() + static_cast<std::ptrdiff_t>(first),
                                                  points.begin() + static_cast<std::ptrdiff_t>(first + length));
                const std::vector<glm::vec3> expected(together.begin() + static_cast<std::ptrdiff_t>(first),
                                                      together.begin() + static_cast<std::ptrdiff_t>(first + length));
                EXPECT_TRUE(same(follow(*device, some), expected)) << length << " from " << first;
            }
        }
        // Scattered over the picture, neighbours have nothing in common.
        std::vector<glm::vec2> scattered;
        std::vector<glm::vec3> expected;
        for (std::size_t i = 0; i < points.size(); ++i) {
            scattered.push_back(points[i * 1009 % points.size()]);
            expected.push_back(together[i * 1009 % points.size()]);
        }
        EXPECT_TRUE(same(follow(*device, scattered), expected));
    }
}

TEST(CpuDevice, FollowsFromManyThreadsAtOnce) {
    for (const int count : {20, 100}) {
        const auto device = make_cpu_device(spheres(count), {.threads = 1});
        const std::vector<glm::vec3> expected = follow(*device, all_points());
        std::vector<std::vector<glm::vec3>> results(4);
        std::vector<std::thread> threads;
        for (auto& result : results) {
            threads.emplace_back([&] { result = follow(*device, all_points()); });
        }
        for (std::thread& thread : threads) {
            thread.join();
        }
        for (const auto& result : results) {
            EXPECT_TRUE(same(result, expected));
        }
    }
}

TEST(CpuDevice, TheTreeIsTheSameBuiltByAnyNumberOfThreads) {
    const auto world = spheres(100);
    const auto expected = follow(*make_cpu_device(world, {.threads = 1}), all_points());
    for (const int threads : {2, 3, 8}) {
        EXPECT_TRUE(same(follow(*make_cpu_device(world, {.threads = threads}), all_points()), expected)) << threads;
    }
}

}  // namespace
}  // namespace lancer
