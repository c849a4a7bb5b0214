// The Whitted integrator on scenes whose light can be worked out by hand.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "analytic/small_world.h"

namespace lancer::tests {
namespace {

constexpr double close = 2e-6;  // some roundings of values up to 1

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

void expect_color(const glm::dvec3& color, const glm::dvec3& expected, double tolerance = close) {
    EXPECT_NEAR(color.x, expected.x, tolerance);
    EXPECT_NEAR(color.y, expected.y, tolerance);
    EXPECT_NEAR(color.z, expected.z, tolerance);
}
void expect_grey(const glm::dvec3& color, double expected, double tolerance = close) {
    expect_color(color, glm::dvec3(expected), tolerance);
}

scene::WhittedMaterial plastic() {
    scene::WhittedMaterial material;
    material.color = glm::dvec3(0.8, 0.4, 0.2);
    material.ambient = 0.25;
    material.diffuse = 0.5;
    material.highlight = 0.75;
    material.shininess = 10.0;
    return material;
}

// ---- Ambient, diffuse, highlight -------------------------------------------------------------------------------------------------

TEST(Whitted, SphereUnderALampByHand) {
    SmallWorld world;
    world.scene.ambient = glm::dvec3(0.5, 0.6, 0.7);
    world.add(scene::Sphere{}, world.add(plastic()));
    // The camera sees the point (0, 0, 1) with the normal +z; the lamp stands 30 degrees off it.
    const double angle = radians(30.0);
    world.add_light(scene::PointLight{glm::dvec3(0.0, 0.0, 1.0) + 4.0 * glm::dvec3(std::sin(angle), 0.0, std::cos(angle))}, 0.9,
                    {1.0, 0.5, 0.25});
    const glm::dvec3 color(0.8, 0.4, 0.2);
    const glm::dvec3 lamp = 0.9 * glm::dvec3(1.0, 0.5, 0.25);
    const glm::dvec3 expected =
        world.scene.ambient.rgb * 0.25 * color + lamp * (0.5 * color * std::cos(angle) + 0.75 * std::pow(std::cos(angle), 10.0));
    expect_color(world.ahead(), expected);
}

TEST(Whitted, LampsAddUp) {
    SmallWorld world;
    world.add(scene::Sphere{}, world.add(plastic()));
    const scene::PointLight left{{-3.0, 1.0, 4.0}}, right{{2.0, 2.0, 5.0}};
    SmallWorld one = world, other = world;
    one.add_light(left, 0.7, {1.0, 0.5, 0.0});
    other.add_light(right, 0.3);
    world.add_light(left, 0.7, {1.0, 0.5, 0.0});
    world.add_light(right, 0.3);
    expect_color(world.ahead(), one.ahead() + other.ahead(), 1e-7);
}

TEST(Whitted, DistanceDoesNotDimALamp) {
    for (const double distance : {0.01, 3.0, 1e4}) {
        SmallWorld world;
        world.add(scene::Sphere{}, world.add(matte()));
        world.add_light(scene::PointLight{{0.0, 0.0, 1.0 + distance}}, 0.5);
        expect_grey(world.ahead(), 0.5);
    }
}

TEST(Whitted, LampsBehindTheSurfaceGiveNothing) {
    SmallWorld world;
    world.add(scene::Box{{-9.0, -9.0, -1.0}, {9.0, 9.0, 0.0}}, world.add(plastic()));
    world.add_light(scene::PointLight{{0.0, 0.0, -2.0}}, 1.0);
    world.add_light(scene::PointLight{{1.0, 0.0, -0.5}}, 1.0);
    expect_grey(world.ahead(), 0.0, 0.0);
}

TEST(Whitted, Shadows) {
    SmallWorld world;
    const int white = world.add(matte());
    world.add(scene::Box{{-9.0, -9.0, -1.0}, {9.0, 9.0, 0.0}}, white);
    world.add_light(scene::PointLight{{4.0, 0.0, 4.0}}, 1.0);
    expect_grey(world.ahead(), std::sqrt(0.5));
    SmallWorld hidden = world;
    hidden.add(scene::Sphere{{2.0, 0.0, 2.0}, 0.25}, white);  // half way
    expect_grey(hidden.ahead(), 0.0, 0.0);
    SmallWorld behind = world;
    behind.add(scene::Sphere{{4.5, 0.0, 4.5}, 0.25}, white);  // behind the lamp
    expect_grey(behind.ahead(), std::sqrt(0.5));
    SmallWorld beside = world;
    beside.add(scene::Sphere{{2.0, 0.3, 2.0}, 0.25}, white);
    expect_grey(beside.ahead(), std::sqrt(0.5));
}

TEST(Whitted, DirectionalLightComesFromEverywhereAndIsHidden) {
    SmallWorld world;
    const int white = world.add(matte());
    world.add(scene::Box{{-9.0, -9.0, -1.0}, {9.0, 9.0, 0.0}}, white);
    world.add_light(scene::DirectionalLight{{0.0, -3.0, -4.0}}, 0.5);  // its length does not count
    expect_grey(world.ahead(), 0.4);
    expect_grey(world.at({20.5, 70.5}), 0.4);
    world.add(scene::Sphere{{0.0, 3000.0, 4000.0}, 1.0}, white);
    expect_grey(world.ahead(), 0.0, 0.0);
    expect_grey(world.at({20.5, 70.5}), 0.4);
}

TEST(Whitted, SpotLightFadesBetweenItsCones) {
    // Straight down onto a floor; the camera is moved so that the point under it lies at an angle from the spot's axis.
    const auto light_at = [](double degrees) {
        SmallWorld world;
        world.add(scene::Plane{}, world.add(matte()));
        const double x = 10.0 * std::tan(radians(degrees));
        world.add_light(scene::SpotLight{{0.0, 10.0, 0.0}, {0.0, -2.0, 0.0}, 30.0, 10.0}, 1.0);
        world.look({x, 5.0, 0.0}, {0.0, -1.0, 0.0}, {0.0, 0.0, -1.0});
        return world.ahead().x / std::cos(radians(degrees));
    };
    EXPECT_NEAR(light_at(0.0), 1.0, close);
    EXPECT_NEAR(light_at(19.9), 1.0, close);
    EXPECT_EQ(light_at(30.1), 0.0);
    EXPECT_EQ(light_at(80.0), 0.0);
    // Between, smooth in the cosine: 3 x^2 - 2 x^3.
    const double x = (std::cos(radians(26.0)) - std::cos(radians(30.0))) / (std::cos(radians(20.0)) - std::cos(radians(30.0)));
    EXPECT_NEAR(light_at(26.0), x * x * (3.0 - 2.0 * x), 1e-5);
}

TEST(Whitted, BackgroundIsAGradientOfTheHeight) {
    SmallWorld world;
    world.scene.background = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
    for (const double height : {-1.0, -0.6, -0.1, 0.0, 0.3, 0.9, 1.0}) {
        world.look({0.0, 0.0, 0.0}, {std::sqrt(1.0 - height * height), height, 0.0}, {0.0, 0.0, 1.0});
        expect_color(world.ahead(), {std::max(height, 0.0), 1.0 - std::abs(height), std::max(-height, 0.0)});
    }
}

// ---- Mirrors ---------------------------------------------------------------------------------------------------------------------

// Two mirrors face one another; each shows its own glow times 1 - r, and the other one times r.
TEST(Whitted, FacingMirrorsMakeAGeometricSeries) {
    const double r = 0.5;
    for (const int bounces : {0, 1, 2, 5, 24}) {
        SmallWorld world;
        world.scene.ambient = glm::dvec3(1.0);
        world.scene.settings.bounces = bounces;
        scene::WhittedMaterial mirror = glowing(1.0);
        mirror.reflectivity = r;
        const int material = world.add(mirror);
        world.add(scene::Plane{{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}, material);
        world.add(scene::Plane{{0.0, 0.0, 10.0}, {0.0, 0.0, -1.0}}, material);
        double sum = 0.0;
        for (int k = 0; k <= bounces; ++k) {
            sum += std::pow(r, k) * (1.0 - r);
        }
        expect_grey(world.ahead(), sum);
    }
}

TEST(Whitted, MirrorsShowWhatStandsBesideThem) {
    SmallWorld world;
    world.scene.ambient = glm::dvec3(1.0);
    scene::WhittedMaterial mirror = glowing(0.0);
    mirror.reflectivity = 0.75;
    world.add(scene::Box{{-1.0, -1.0, -0.1}, {1.0, 1.0, 0.0}}, world.add(mirror),
              glm::rotate(glm::dmat4(1.0), radians(45.0), glm::dvec3(0, 1, 0)));
    world.add(scene::Sphere{{5.0, 0.0, 0.0}, 1.0}, world.add(glowing(0.8, {1.0, 0.5, 0.25})));
    expect_color(world.ahead(), 0.75 * 0.8 * glm::dvec3(1.0, 0.5, 0.25));
    world.scene.settings.bounces = 0;
    expect_grey(world.ahead(), 0.0, 0.0);
}

TEST(Whitted, WeakPathsAreLeftOut) {
    SmallWorld world;
    world.set_background(1.0, 1.0, 1.0);
    scene::WhittedMaterial mirror = glowing(0.0);
    mirror.reflectivity = 0.1;
    world.add(scene::Sphere{}, world.add(mirror));
    expect_grey(world.ahead(), 0.1);
    world.scene.settings.min_weight = 0.05;
    expect_grey(world.ahead(), 0.1);
    world.scene.settings.min_weight = 0.2;
    expect_grey(world.ahead(), 0.0, 0.0);
}

// ---- Transparent bodies ----------------------------------------------------------------------------------------------------------

TEST(Whitted, AirInAirIsInvisible) {
    SmallWorld world;
    world.set_background(1.0, 0.5, 0.0);
    const SmallWorld empty = world;
    const int air = world.add(clear(1.0));
    world.add(scene::Sphere{{0.3, 0.2, 0.0}, 2.0}, air);
    world.add(scene::Box{{-3.0, -3.0, -4.0}, {3.0, 3.0, -2.5}}, air,
              glm::rotate(glm::dmat4(1.0), 0.4, glm::normalize(glm::dvec3(1, 2, 3))));
    const std::vector<glm::vec3> seen = world.picture(41), expected = empty.picture(41);
    for (std::size_t i = 0; i < seen.size(); ++i) {
        expect_color(glm::dvec3(seen[i]), glm::dvec3(expected[i]), 1e-5);
    }
}

// Seen from below: what goes through comes from the bright zenith, what is thrown back from the black nadir. All orders of reflection inside
// the slab together let (1 - R) / (1 + R) through.
TEST(Whitted, SlabLetsThroughWhatFresnelSays) {
    SmallWorld world;
    world.set_background(1.0, 0.0, 0.0);
    world.scene.settings.bounces = 24;
    world.look({0.0, -5.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0});
    world.add(scene::Box{{-2.0, -0.5, -2.0}, {2.0, 0.5, 2.0}}, world.add(clear(1.5168)));
    expect_grey(world.ahead(), 0.9190827);
}

// The same light from a bright nadir: what is thrown back at all, 2 R / (1 + R).
TEST(Whitted, SlabThrowsBackTheRest) {
    SmallWorld world;
    world.set_background(0.0, 0.0, 1.0);
    world.scene.settings.bounces = 24;
    world.look({0.0, -5.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0});
    world.add(scene::Box{{-2.0, -0.5, -2.0}, {2.0, 0.5, 2.0}}, world.add(clear(1.5168)));
    expect_grey(world.ahead(), 1.0 - 0.9190827);
}

// In a furnace that is as bright everywhere, a clear body is invisible, whatever its shape: no light is lost or made at its borders.
TEST(Whitted, ClearBodiesVanishInAFurnace) {
    SmallWorld world;
    world.set_background(1.0, 1.0, 1.0);
    world.scene.settings.bounces = 24;
    const int glass = world.add(clear(1.5));
    world.add(scene::Sphere{{-1.2, 0.0, 0.0}, 1.0}, glass);
    world.add(scene::Cylinder{{1.2, -1.0, 0.0}, {1.4, 1.0, 0.3}, 0.8, true}, glass);
    for (const glm::vec3& color : world.picture(41)) {
        // What still goes round inside after 24 bounces is lost: total reflection keeps some of it for good.
        EXPECT_LE(color.x, 1.0f + 1e-5f);
    }
    expect_grey(world.at({40.5, 50.5}), 1.0, 1e-5);
}

// Through the middle of a glass sphere: straight, with Fresnel's loss at both borders; two bounces leave out what turns round inside.
TEST(Whitted, GlassSphereSeenCentrally) {
    const double n = 1.5;
    const double reflected = std::pow((n - 1.0) / (n + 1.0), 2.0);
    SmallWorld world;
    world.set_background(1.0, 0.0, 0.0);
    world.look({0.0, -5.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0});
    world.add(scene::Sphere{}, world.add(clear(n)));
    world.scene.settings.bounces = 2;
    expect_grey(world.ahead(), (1.0 - reflected) * (1.0 - reflected));
    world.scene.settings.bounces = 1;
    expect_grey(world.ahead(), 0.0, close);
    // From inside the glass one border is left, and the camera knows where it is.
    world.scene.settings.bounces = 1;
    world.look({0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0});
    expect_grey(world.ahead(), 1.0 - reflected);
}

// Reflectivity and transparency share the light: r is mirrored, the glass gets (1 - r) t, the body's own colour (1 - r) (1 - t).
TEST(Whitted, SharesOfAHalfClearMirror) {
    SmallWorld world;
    world.scene.ambient = glm::dvec3(1.0);
    world.set_background(0.0, 0.0, 1.0);
    world.look({0.0, -5.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0});
    scene::WhittedMaterial material = clear(1.5, 0.5);
    material.reflectivity = 0.25;
    material.ambient = 0.8;
    world.add(scene::Sphere{}, world.add(material));
    const double fresnel = 0.04;
    // The mirrored ray sees the nadir; the glow is the body's. The far side, seen from inside, glows as well and is no part of bounce 0.
    world.scene.settings.bounces = 0;
    expect_grey(world.ahead(), 0.75 * 0.5 * 0.8);
    world.scene.settings.bounces = 1;
    const double body = 0.75 * 0.5;
    expect_grey(world.ahead(), body * 0.8 + (0.25 + body * fresnel) * 1.0 + body * (1.0 - fresnel) * body * 0.8);
}

TEST(Whitted, AbsorptionByDepth) {
    const glm::dvec3 sigma(0.1, 0.5, 2.0);
    for (const double depth : {0.25, 1.0, 3.0}) {
        SmallWorld world;
        world.set_background(1.0, 0.0, 0.0);
        world.look({0.0, -5.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0});
        scene::WhittedMaterial ink = clear(1.0);
        ink.absorption = sigma;
        world.add(scene::Box{{-9.0, 0.0, -9.0}, {9.0, depth, 9.0}}, world.add(ink));
        expect_color(world.ahead(), glm::exp(-sigma * depth));
        // From the middle of it half of that is left to pass.
        world.look({0.0, 0.5 * depth, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0});
        expect_color(world.ahead(), glm::exp(-sigma * 0.5 * depth));
    }
}

// A clear box in an inked one: each stretch counts with what it goes through, towards the camera and towards the lamp.
TEST(Whitted, AbsorptionInNestedBodies) {
    SmallWorld world;
    scene::WhittedMaterial ink = clear(1.0);
    ink.absorption = glm::dvec3(0.5);
    scene::WhittedMaterial faint = clear(1.0);
    faint.absorption = glm::dvec3(0.1);
    world.add(scene::Box{{-9.0, 0.0, -9.0}, {9.0, 4.0, 9.0}}, world.add(ink));
    world.add(scene::Box{{-5.0, 1.0, -5.0}, {5.0, 3.0, 5.0}}, world.add(faint));
    const double passes = std::exp(-0.5 * 2.0 - 0.1 * 2.0);
    world.set_background(1.0, 0.0, 0.0);
    world.look({0.0, -5.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0});
    expect_grey(world.ahead(), passes);
    // A lamp above the boxes and a white floor under them.
    world.set_background(0.0, 0.0, 0.0);
    world.add(scene::Box{{-30.0, -2.0, -30.0}, {30.0, -1.0, 30.0}}, world.add(matte()));
    world.add_light(scene::DirectionalLight{{0.0, -1.0, 0.0}}, 1.0);
    world.look({0.0, -0.5, 0.0}, {0.0, -1.0, 0.0}, {0.0, 0.0, 1.0});
    expect_grey(world.ahead(), passes);
    // A lamp in the middle: half the way.
    world.scene.lights.clear();
    world.add_light(scene::PointLight{{0.0, 2.0, 0.0}}, 1.0);
    expect_grey(world.ahead(), std::exp(-0.5 - 0.1));
    // Floor, camera and lamp all in the ink.
    world.scene.lights.clear();
    world.scene.objects.resize(1);
    world.add(scene::Box{{-1.0, 1.0, -1.0}, {1.0, 1.5, 1.0}}, world.add(matte()));
    world.add_light(scene::PointLight{{0.0, 3.5, 0.0}}, 1.0);
    world.look({0.0, 6.0, 0.0}, {0.0, -1.0, 0.0}, {0.0, 0.0, 1.0});
    expect_grey(world.ahead(), std::exp(-0.5 * 2.5) * std::exp(-0.5 * 2.0));
}

TEST(Whitted, ShadowsOfClearBodies) {
    SmallWorld world;
    world.add(scene::Box{{-9.0, -9.0, -1.0}, {9.0, 9.0, 0.0}}, world.add(matte()));
    world.add_light(scene::PointLight{{4.0, 0.0, 4.0}}, 1.0);
    const double unhidden = world.ahead().x;
    scene::WhittedMaterial half = clear(1.5, 0.5);
    half.absorption = glm::dvec3(0.0, 0.5, 1.0);
    world.add(scene::Sphere{{2.0, 0.0, 2.0}, 0.25}, world.add(half));
    // Two borders of a half clear body, a diameter of 0.5 between them; not bent on this way.
    expect_color(world.ahead(), unhidden * 0.25 * glm::exp(-glm::dvec3(0.0, 0.5, 1.0) * 0.5));
}

// ---- Dispersion ------------------------------------------------------------------------------------------------------------------

// Glass that is followed wavelength by wavelength but bends all alike shows the same picture as plain glass.
TEST(Whitted, BandsOfOneIndexAreWhiteAgain) {
    SmallWorld world;
    world.set_background(1.0, 0.6, 0.2);
    world.scene.ambient = glm::dvec3(0.3);
    world.scene.settings.bounces = 4;
    world.scene.settings.wavelengths = 12;
    const int floor = world.add(matte({0.9, 0.5, 0.3}));
    world.add(scene::Plane{{0.0, -1.5, 0.0}, {0.0, 1.0, 0.0}}, floor);
    world.add_light(scene::PointLight{{3.0, 4.0, 5.0}}, 0.8);
    scene::WhittedMaterial ink = clear(1.1);
    ink.absorption = glm::dvec3(0.1, 0.3, 0.6);
    world.add(scene::Sphere{{0.0, 0.0, 0.0}, 1.4}, world.add(ink));
    const int glass = world.add(clear(1.5));
    world.add(scene::Sphere{{0.2, 0.1, 0.0}, 0.7}, glass);
    world.add(scene::Box{{1.5, -1.0, -1.0}, {2.5, 1.0, 0.0}}, glass);
    const std::vector<glm::vec3> plain = world.picture(48);
    auto& model = std::get<scene::WhittedMaterial>(world.scene.materials[static_cast<std::size_t>(glass)].model);
    // n^2 = 1 + 1.25 L^2 / (L^2 - C): from violet to red the index changes by a millionth.
    model.refraction = scene::SellmeierGlass{{1.25, 0.0, 0.0}, {1e-7, 0.0, 0.0}};
    const std::vector<glm::vec3> bands = world.picture(48);
    int differ = 0;
    for (std::size_t i = 0; i < plain.size(); ++i) {
        differ += glm::length(plain[i] - bands[i]) > 1e-5f ? 1 : 0;
    }
    // At the outlines a millionth may decide what is seen.
    EXPECT_LE(differ, 5);
}

// White light through a prism: red is bent least, violet most.
TEST(Whitted, PrismSpreadsTheSpectrumInOrder) {
    SmallWorld world;
    auto mesh = std::make_shared<scene::TriangleMesh>();
    for (const float z : {-2.0f, 2.0f}) {
        mesh->positions.insert(mesh->positions.end(), {{-1.0f, 0.0f, z}, {1.0f, 0.0f, z}, {0.0f, std::sqrt(3.0f), z}});
    }
    mesh->triangles = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
    world.add(scene::Mesh{mesh, false}, world.add(clear(scene::NamedGlass{"N-BK7"})));
    // A bright slit far to the left, seen through the prism from the right: moving the view down past it, red comes last.
    world.scene.ambient = glm::dvec3(1.0);
    world.scene.settings.bounces = 2;
    world.add(scene::Box{{-200.0, -71.0, -50.0}, {-199.0, -70.0, 50.0}}, world.add(glowing(1.0)));
    const glm::dvec3 middle(0.5, std::sqrt(0.75), 0.0);
    double first[3] = {0.0, 0.0, 0.0}, weight[3] = {0.0, 0.0, 0.0};
    for (int i = 0; i < 400; ++i) {
        const double angle = radians(15.0 + 10.0 * i / 400.0);
        const glm::dvec3 direction(-std::cos(angle), std::sin(angle), 0.0);
        world.look(middle - direction * 3.0, direction);
        const glm::dvec3 seen = glm::max(world.ahead(), glm::dvec3(0.0));
        for (int c = 0; c < 3; ++c) {
            first[c] += seen[c] * angle;
            weight[c] += seen[c];
        }
    }
    for (int c = 0; c < 3; ++c) {
        ASSERT_GT(weight[c], 0.0);
    }
    const double red = first[0] / weight[0], green = first[1] / weight[1], blue = first[2] / weight[2];
    // The prism bends towards its base, downwards as seen from here; who looks for the slit looks the higher up the more it is bent.
    EXPECT_LT(red, green);
    EXPECT_LT(green, blue);
}

// ---- Counting --------------------------------------------------------------------------------------------------------------------

TEST(Whitted, RaysAreCounted) {
    SmallWorld world;
    scene::WhittedMaterial mirror = glowing(0.0);
    mirror.reflectivity = 0.5;
    world.add(scene::Plane{{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}, world.add(mirror));
    world.add_light(scene::PointLight{{0.0, 0.0, 9.0}}, 0.5);
    world.add_light(scene::PointLight{{0.0, 0.0, -9.0}}, 0.5);  // on the other side: not asked
    for (const int lanes : {0, 4}) {
        const auto device = make_cpu_device(world.compile(), {.lanes = lanes});
        const std::vector<glm::vec2> points(7, glm::vec2(50.5f, 50.5f));
        std::vector<glm::vec3> radiance(points.size());
        RayCounts counts;
        device->follow(points, radiance, counts);
        EXPECT_EQ(counts.camera, 7u);
        EXPECT_EQ(counts.secondary, 7u);
        EXPECT_EQ(counts.shadow, 7u);
    }
}

TEST(Whitted, WavelengthsAreNoCameraRays) {
    SmallWorld world;
    world.add(scene::Sphere{}, world.add(clear(scene::NamedGlass{"N-BK7"})));
    const auto device = make_cpu_device(world.compile());
    const std::vector<glm::vec2> points(3, glm::vec2(50.5f, 50.5f));
    std::vector<glm::vec3> radiance(points.size());
    RayCounts counts;
    device->follow(points, radiance, counts);
    EXPECT_EQ(counts.camera, 3u);
    EXPECT_GT(counts.secondary, 3u * 48u);
}

}  // namespace
}  // namespace lancer::tests
