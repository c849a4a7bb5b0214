// Media where the answer is known: how light fades, shines and passes borders that bend nothing.
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "analytic/dice.h"
#include "analytic/fog.h"
#include "lancer/kernel/volume/bodies.h"
#include "lancer/spectrum/illuminant.h"
#include "lancer/spectrum/observer.h"
#include "lancer/spectrum/sensor.h"

namespace lancer::tests {
namespace {

const glm::dvec3 none(0.0);

void expect_color(const Mean& seen, const glm::dvec3& expected, double rounding = 2e-5) {
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(seen.value[i], expected[i], deviations * seen.error[i] + rounding * std::max(expected[i], 1.0)) << "channel " << i;
    }
}

// A uniform sky through a ball of 2 m.
FogWorld ball(const scene::Medium& medium, int bounces = 1) {
    FogWorld world(bounces);
    world.set_background(1.0, 1.0, 1.0);
    world.add(scene::Sphere{}, world.border(medium));
    return world;
}

TEST(Media, AbsorbAsBouguerSays) {
    const glm::dvec3 absorption(0.2, 0.7, 1.5);
    const glm::dvec3 expected = glm::exp(-2.0 * absorption);
    expect_color(ball(medium_of(absorption, none)).see(1), expected);
    // As a grid, whose blocks are passed by chance.
    scene::Medium grid = medium_of(absorption, none);
    grid.density = grid_of({2, 3, 9}, std::vector<float>(54, 1.0f), glm::dvec3(-1.0), glm::dvec3(1.0));
    expect_color(ball(grid).see(400), expected);
    // Turned, larger than the ball, of twice the density at half the coefficients.
    grid.density = grid_of({9, 2, 3}, std::vector<float>(54, 2.0f), glm::dvec3(-3.0, -2.0, -2.0), glm::dvec3(3.0, 2.0, 2.0));
    grid.density->to_world = glm::dmat4(glm::dmat3(0.6, 0.8, 0.0, -0.8, 0.6, 0.0, 0.0, 0.0, 1.0)) * grid.density->to_world;
    grid.scale = 0.5;
    expect_color(ball(grid).see(400), expected);
}

// 3 m from the camera, in what is everywhere.
TEST(Media, AbsorbOnTheWayToALamp) {
    FogWorld world;
    scene::Material lamp;
    lamp.model = scene::DiffuseMaterial{scene::Rgb(0.0), 0.0};
    lamp.emission = scene::Emission{scene::Color(scene::Rgb(2.0))};
    world.add(scene::Sphere{{0.0, 0.0, 0.0}, 2.0}, world.material(lamp));
    const glm::dvec3 absorption(0.1, 0.2, 0.4);
    world.scene.medium = world.medium(medium_of(absorption, none));
    expect_color(world.see(1), 2.0 * glm::exp(-3.0 * absorption));
}

// A wall lit by a point lamp through a ball of fog that only absorbs, and the wall seen past it: cosine and distance in closed form.
TEST(Media, DimLightThatIsAskedFor) {
    const glm::dvec3 absorption(0.3, 0.6, 0.9);
    for (const int kind : {0, 1, 2}) {
        FogWorld world;
        scene::Material wall;
        wall.model = scene::DiffuseMaterial{scene::Rgb(0.5), 0.0};
        world.add(scene::Box{{-50.0, -50.0, -1.0}, {50.0, 50.0, 0.0}}, world.material(wall));
        world.add_light(scene::PointLight{{4.0, 0.0, 4.0}}, 1.0);
        world.scene.lights[0].power = scene::Color(scene::Rgb(10.0));
        // The lamp's line to the middle of the wall runs along a diameter of the ball.
        scene::Medium medium = medium_of(absorption, none);
        if (kind == 1) {
            medium.density = grid_of({1, 1, 1}, {1.0f}, glm::dvec3(-9.0), glm::dvec3(9.0));
        } else if (kind == 2) {
            std::vector<float> colors;
            for (int i = 0; i < 8; ++i) {
                colors.insert(colors.end(), {0.3f, 0.6f, 0.9f});
            }
            medium = medium_of(scene::Rgb(1.0), none);
            medium.density = grid_of({2, 2, 2}, colors, glm::dvec3(-9.0), glm::dvec3(9.0), 3);
        }
        world.add(scene::Sphere{{2.0, 0.0, 2.0}, 0.5}, world.border(medium));
        const double distance_2 = 32.0, cosine = std::numbers::sqrt2 / 2.0;
        const glm::dvec3 expected = 0.5 / std::numbers::pi * 10.0 * cosine / distance_2 * glm::exp(-absorption);
        expect_color(world.see(kind == 0 ? 1 : 400), expected, 1e-4);
    }
}

// Between two cells the density runs straight from 1 to 3, and stays as it is beyond their middles: 2 on average. Where it fades, half a cell
// more on each side falls to nothing: 1 + 3 cells of which the middle one is 2, and the halves outside have 1/4 and 3/4.
TEST(Media, GridsAreStraightBetweenCells) {
    for (const bool fades : {false, true}) {
        FogWorld world;
        world.set_background(1.0, 1.0, 1.0);
        world.look({-5.0, 0.0, 0.0}, {1.0, 0.0, 0.0});
        scene::Medium medium = medium_of(scene::Rgb(0.4), none);
        medium.density = grid_of({2, 1, 1}, {1.0f, 3.0f}, {-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0});
        medium.density->fades = fades;
        world.scene.medium = world.medium(medium);
        world.add(scene::Sphere{{0.0, 50.0, 0.0}, 1.0}, world.border(medium_of(none, none)));
        // Where it fades across, too, the single cells along y and z lie in the middle: straight ahead they are as they are.
        const double cells = fades ? 2.0 + 0.5 * (1.0 + 3.0) : 0.5 + 2.0 + 1.5;
        expect_color(world.see(1000), glm::dvec3(std::exp(-0.4 * cells)));
    }
}

TEST(Media, ShineAsThickAsTheyAre) {
    const glm::dvec3 absorption(0.1, 0.5, 2.0);
    scene::Medium medium = medium_of(absorption, none);
    medium.emission = scene::Rgb(3.0, 2.0, 1.0);
    FogWorld world;
    world.add(scene::Sphere{}, world.border(medium));
    const glm::dvec3 expected = glm::dvec3(3.0, 2.0, 1.0) * (1.0 - glm::exp(-2.0 * absorption));
    expect_color(world.see(1), expected);
    medium.density = grid_of({3, 3, 3}, std::vector<float>(27, 1.0f), glm::dvec3(-1.0), glm::dvec3(1.0));
    FogWorld grid;
    grid.add(scene::Sphere{}, grid.border(medium));
    expect_color(grid.see(2000), expected);
}

// So thick that nothing shines through: a black body.
TEST(Media, GlowAtTheirTemperature) {
    for (const bool rgb : {true, false}) {
        scene::Medium medium = medium_of(scene::Rgb(30.0), none);
        medium.density = grid_of({2, 2, 2}, std::vector<float>(8, 1.0f), glm::dvec3(-1.0), glm::dvec3(1.0));
        medium.temperature = grid_of({2, 2, 2}, std::vector<float>(8, 2500.0f), glm::dvec3(-1.0), glm::dvec3(1.0));
        medium.emission = scene::Rgb(1.0);
        FogWorld world;
        world.scene.settings.rgb = rgb;
        world.add(scene::Sphere{}, world.border(medium));
        const glm::dvec3 expected = glm::max(to_rgb(blackbody(2500.0).scaled(cie_1931_area())), glm::dvec3(0.0));
        const Mean seen = world.see(rgb ? 1 : 4000);
        for (int i = 0; i < 3; ++i) {
            EXPECT_NEAR(seen.value[i] / expected.y, expected[i] / expected.y, deviations * seen.error[i] / expected.y + 2e-3) << rgb << i;
        }
    }
}

// Nothing is to be seen of a border between nothing and nothing.
TEST(Media, NullBordersAreInvisible) {
    const auto scene = [](bool bordered) {
        FogWorld world(4);
        world.scene.settings.rgb = false;
        world.scene.cameras[0].fov = 40.0;
        scene::Material wall;
        wall.model = scene::DiffuseMaterial{scene::Rgb(0.7, 0.4, 0.3), 0.0};
        world.add(scene::Sphere{{0.0, -20.0, 0.0}, 19.0}, world.material(wall));
        world.add_light(scene::PointLight{{2.0, 3.0, 2.0}}, 1.0);
        world.scene.lights[0].power = scene::Color(scene::Rgb(10.0));
        world.set_background(0.5, 1.0, 0.2);
        if (bordered) {
            scene::Material border;
            border.model = scene::NullMaterial{};
            world.add(scene::Sphere{{0.2, 0.1, 0.0}, 1.3}, world.material(border));
            world.add(scene::Box{{-1.0, -0.5, -1.0}, {1.5, 1.5, 3.0}}, 1);
        }
        return world;
    };
    const Mean with = scene(true).see(200), without = scene(false).see(200);
    // The same numbers decide, and rounding moves the rays.
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(with.value[i], without.value[i], 1e-3 * without.value[i]);
    }
}

// ---- Overlapping bodies --------------------------------------------------------------------------------------------------------------------

TEST(Media, OverlapByPriority) {
    for (const bool bodies : {false, true}) {
        for (const bool first_wins : {false, true}) {
            FogWorld world(8);
            world.set_background(1.0, 1.0, 1.0);
            // One from z = 2 to z = -1, the other from z = 1 to z = -2.
            int materials[2];
            for (const int i : {0, 1}) {
                const double absorption = i == 0 ? 0.2 : 0.5;
                const int priority = (i == 0) == first_wins ? 3 : -1;
                if (bodies) {
                    scene::Material glass;
                    glass.model = scene::DielectricMaterial{.refraction = 1.0, .absorption = scene::Rgb(absorption)};
                    glass.priority = priority;
                    materials[i] = world.material(glass);
                } else {
                    materials[i] = world.border(medium_of(scene::Rgb(absorption), none), priority);
                }
            }
            world.add(scene::Box{{-1.0, -1.0, -1.0}, {1.0, 1.0, 2.0}}, materials[0]);
            world.add(scene::Box{{-1.0, -1.0, -2.0}, {1.0, 1.0, 1.0}}, materials[1]);
            const double depth = first_wins ? 3.0 * 0.2 + 1.0 * 0.5 : 1.0 * 0.2 + 3.0 * 0.5;
            expect_color(world.see(4), glm::dvec3(std::exp(-depth)));
        }
    }
}

// The border of water is not there inside of glass: only what the glass and the rest of the water reflect is lost.
TEST(Media, CoveredBordersBendNothing) {
    const auto reflected = [](double a, double b) { return std::pow((a - b) / (a + b), 2.0); };
    FogWorld world(0);  // what comes straight through, of light from behind
    scene::Material glass, water;
    glass.model = scene::DielectricMaterial{.refraction = 1.6};
    glass.priority = 1;
    water.model = scene::DielectricMaterial{.refraction = 1.33};
    world.add(scene::Box{{-1.0, -1.0, 0.0}, {1.0, 1.0, 2.0}}, world.material(glass));
    world.add(scene::Box{{-1.0, -1.0, -2.0}, {1.0, 1.0, 1.0}}, world.material(water));
    scene::Material lamp;
    lamp.model = scene::DiffuseMaterial{scene::Rgb(0.0), 0.0};
    lamp.emission = scene::Emission{scene::Color(scene::Rgb(1.0))};
    world.add(scene::Box{{-1.0, -1.0, -5.0}, {1.0, 1.0, -4.0}}, world.material(lamp));
    world.scene.settings.bounces = 3;  // three borders and no more
    const double through = (1.0 - reflected(1.0, 1.6)) * (1.0 - reflected(1.6, 1.33)) * (1.0 - reflected(1.33, 1.0));
    expect_color(world.see(2000), glm::dvec3(through), 1e-3);
}

TEST(Media, AreEnteredInTheOrderOfTheirPriorities) {
    using namespace kernel;
    MediumRecord media[4] = {};
    for (int i = 0; i < 4; ++i) {
        media[i].priority = i == 2 ? 5 : i;
    }
    WorldRecord world{};
    world.media = media;
    world.has_priorities = 1;
    const auto put = [&](const Media& m, int material) { return entered_in_order(world, m, material, true); };
    Media m = put(put(put(put(no_media(), 2), 0), 3), 1);
    EXPECT_EQ(m.first, 2);
    EXPECT_EQ(m.second, 3);
    EXPECT_EQ(m.third, 1);
    EXPECT_EQ(m.fourth, 0);
    m = put(put(no_media(), 1), 1);  // of equals the last one first
    EXPECT_EQ(m.first, 1);
    EXPECT_EQ(m.second, 1);
    EXPECT_EQ(m.third, -1);
}

// What a ray leaves that started within was entered before what it left earlier: the same bodies, found from the inside out.
TEST(Media, AreFoundFromWithinAsTheyWereEntered) {
    using namespace kernel;
    for (const int orders : {0, 1}) {
        MediumRecord media[5] = {};
        for (int i = 0; i < 5; ++i) {
            media[i].priority = orders * (7 * i % 5 - 2);  // -2 0 2 -1 1
        }
        WorldRecord world{};
        world.media = media;
        world.has_priorities = orders;
        // Of five the one that counts least is forgotten, wherever it stands: the last one, or else the one that was entered first.
        for (int outermost = 0; outermost < 5; ++outermost) {
            std::vector<int> outwards;
            for (int i = 0; i < 5; ++i) {
                outwards.push_back((outermost + 1 + i) % 5);
            }
            Media entered = no_media(), found = no_media();
            for (int i = 0; i < 5; ++i) {
                entered = entered_in_order(world, entered, outwards[4 - static_cast<std::size_t>(i)], true);
                found = entered_before(world, found, outwards[static_cast<std::size_t>(i)], true);
            }
            EXPECT_EQ(found.first, orders == 0 ? outwards[0] : 2) << outermost;
            EXPECT_EQ(found.first, entered.first);
            EXPECT_EQ(found.second, entered.second);
            EXPECT_EQ(found.third, entered.third);
            EXPECT_EQ(found.fourth, entered.fourth);
        }
    }
}

// ---- The camera in the fog ------------------------------------------------------------------------------------------------------------------

TEST(Media, SurroundTheCamera) {
    const glm::dvec3 absorption(0.3, 0.2, 0.1);
    for (const int kind : {0, 1, 2}) {
        FogWorld world;
        world.set_background(1.0, 1.0, 1.0);
        const int border = world.border(medium_of(absorption, none));
        const int inner = world.border(medium_of(scene::Rgb(1.0), none));
        if (kind == 0) {
            world.add(scene::Sphere{{0.0, 0.0, 3.0}, 4.0}, border);
        } else if (kind == 1) {
            world.add(scene::Box{{-6.0, -4.0, -1.0}, {4.0, 9.0, 9.0}}, border);
        } else {
            auto mesh = std::make_shared<scene::TriangleMesh>();
            mesh->positions = {{-30, -30, -1}, {30, -30, -1}, {0, 60, -1}, {0, 0, 60}};
            mesh->triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
            world.add(scene::Mesh{mesh, false}, border);
        }
        world.add(scene::Sphere{{0.0, 0.0, 5.0}, 0.5}, inner);  // around the eye itself
        world.add(scene::Sphere{{3.0, 0.0, 5.0}, 0.5}, inner);  // and beside it
        expect_color(world.see(1), glm::exp(-absorption * 5.5 - 0.5));
    }
}

}  // namespace
}  // namespace lancer::tests
