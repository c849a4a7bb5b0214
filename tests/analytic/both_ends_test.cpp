// Light tracing and bidirectional paths against closed forms.
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

#include "analytic/small_world.h"
#include "lancer/device/cpu/cpu.h"
#include "lancer/world/compile.h"

namespace lancer::tests {
namespace {

using std::numbers::pi;

struct Estimate {
    glm::dvec3 mean{0.0};
    glm::dvec3 error{0.0};  // standard error of the mean
};

// The mean of the whole picture, over independent renders.
Estimate mean_of_picture(SmallWorld world, const std::string& integrator, int size, int spp, int renders = 16) {
    world.scene.settings.integrator = integrator;
    world.scene.settings.width = world.scene.settings.height = size;
    glm::dvec3 sum(0.0), squares(0.0);
    for (int i = 0; i < renders; ++i) {
        world.scene.settings.seed = i;
        const auto device = make_cpu_device(world.compile());
        const PathRange range{0, 0, size, size, 0, spp};
        std::vector<glm::vec3> radiance(range.paths());
        std::vector<Splat> splats;
        RayCounts counts;
        device->trace_paths(range, {radiance, {}, {}, {}, &splats}, counts);
        glm::dvec3 one(0.0);
        for (const glm::vec3& c : radiance) {
            one += glm::dvec3(double(c.x), double(c.y), double(c.z));
        }
        for (const Splat& s : splats) {
            one += glm::dvec3(double(s.light.x), double(s.light.y), double(s.light.z));
        }
        one /= static_cast<double>(radiance.size());
        sum += one;
        squares += one * one;
    }
    const double n = renders;
    Estimate e;
    e.mean = sum / n;
    e.error = glm::sqrt(glm::max(squares / n - e.mean * e.mean, glm::dvec3(0.0)) / (n - 1.0));
    return e;
}

scene::Material diffuse(double albedo, double emission = 0.0, bool both_sides = false) {
    scene::Material material;
    material.model = scene::DiffuseMaterial{scene::Rgb(albedo), 0.0};
    if (emission > 0.0) {
        material.emission = scene::Emission{scene::Rgb(1.0), emission, both_sides};
    }
    return material;
}

class Physical : public SmallWorld {
public:
    explicit Physical(int bounces) {
        scene.settings.integrator = "path";
        scene.settings.bounces = bounces;
        scene.settings.rgb = true;
        scene.settings.filter = scene::PixelFilter::box;
    }
    int material(const scene::Material& m) {
        scene.materials.push_back(m);
        return static_cast<int>(scene.materials.size()) - 1;
    }
};

scene::Mesh rectangle(const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v) {
    auto data = std::make_shared<scene::TriangleMesh>();
    data->positions = {corner, corner + u, corner + u + v, corner + v};
    data->triangles = {{0, 1, 2}, {0, 2, 3}};
    return {data, false};
}

// Within 0.1 % of the truth, and of what chance allows: 4 standard errors are passed by in one of 16 000 comparisons.
void expect_near(const Estimate& e, double truth, double most_error) {
    EXPECT_NEAR(e.mean.y, truth, 0.001 * truth + 4.0 * e.error.y);
    EXPECT_LT(e.error.y, most_error * truth);
}

class BothEnds : public testing::TestWithParam<const char*> {};

TEST_P(BothEnds, FurnaceIsAsBrightAsItsSeries) {
    for (const bool rgb : {true, false}) {
        Physical world(1000);
        world.scene.settings.rgb = rgb;
        world.add(scene::Sphere{{0.0, 0.0, 5.0}, 2.0}, world.material(diffuse(0.5, 1.0, true)));
        expect_near(mean_of_picture(world, GetParam(), 16, 256), 2.0, 0.002);
    }
}

// Two unit squares that face each other at a distance of 1 [Howell's catalogue, C-11].
TEST_P(BothEnds, FormFactorOfFacingSquares) {
    const double factor = 0.1998249;
    Physical world(1);
    world.add(rectangle({-0.5f, 0.0f, 0.5f}, {1.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -1.0f}), world.material(diffuse(1.0)));
    world.add(rectangle({-0.5f, 1.0f, -0.5f}, {1.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}), world.material(diffuse(0.0, 1.0)));
    world.look({0.0, 0.9, 0.0}, {0.0, -1.0, 0.0}, {0.0, 0.0, -1.0});
    scene::Camera& camera = world.scene.cameras[0];
    camera.projection = scene::Projection::orthographic;
    camera.extent = 1.0;
    expect_near(mean_of_picture(world, GetParam(), 8, 512), factor, 0.004);
}

// A point light over the middle of a square: the irradiance integrates to the power that the square catches, intensity times its solid angle.
Physical lit_square() {
    Physical world(1);
    world.add(rectangle({-0.5f, 0.0f, 0.5f}, {1.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -1.0f}), world.material(diffuse(1.0)));
    scene::Light light;
    light.model = scene::PointLight{{0.0, 0.7, 0.0}};
    light.power = scene::Rgb(3.0);
    world.scene.lights.push_back(light);
    world.look({0.0, 0.5, 0.0}, {0.0, -1.0, 0.0}, {0.0, 0.0, -1.0});
    world.scene.cameras[0].projection = scene::Projection::orthographic;
    world.scene.cameras[0].extent = 1.0;
    return world;
}

const double caught_by_square = 3.0 / pi * 4.0 * std::asin(0.25 / (0.25 + 0.7 * 0.7));

TEST_P(BothEnds, ASquareUnderAPointLightCatchesItsSolidAngle) {
    expect_near(mean_of_picture(lit_square(), GetParam(), 8, 512), caught_by_square, 0.004);
}

// In the inmost of five bodies, the largest of which fills the place of all: light finds it as the rays that ask the lamp do.
TEST_P(BothEnds, ALampShinesOutOfFiveBodies) {
    Physical world = lit_square();
    for (int i = 0; i < 5; ++i) {
        scene::Medium medium;
        medium.coefficients = scene::AbsorbingScattering{scene::Rgb(i == 4 ? 4.0 : 0.5), scene::Rgb(0.0)};
        world.scene.media.push_back(medium);
        scene::Material border;
        border.model = scene::NullMaterial{};
        border.interior = i;
        border.priority = i == 4 ? 1 : -i;
        world.add(scene::Sphere{{0.0, 0.7, 0.0}, 0.03 * (i + 1)}, world.material(border));
    }
    expect_near(mean_of_picture(world, GetParam(), 8, 512), caught_by_square * std::exp(-4.0 * 0.15), 0.004);
}

// Light from everywhere on a ball that loses nothing: it can't be told from the sky.
TEST_P(BothEnds, AWhiteBallVanishesUnderAnEvenSky) {
    Physical world(1000);
    world.add(scene::Sphere{{0.0, 0.0, 0.0}, 1.0}, world.material(diffuse(1.0)));
    world.set_background(1.0, 1.0, 1.0);
    world.look({0.0, 0.0, 4.0}, {0.0, 0.0, -1.0});
    world.scene.cameras[0].fov = 20.0;
    expect_near(mean_of_picture(world, GetParam(), 16, 256), 1.0, 0.008);
}

// The same through a lens: what is out of focus is spread, not lost.
TEST_P(BothEnds, ALensLosesNoLight) {
    Physical world(1000);
    world.add(scene::Sphere{{0.0, 0.0, 5.0}, 2.0}, world.material(diffuse(0.5, 1.0, true)));
    world.scene.cameras[0].aperture = 0.5;
    world.scene.cameras[0].focus_distance = 1.0;
    expect_near(mean_of_picture(world, GetParam(), 16, 64), 2.0, 0.003);
}

INSTANTIATE_TEST_SUITE_P(Integrators, BothEnds, testing::Values("light", "bdpt"), [](const auto& one) { return std::string(one.param); });

// Photons are many for each sample, so that few samples tell as much. They are gathered from disks, on a ball that is hardly curved across one.
TEST(Photons, FurnaceIsAsBrightAsItsSeries) {
    Physical world(100);
    world.add(scene::Sphere{{0.0, 0.0, 5.0}, 2.0}, world.material(diffuse(0.5, 1.0, true)));
    expect_near(mean_of_picture(world, "vcm", 16, 4, 8), 2.0, 0.005);
}

TEST(Photons, AWhiteBallVanishesUnderAnEvenSky) {
    Physical world(100);
    world.add(scene::Sphere{{0.0, 0.0, 0.0}, 1.0}, world.material(diffuse(1.0)));
    world.set_background(1.0, 1.0, 1.0);
    world.look({0.0, 0.0, 4.0}, {0.0, 0.0, -1.0});
    world.scene.cameras[0].fov = 20.0;
    expect_near(mean_of_picture(world, "vcm", 16, 4, 8), 1.0, 0.02);
}

// A clear sphere around a lamp, in a white room: refraction squeezes radiance and not power, both halves must know. What is lit is as bright as
// without the glass but for what the glass throws back, which returns: a furnace.
TEST(Bidirectional, GlassInAFurnaceVanishes) {
    for (const double roughness : {0.0, 0.3}) {
        Physical world(1000);
        world.add(scene::Sphere{{0.0, 0.0, 5.0}, 2.0}, world.material(diffuse(0.5, 1.0, true)));
        scene::Material glass;
        glass.model = scene::DielectricMaterial{1.5, scene::Color(scene::Rgb(1.0)), roughness};
        world.add(scene::Sphere{{0.0, 0.0, 3.9}, 0.6}, world.material(glass));
        expect_near(mean_of_picture(world, "bdpt", 16, 64), 2.0, 0.003);
    }
}

// A picture is its camera's half and its splats; alone, each is darker.
TEST(Bidirectional, LightAloneMissesMirrors) {
    Physical world(4);
    scene::Material mirror;
    mirror.model = scene::ConductorMaterial{};
    world.add(scene::Sphere{{0.0, 0.0, 0.0}, 1.0}, world.material(mirror));
    world.set_background(1.0, 1.0, 1.0);
    world.look({0.0, 0.0, 2.0}, {0.0, 0.0, -1.0});
    world.scene.cameras[0].fov = 20.0;
    EXPECT_EQ(mean_of_picture(world, "light", 8, 16, 2).mean.y, 0.0);
    expect_near(mean_of_picture(world, "bdpt", 8, 16), 1.0, 0.001);
}

}  // namespace
}  // namespace lancer::tests
