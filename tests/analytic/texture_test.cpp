// Textures on shapes: which way up, not mirrored, in which colour.
#include <cstdio>
#include <numbers>
#include <string>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "analytic/small_world.h"
#include "lancer/image/image.h"
#include "temporary_folder.h"

namespace lancer::tests {
namespace {

const glm::dvec3 red(1, 0, 0), green(0, 1, 0), blue(0, 0, 1), white(1, 1, 1);

// A picture of four colours, in a folder of its own that goes with it:
//   blue | white
//   red  | green
class FourColors : public testing::Test {
protected:
    void SetUp() override {
        Image image;
        image.width = 8;
        image.height = 8;
        for (int y = 0; y < 8; ++y) {
            for (int x = 0; x < 8; ++x) {
                const glm::dvec3 color = y < 4 ? (x < 4 ? blue : white) : (x < 4 ? red : green);
                for (int c = 0; c < 3; ++c) {
                    image.pixels.push_back(static_cast<float>(color[c]));
                }
            }
        }
        texture_.file = folder_ / "four.png";
        texture_.filter = scene::Filter::nearest;
        write_image(texture_.file, image, {});
    }

    int add_material(SmallWorld& world) const {
        world.scene.ambient = glm::dvec3(1.0);
        scene::WhittedMaterial material = glowing(1.0);
        material.color = texture_;
        return world.add(material);
    }

    // The colours left below, right below, left above and right above the middle of the picture, `off` pixels from it.
    static void expect_upright(const SmallWorld& world, float off = 10.0f) {
        const float m = 50.5f;
        EXPECT_EQ(world.at({m - off, m + off}), red);
        EXPECT_EQ(world.at({m + off, m + off}), green);
        EXPECT_EQ(world.at({m - off, m - off}), blue);
        EXPECT_EQ(world.at({m + off, m - off}), white);
    }

    tests::TemporaryFolder folder_;
    scene::ImageTexture texture_;
};

struct View {
    glm::dvec3 from;  // and towards the origin
    glm::dvec3 up;
};

const View sides[] = {{{1, 0, 0}, {0, 1, 0}},  {{-1, 0, 0}, {0, 1, 0}}, {{0, 0, 1}, {0, 1, 0}},
                      {{0, 0, -1}, {0, 1, 0}}, {{0, 1, 0}, {0, 0, -1}}, {{0, -1, 0}, {0, 0, 1}}};

TEST_F(FourColors, OnTheSixFacesOfABox) {
    SmallWorld world;
    world.add(scene::Box{{-1.0, -2.0, -1.5}, {1.0, 2.0, 1.5}}, add_material(world));
    for (const View& view : sides) {
        world.look(view.from * 5.0, -view.from, view.up);
        expect_upright(world);
    }
}

// Whatever turns the box turns the picture on it.
TEST_F(FourColors, OnATurnedBox) {
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), 0.7, glm::normalize(glm::dvec3(1, 2, 3)));
    SmallWorld world;
    world.add(scene::Box{{-1.0, -2.0, -1.5}, {1.0, 2.0, 1.5}}, add_material(world), turn);
    for (const View& view : sides) {
        const glm::dvec3 from(turn * glm::dvec4(view.from, 0.0));
        world.look(from * 5.0, -from, glm::dvec3(turn * glm::dvec4(view.up, 0.0)));
        expect_upright(world);
    }
}

TEST_F(FourColors, OnASphere) {
    for (const bool is_placed : {false, true}) {
        SmallWorld world;
        world.add(scene::Sphere{{0, 0, 0}, 2.0}, add_material(world),
                  is_placed ? glm::scale(glm::dmat4(1.0), glm::dvec3(1.0, 1.2, 0.9)) : glm::dmat4(1.0));
        expect_upright(world);
        // Behind, at -z, left and right edge of the picture meet: u goes from 0.75 on to 1, then from 0 to 0.25.
        world.look({0, 0, -5}, {0, 0, 1});
        EXPECT_EQ(world.at({40.5, 60.5}), green);
        EXPECT_EQ(world.at({60.5, 60.5}), red);
        EXPECT_EQ(world.at({40.5, 40.5}), white);
        EXPECT_EQ(world.at({60.5, 40.5}), blue);
    }
}

// Where around the axis the picture starts is the shape's affair. Which way round it goes shows when it is shifted.
TEST_F(FourColors, OnACylinderAndACone) {
    const auto middle_of_red = [&](double top, double offset) {
        texture_.offset = {offset, 0.0};
        SmallWorld world;
        world.add(scene::Cone{{0, -1.5, 0}, {0, 1.5, 0}, 1.0, top, true}, add_material(world));
        glm::dvec2 sum(0.0);
        for (int i = 0; i < 72; ++i) {
            const double angle = (5.0 * i + 2.0) / 180.0 * std::numbers::pi;  // growing to the right
            const glm::dvec3 from(std::sin(angle), 0.0, std::cos(angle));
            world.look(from * 5.0, -from);
            const glm::dvec3 below = world.at({50.5, 58.5});
            EXPECT_EQ(world.at({50.5, 42.5}), below == red ? blue : white) << "above";
            sum += below == red ? glm::dvec2(from.x, from.z) : glm::dvec2(0.0);
        }
        return std::atan2(sum.x, sum.y);
    };
    for (const double top : {1.0, 0.4}) {
        // With an offset of 0.1 what was seen at u = 0.1 is seen where u is 0: a tenth of a turn to the left.
        const double turned = middle_of_red(top, 0.0) - middle_of_red(top, 0.1);
        EXPECT_NEAR(turned - 2.0 * std::numbers::pi * std::round(turned / (2.0 * std::numbers::pi)), 0.2 * std::numbers::pi, 0.1);
    }
}

TEST_F(FourColors, OnADiskSeenFromItsNormal) {
    SmallWorld world;
    world.add(scene::Disk{{0, 0, 0}, {0, 1, 0}, 2.0}, add_material(world));
    world.look({0, 5, 0}, {0, -1, 0}, {0, 0, -1});
    // Turned in some way, not mirrored: round the middle the colours follow one another as in the picture.
    const glm::dvec3 seen[4] = {world.at({40.5, 60.5}), world.at({60.5, 60.5}), world.at({60.5, 40.5}), world.at({40.5, 40.5})};
    const glm::dvec3 picture[4] = {red, green, white, blue};  // counter-clockwise
    int first = 0;
    while (first < 4 && picture[first] != seen[0]) {
        ++first;
    }
    ASSERT_LT(first, 4);
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(seen[i], picture[(first + i) % 4]);
    }
}

// On a plane a picture is a metre wide and its lower left corner at the origin.
TEST_F(FourColors, OnPlanes) {
    for (const View& view : sides) {
        SmallWorld world;
        world.add(scene::Plane{{0, 0, 0}, view.from}, add_material(world));
        const glm::dvec3 right = glm::cross(-view.from, view.up);
        const glm::dvec3 middle = 0.5 * right + 0.5 * view.up;
        world.look(middle + view.from, -view.from, view.up);
        expect_upright(world);
    }
}

TEST_F(FourColors, OnAMeshByItsCoordinates) {
    auto mesh = std::make_shared<scene::TriangleMesh>();
    mesh->positions = {{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}};
    mesh->uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
    SmallWorld world;
    world.add(scene::Mesh{mesh, true}, add_material(world));
    expect_upright(world);
    EXPECT_EQ(world.at({48.5, 52.5}), red);
}

TEST_F(FourColors, ScaledAndShifted) {
    texture_.scale = {2.0, 1.0};
    texture_.offset = {0.0, 0.5};
    SmallWorld world;
    world.add(scene::Box{{-2, -2, -1}, {2, 2, 0}}, add_material(world));
    // Twice across; half a picture higher up: what was above is below.
    EXPECT_EQ(world.at({40.5, 60.5}), white);
    EXPECT_EQ(world.at({35.5, 60.5}), blue);
    EXPECT_EQ(world.at({65.5, 60.5}), white);
    EXPECT_EQ(world.at({55.5, 60.5}), blue);
    EXPECT_EQ(world.at({55.5, 40.5}), red);
}

TEST_F(FourColors, Wraps) {
    auto mesh = std::make_shared<scene::TriangleMesh>();
    mesh->positions = {{-3, -1, 0}, {3, -1, 0}, {3, 1, 0}, {-3, 1, 0}};
    mesh->uvs = {{-1, 0}, {2, 0}, {2, 1}, {-1, 1}};
    mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
    // Seen from the front: the picture in the middle and one more on either side. One unit is 10.1 pixels.
    const auto row = [&](scene::Wrap wrap) {
        texture_.wrap = wrap;
        SmallWorld world;
        world.add(scene::Mesh{mesh, true}, add_material(world));
        std::string colors;
        for (const double x : {-2.5, -1.5, -0.5, 0.5, 1.5, 2.5}) {
            colors += world.at({50.5 + 10.1 * x, 53.5}) == red ? 'r' : 'g';
        }
        return colors;
    };
    EXPECT_EQ(row(scene::Wrap::repeat), "rgrgrg");
    EXPECT_EQ(row(scene::Wrap::clamp), "rrrggg");
    EXPECT_EQ(row(scene::Wrap::mirror), "grrggr");
}

TEST_F(FourColors, BilinearIsExactAtTexelMiddlesAndLinearBetween) {
    texture_.filter = scene::Filter::bilinear;
    texture_.wrap = scene::Wrap::clamp;
    SmallWorld world;
    world.add(scene::Box{{-4, -4, -1}, {4, 4, 0}}, add_material(world));  // a texel is one metre, a metre 10.1 pixels
    EXPECT_NEAR(world.at({50.5 - 5.05, 60.6}).x, 1.0, 1e-5) << "the middle of a red texel";
    EXPECT_NEAR(world.at({50.5 - 2.525, 60.6}).x, 0.75, 1e-5) << "a quarter on the way to the green one";
    EXPECT_NEAR(world.at({50.5 - 2.525, 60.6}).y, 0.25, 1e-5);
    EXPECT_NEAR(world.at({50.5, 50.5}).x, 0.5, 1e-5) << "where all four meet: red and white";
    EXPECT_NEAR(world.at({50.5, 50.5}).z, 0.5, 1e-5);
}

TEST(Checkers, SolidCellsFollowTheShape) {
    SmallWorld world;
    world.scene.ambient = glm::dvec3(1.0);
    scene::WhittedMaterial material = glowing(1.0);
    material.color = scene::Checker{red, blue, 0.5, true};
    const int checker = world.add(material);
    const auto colors = [](const SmallWorld& w) {
        std::string result;
        for (const double x : {-0.75, -0.25, 0.25, 0.75}) {
            result += w.at({50.5 + 10.1 * x, 47.5}) == red ? 'r' : 'b';
        }
        return result;
    };
    SmallWorld straight = world;
    straight.add(scene::Box{{-2, -2, -1}, {2, 2, 0.25}}, checker);
    EXPECT_EQ(colors(straight), "rbrb") << "the cell at the origin has the first colour";
    // Moved along by a cell, the pattern goes with it.
    SmallWorld moved = world;
    moved.add(scene::Box{{-2, -2, -1}, {2, 2, 0.25}}, checker, glm::translate(glm::dmat4(1.0), glm::dvec3(0.5, 0, 0)));
    EXPECT_EQ(colors(moved), "brbr");
    // Grown twice, a cell is a metre.
    SmallWorld grown = world;
    grown.add(scene::Box{{-2, -2, -1}, {2, 2, 0.25}}, checker, glm::scale(glm::dmat4(1.0), glm::dvec3(2.0, 2.0, 1.0)));
    EXPECT_EQ(colors(grown), "bbrr");
}

// A face that lies in a plane between cells shows one colour a cell, not noise: that of the cell under it.
TEST(Checkers, DoNotFlickerOnCellBoundaries) {
    SmallWorld world;
    world.scene.ambient = glm::dvec3(1.0);
    scene::WhittedMaterial material = glowing(1.0);
    material.color = scene::Checker{red, blue, 1.0, true};
    world.add(scene::Plane{{0, 0, 0}, {0, 1, 0}}, world.add(material));
    world.look({0.3, 2.0, 0.4}, {0, -1, 0}, {0, 0, -1});
    int differ = 0;
    const std::vector<glm::vec3> seen = world.picture(64);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            const double px = 0.3 + 2.0 * (x + 0.5 - 32.0) / 32.0, pz = 0.4 + 2.0 * (y + 0.5 - 32.0) / 32.0;
            const int cell = static_cast<int>(std::floor(px) + std::floor(pz));
            const bool is_near = std::abs(px - std::round(px)) < 0.01 || std::abs(pz - std::round(pz)) < 0.01;
            differ += !is_near && (seen[static_cast<std::size_t>(64 * y + x)] == glm::vec3(red)) != (cell % 2 != 0) ? 1 : 0;
        }
    }
    EXPECT_EQ(differ, 0);
}

TEST(Checkers, OnCoordinates) {
    SmallWorld world;
    world.scene.ambient = glm::dvec3(1.0);
    scene::WhittedMaterial material = glowing(1.0);
    material.color = scene::Checker{red, blue, 0.25, false};
    world.add(scene::Box{{-2, -2, -1}, {2, 2, 0}}, world.add(material));
    std::string colors;
    for (const double x : {-1.5, -0.5, 0.5, 1.5}) {
        colors += world.at({50.5 + 10.1 * x, 55.5}) == red ? 'r' : 'b';
    }
    EXPECT_EQ(colors, "brbr");  // the cell at (0, 0), lower left, has the first colour; this row is the second
}

}  // namespace
}  // namespace lancer::tests
