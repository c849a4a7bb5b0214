// Lights that throw a picture: where it lands, how bright it is, and that directions are drawn by it.
#include "lancer/kernel/emitter/emitter.h"

#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "lancer/image/image.h"
#include "lancer/world/compile.h"
#include "statistics/bsdf_cases.h"
#include "statistics/chi_squared.h"

namespace lancer::statistics {
namespace {

using namespace kernel;

constexpr double pi = 3.14159265358979323846;

template <class Model>
std::shared_ptr<const World> lit_by(const Model& model, const scene::Color& power = scene::Rgb(2.0)) {
    scene::Scene scene;
    scene.settings.integrator = "path";
    scene.settings.rgb = true;
    scene.cameras.push_back({});
    scene::Light light;
    light.model = model;
    light.power = power;
    scene.lights.push_back(light);
    Diagnostics diagnostics;
    auto world = compile_world(scene, scene.cameras.front(), diagnostics);
    EXPECT_TRUE(world);
    return world;
}

scene::ImageTexture picture(const std::string& name, int width, int height, std::vector<float> grey) {
    const std::string file = testing::TempDir() + name + ".exr";
    write_image(file, Image{width, height, 1, std::move(grey)}, {});
    scene::ImageTexture texture;
    texture.file = file;
    return texture;
}

scene::IesLight lamp(scene::Photometry photometry) {
    return {{0.0, 0.0, 0.0}, {0.0, -1.0, 0.0}, {1.0, 0.0, 0.0}, std::make_shared<const scene::Photometry>(std::move(photometry))};
}

// The irradiance that the only light makes at right angles at a point.
double arriving(const World& world, const Vec3& at) {
    const WorldRecord record = world.record();
    const EmitterSample s = emitter_sample(record, world.emitters.front(), at, vec2_of(0.5f, 0.5f), true);
    return static_cast<double>(emitted_light(record, world.emitters.front(), s, vec4_all(550.0f), true).x);
}

Vec3 at(double x, double y, double z) { return vec3_of(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)); }

scene::ProjectorLight projector(bool even) {
    // Rows from the top: 1 2 3 4 above 5 6 7 8.
    scene::ProjectorLight light;
    light.fov = 60.0;
    light.image = picture("eight", 4, 2, {1, 2, 3, 4, 5, 6, 7, 8});
    light.even = even;
    return light;
}

// ---- Where the picture lands ---------------------------------------------------------------------------------------------------------------

TEST(Projector, ThrowsThePictureTheRightWayRound) {
    const auto world = lit_by(projector(true));
    ASSERT_TRUE(world);
    const double half_width = std::tan(pi / 6.0), half_height = half_width / 2.0;
    // On a screen 3 m in front, texel by texel: the picture's left is to the left of who looks along the light, -x.
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 2; ++row) {
            const double x = 3.0 * half_width * ((column + 0.5) / 2.0 - 1.0);
            const double y = 3.0 * half_height * (1.0 - (row + 0.5));
            const Vec3 point = at(x, y, -3.0);
            const double distance_2 = x * x + y * y + 9.0;
            const double cosine = 3.0 / std::sqrt(distance_2);
            // As bright everywhere on the screen: power * texel / 3^2.
            EXPECT_NEAR(arriving(*world, point) * cosine, 2.0 * (1 + column + 4 * row) / 9.0, 1e-4) << column << ", " << row;
        }
    }
    EXPECT_EQ(arriving(*world, at(0.0, 3.0 * half_height * 1.01, -3.0)), 0.0);
    EXPECT_EQ(arriving(*world, at(3.0 * half_width * 1.01, 0.0, -3.0)), 0.0);
    EXPECT_GT(arriving(*world, at(3.0 * half_width * 0.99, 0.0, -3.0)), 0.0);
    EXPECT_EQ(arriving(*world, at(0.0, 0.0, 3.0)), 0.0);
}

TEST(Projector, MayBeAsIntenseInEachDirection) {
    const auto world = lit_by(projector(false));
    ASSERT_TRUE(world);
    const double x = -3.0 * std::tan(pi / 6.0) * 0.75, y = 3.0 * std::tan(pi / 6.0) * 0.25;
    EXPECT_NEAR(arriving(*world, at(x, y, -3.0)), 2.0 * 1.0 / (x * x + y * y + 9.0), 1e-4);
}

TEST(Goniometric, ShinesAsThePictureIsSeenFromIt) {
    // Eight columns of a panorama; its middle between columns 3 and 4.
    std::vector<float> grey;
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 8; ++column) {
            grey.push_back(static_cast<float>(1 + column + 10 * row));
        }
    }
    scene::GoniometricLight light;
    light.image = picture("around", 8, 4, grey);
    const auto world = lit_by(light);
    ASSERT_TRUE(world);
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 8; ++column) {
            const double longitude = ((column + 0.5) / 8.0 - 0.5) * 2.0 * pi, latitude = (0.5 - (row + 0.5) / 4.0) * pi;
            const Vec3 point = at(2.0 * std::sin(longitude) * std::cos(latitude), 2.0 * std::sin(latitude),
                                  -2.0 * std::cos(longitude) * std::cos(latitude));
            EXPECT_NEAR(arriving(*world, point), 2.0 * (1 + column + 10 * row) / 4.0, 2e-3) << column << ", " << row;
        }
    }
}

// ---- Photometric files ---------------------------------------------------------------------------------------------------------------------

TEST(Ies, IrradianceBelowTheLampIsItsCandelaOverTheSquareOfTheHeight) {
    const auto world = lit_by(lamp({{0.0, 30.0, 60.0}, {0.0}, {100.0, 40.0, 0.0}}), scene::Rgb(0.5));
    ASSERT_TRUE(world);
    EXPECT_NEAR(arriving(*world, at(0.0, -4.0, 0.0)), 0.5 * 100.0 / 16.0, 1e-5);
    for (const double degrees : {10.0, 30.0, 50.0, 59.9}) {
        const double angle = glm::radians(degrees);
        const double candela = degrees < 30.0 ? 100.0 - 60.0 * degrees / 30.0 : 40.0 * (60.0 - degrees) / 30.0;
        const Vec3 point = at(-2.0 * std::sin(angle), -2.0 * std::cos(angle), 0.0);
        EXPECT_NEAR(arriving(*world, point), 0.5 * candela / 4.0, 1e-4) << degrees;
    }
    EXPECT_EQ(arriving(*world, at(0.0, 2.0, 0.0)), 0.0);
    EXPECT_EQ(arriving(*world, at(2.0, -0.5, 0.0)), 0.0);
}

TEST(Ies, HorizontalAnglesGrowCounterClockwiseFromForward) {
    const auto world = lit_by(lamp({{0.0, 180.0}, {0.0, 90.0, 180.0, 270.0, 360.0}, {1, 1, 2, 2, 3, 3, 4, 4, 1, 1}}), scene::Rgb(1.0));
    ASSERT_TRUE(world);
    EXPECT_NEAR(arriving(*world, at(1.0, 0.0, 0.0)), 1.0, 1e-5);
    EXPECT_NEAR(arriving(*world, at(0.0, 0.0, -1.0)), 2.0, 1e-5);  // seen from above, +x is to the right and -z up
    EXPECT_NEAR(arriving(*world, at(-1.0, 0.0, 0.0)), 3.0, 1e-5);
    EXPECT_NEAR(arriving(*world, at(0.0, 0.0, 1.0)), 4.0, 1e-5);
    EXPECT_NEAR(arriving(*world, at(std::sqrt(0.5), 0.0, -std::sqrt(0.5))), 1.5, 1e-5);
}

TEST(Ies, SpectraOfItsColourCount) {
    scene::Scene scene;
    scene.settings.integrator = "path";
    scene.cameras.push_back({});
    scene::Light light;
    light.model = lamp({{0.0, 90.0}, {0.0}, {5.0, 5.0}});
    light.power = scene::Spectrum{scene::MeasuredSpectrum{{360.0, 500.0, 501.0, 830.0}, {2.0, 2.0, 1.0, 1.0}}, 1.0, std::nullopt};
    scene.lights.push_back(light);
    Diagnostics diagnostics;
    const auto world = compile_world(scene, scene.cameras.front(), diagnostics);
    ASSERT_TRUE(world);
    const WorldRecord record = world->record();
    const EmitterSample s = emitter_sample(record, world->emitters.front(), at(0.0, -1.0, 0.0), vec2_of(0.5f, 0.5f), true);
    const Spectrum spectrum = emitted_light(record, world->emitters.front(), s, vec4_of(450.0f, 480.0f, 550.0f, 600.0f), true);
    EXPECT_NEAR(double(spectrum.x), 10.0, 1e-4);
    EXPECT_NEAR(double(spectrum.w), 5.0, 1e-4);
}

// ---- Drawing directions --------------------------------------------------------------------------------------------------------------------

TEST(ThrownLight, DrawsDirectionsWithItsDensity) {
    std::vector<std::shared_ptr<const World>> worlds;
    std::vector<float> grey(static_cast<std::size_t>(16 * 8), 0.1f);
    grey[20] = 30.0f;
    grey[70] = 4.0f;
    scene::ProjectorLight thrown;
    thrown.direction = {0.3, -0.8, -0.4};
    thrown.fov = 80.0;
    thrown.image = picture("spots", 16, 8, grey);
    worlds.push_back(lit_by(thrown));
    worlds.push_back(lit_by(scene::GoniometricLight{{0.0, 0.0, 0.0}, {0.4, 0.1, -1.0}, {0.2, 1.0, 0.1}, *thrown.image}));
    worlds.push_back(lit_by(lamp({{0.0, 30.0, 60.0}, {0.0, 180.0, 360.0}, {9.0, 4.0, 0.0, 1.0, 2.0, 0.0, 9.0, 4.0, 0.0}})));
    std::mt19937 numbers(3);
    std::uniform_real_distribution<float> uniform(0.0f, 0.9999f);
    for (std::size_t which = 0; which < worlds.size(); ++which) {
        SCOPED_TRACE(which);
        ASSERT_TRUE(worlds[which]);
        const WorldRecord world = worlds[which]->record();
        const EmitterRecord& emitter = worlds[which]->emitters.front();
        Cells cells(24, 24);
        int wrong = 0;
        constexpr int draws = 30000;
        for (int i = 0; i < draws; ++i) {
            const ThrownWay drawn = thrown_sample(world, emitter, vec2_of(uniform(numbers), uniform(numbers)), true);
            ASSERT_NEAR(double(length(drawn.way)), 1.0, 1e-5);
            const double density = double(thrown_density(world, emitter, drawn.way, true));
            wrong += std::abs(density - double(drawn.density)) <= 1e-3 * density ? 0 : 1;
            cells.count(std::atan2(double(drawn.way.y), double(drawn.way.x)) / (2.0 * pi) + 0.5, 0.5 * double(drawn.way.z) + 0.5);
        }
        EXPECT_LE(wrong, draws / 1000);  // where two cells meet
        Pair sum;
        const auto density = [&](double x, double y) {
            return Pair{double(thrown_density(world, emitter, direction_of(2.0 * y - 1.0, (2.0 * x - 1.0) * pi), true)) * 4.0 * pi, 0.0};
        };
        std::vector<double> expected = cells.expect(density, 1e-5, sum, 2);
        EXPECT_NEAR(sum.density, 1.0, 5e-3);
        for (double& count : expected) {
            count /= sum.density;
        }
        expected.back() = 0.0;
        const Verdict verdict = compare_counts(cells.counts(), expected);
        EXPECT_TRUE(verdict.right()) << verdict.words();
    }
}

// Wherever there is light, there are draws.
TEST(ThrownLight, DrawsWhereverItShines) {
    std::vector<float> grey(static_cast<std::size_t>(64 * 32), 0.0f);
    grey[1000] = 1.0f;
    scene::GoniometricLight light;
    light.image = picture("dot", 64, 32, grey);
    const auto world = lit_by(light);
    ASSERT_TRUE(world);
    const WorldRecord record = world->record();
    std::mt19937 numbers(4);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (int i = 0; i < 20000; ++i) {
        const Vec3 way = direction_of(2.0 * uniform(numbers) - 1.0, 2.0 * pi * uniform(numbers));
        if (arriving(*world, way) > 0.0) {
            ASSERT_GT(thrown_density(record, world->emitters.front(), way, true), 0.0f);
        }
    }
}

}  // namespace
}  // namespace lancer::statistics
