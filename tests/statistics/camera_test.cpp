// Where rays begin: on the film as the pixel's filter says, evenly on the lens. Every kind of camera, every filter.
#include "lancer/kernel/camera.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "lancer/kernel/pixel_filter.h"
#include "lancer/kernel/warp.h"
#include "lancer/world/compile.h"
#include "lancer/world/filters.h"
#include "statistics/chi_squared.h"

namespace lancer::statistics {
namespace {

using namespace kernel;

constexpr double pi = 3.14159265358979323846;

struct CameraCase {
    std::string name;
    int kind = 0;
    scene::Camera camera;
};

std::vector<CameraCase> camera_cases() {
    scene::Camera turned;
    turned.position = {0.3, -0.2, 0.5};
    turned.direction = {0.4, -0.3, -0.8};
    std::vector<CameraCase> cases;
    cases.push_back({"pinhole", CAMERA_PERSPECTIVE, turned});
    cases.push_back({"lens", CAMERA_PERSPECTIVE, turned});
    cases.back().camera.aperture = 0.4;
    cases.back().camera.focus_distance = 3.0;
    cases.push_back({"orthographic", CAMERA_ORTHOGRAPHIC, turned});
    cases.back().camera.projection = scene::Projection::orthographic;
    cases.push_back({"panorama", CAMERA_PANORAMA, turned});
    cases.back().camera.projection = scene::Projection::panorama;
    return cases;
}

std::shared_ptr<const World> seen_by(const scene::Camera& camera, scene::PixelFilter filter) {
    scene::Scene scene;
    scene.settings.integrator = "path";
    scene.settings.rgb = true;
    scene.settings.width = 16;
    scene.settings.height = 8;
    scene.settings.filter = filter;
    scene::Material material;
    material.model = scene::DiffuseMaterial{};
    scene.materials.push_back(material);
    scene::Object ball;
    ball.shape = scene::Sphere{};
    scene.objects.push_back(ball);
    scene.cameras.push_back(camera);
    Diagnostics diagnostics;
    auto world = compile_world(scene, camera, diagnostics);
    EXPECT_TRUE(world);
    return world;
}

double along(const Vec3& v, const vec3& axis) {
    const Vec3 a = broadcast(axis);
    return static_cast<double>(dot(v, a)) / static_cast<double>(dot(a, a));
}

// The point of the film, in pixels, whose light the ray carries.
Vec2 film_point(const CameraRecord& camera, const Ray& ray) {
    Vec3 place = ray.origin - broadcast(camera.corner);
    if (camera.kind == CAMERA_PERSPECTIVE) {
        const float focus = camera.lens_radius > 0.0f ? camera.focus_distance : 1.0f;
        const Vec3 sharp = ray.origin + ray.direction * (focus / dot(ray.direction, broadcast(camera.forward)));
        place = (sharp - broadcast(camera.position)) * (1.0f / focus) - broadcast(camera.corner);
    } else if (camera.kind == CAMERA_PANORAMA) {
        const double forward = along(ray.direction, camera.forward), right = along(ray.direction, camera.right);
        const double turn = std::atan2(right, forward) / (2.0 * pi) + 0.5;
        const double tilt = std::acos(-along(ray.direction, camera.down)) / pi;
        return vec2_of(static_cast<float>(turn) * camera.width, static_cast<float>(tilt) * camera.height);
    }
    return vec2_of(static_cast<float>(along(place, camera.step_x)), static_cast<float>(along(place, camera.step_y)));
}

TEST(Camera, EveryKindIsTested) {
    std::set<int> kinds;
    for (const CameraCase& c : camera_cases()) {
        kinds.insert(c.kind);
    }
    EXPECT_EQ(kinds.size(), static_cast<std::size_t>(CAMERA_KINDS)) << "a kind of camera has no case in tests/statistics/camera_test.cpp";
}

TEST(Camera, DrawsFilmAndLens) {
    std::mt19937 numbers(11);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    const auto next = [&] { return std::min(uniform(numbers), 0.99999994f); };
    constexpr int draws = 60000;
    const double radius = usual_radius(scene::PixelFilter::tent);
    for (const CameraCase& c : camera_cases()) {
        SCOPED_TRACE(c.name);
        const auto world = seen_by(c.camera, scene::PixelFilter::tent);
        ASSERT_TRUE(world);
        const WorldRecord record = world->record();
        ASSERT_EQ(record.camera.kind, c.kind);
        Cells film(20, 20), lens(20, 20);
        for (int i = 0; i < draws; ++i) {
            const FilterSample across = sample_filter(record, next(), true);
            const FilterSample down = sample_filter(record, next(), true);
            const Vec2 u = vec2_of(next(), next());
            const Vec2 on_lens = c.camera.aperture > 0.0 ? on_disk(u) : vec2_of(0.0f, 0.0f);
            const Ray ray = lens_ray(record.camera, 5.5f + across.place, 3.5f + down.place, on_lens);
            ASSERT_NEAR(double(length(ray.direction)), 1.0, 1e-5);
            const Vec2 met = film_point(record.camera, ray);
            film.count((double(met.x) - 5.5) / (2.0 * radius) + 0.5, (double(met.y) - 3.5) / (2.0 * radius) + 0.5);
            if (record.camera.lens_radius > 0.0f) {
                const Vec3 off = (ray.origin - broadcast(record.camera.position)) * (1.0f / record.camera.lens_radius);
                ASSERT_NEAR(along(off, record.camera.forward), 0.0, 1e-4);
                lens.count(0.5 * along(off, record.camera.right) + 0.5, 0.5 * along(off, record.camera.down) + 0.5);
            }
        }
        Pair sum;
        const auto filter = [&](double x) {
            return 2.0 * radius * filter_value(scene::PixelFilter::tent, radius, (2.0 * x - 1.0) * radius);
        };
        // The filter's value is not normed; its integral is found along with those over the cells.
        std::vector<double> expected = film.expect([&](double x, double y) { return Pair{filter(x) * filter(y), 0.0}; }, 1e-6, sum);
        for (double& count : expected) {
            count /= sum.density;
        }
        expected.back() = 0.0;
        const Verdict on_film = compare_counts(film.counts(), expected);
        EXPECT_TRUE(on_film.right()) << on_film.words();
        if (lens.total() > 0.0) {
            expected = lens.expect(
                [](double x, double y) {
                    const double a = 2.0 * x - 1.0, b = 2.0 * y - 1.0;
                    return Pair{a * a + b * b < 1.0 ? 4.0 / pi : 0.0, 0.0};
                },
                1e-5, sum, 4);
            EXPECT_NEAR(sum.density, 1.0, 1e-3);
            for (double& count : expected) {
                count /= sum.density;
            }
            expected.back() = 0.0;
            const Verdict on_the_lens = compare_counts(lens.counts(), expected);
            EXPECT_TRUE(on_the_lens.right()) << on_the_lens.words();
        }
    }
}

// A filter that is missing here is an error of the compiler.
std::optional<scene::PixelFilter> filter_after(scene::PixelFilter filter) {
    switch (filter) {
        case scene::PixelFilter::box:
            return scene::PixelFilter::tent;
        case scene::PixelFilter::tent:
            return scene::PixelFilter::gaussian;
        case scene::PixelFilter::gaussian:
            return scene::PixelFilter::mitchell;
        case scene::PixelFilter::mitchell:
            return scene::PixelFilter::blackman_harris;
        case scene::PixelFilter::blackman_harris:
            break;
    }
    return std::nullopt;
}

// A filter that is negative somewhere is drawn by its size there.
TEST(Camera, DrawsEveryFilter) {
    std::mt19937 numbers(12);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    constexpr int draws = 100000, cells = 40, steps = 40000;
    for (std::optional<scene::PixelFilter> next = scene::PixelFilter::box; next; next = filter_after(*next)) {
        const scene::PixelFilter filter = *next;
        const auto world = seen_by({}, filter);
        ASSERT_TRUE(world);
        const WorldRecord record = world->record();
        const double radius = usual_radius(filter);
        std::vector<double> counts(cells), expected(cells);
        for (int i = 0; i < draws; ++i) {
            const double place = double(sample_filter(record, std::min(uniform(numbers), 0.99999994f), true).place);
            counts[static_cast<std::size_t>(std::clamp((place / radius + 1.0) * 0.5 * cells, 0.0, cells - 0.5))] += 1.0;
        }
        double total = 0.0;
        for (int i = 0; i < steps; ++i) {
            const double size = std::abs(filter_value(filter, radius, radius * (2.0 * (i + 0.5) / steps - 1.0)));
            expected[static_cast<std::size_t>(i * cells / steps)] += size;
            total += size;
        }
        for (double& count : expected) {
            count *= draws / total;
        }
        const Verdict verdict = compare_counts(counts, expected);
        EXPECT_TRUE(verdict.right()) << static_cast<int>(filter) << ": " << verdict.words();
    }
}

}  // namespace
}  // namespace lancer::statistics
