// A ray that leaves a surface does not meet it again where it starts, for shapes of all sizes in all places: outwards a convex body is never met
// again; inwards the next thing met is its far side, seen from inside.
#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "analytic/families.h"

namespace lancer::tests {
namespace {

// Any direction; each second one grazes the surface, down to an angle of 1e-7.
glm::dvec3 any_direction(const Surface& surface, bool grazes, Dice& dice) {
    glm::dvec3 d = dice.direction();
    if (grazes) {
        const double along = glm::dot(d, surface.normal);
        d -= surface.normal * (along - std::copysign(dice.log_between(1e-7, 1.0), along));
    }
    return in_float.unit(d);
}

struct Tally {
    int points = 0;
    int again = 0;       // outwards: met again
    int no_exit = 0;     // inwards: the body has no far side
    int seen_twice = 0;  // inwards: met from outside

    void try_point(const Shape& shape, const Surface& surface, Dice& dice) {
        ++points;
        for (int i = 0; i < 8; ++i) {
            const glm::dvec3 direction = any_direction(surface, i % 2 == 1, dice);
            const Line line{in_float.leave(surface, direction), direction};
            const Met next = in_float.meet(shape, line);
            if (glm::dot(line.origin - surface.position, surface.normal) >= 0.0) {
                again += next.hits() ? 1 : 0;
            } else if (!next.hits()) {
                ++no_exit;
            } else {
                seen_twice += glm::dot(in_float.surface(shape, line, next).normal, direction) < 0.0 ? 1 : 0;
            }
        }
    }
};

void try_solids(const Placing& placing, double farthest_eye, std::uint64_t seed) {
    for (const Family& family : solid_families()) {
        Dice dice(seed);
        Tally tally;
        for (int i = 0; i < 300; ++i) {
            const PlacedShape placed = place(family, placing, dice);
            for (int j = 0; j < 20; ++j) {
                const glm::dvec3 eye = rounded(placed.center + dice.direction() * placed.size * dice.log_between(0.1, farthest_eye));
                const Line line{eye, in_float.unit(placed.center + dice.in_cube(placed.size) - eye)};
                const Met met = in_float.meet(placed.shape, line);
                if (met.hits()) {
                    tally.try_point(placed.shape, in_float.surface(placed.shape, line, met), dice);
                }
            }
        }
        EXPECT_GT(tally.points, 1500) << family.name;
        EXPECT_EQ(tally.again, 0) << family.name;
        // At its tip a cone far away is thinner than the rounding of its place.
        const int allowed = family.name == "cone" && placing.farthest > 0.0 ? tally.points * 8 / 1000 : 0;
        EXPECT_LE(tally.no_exit, allowed) << family.name;
        EXPECT_LE(tally.seen_twice, allowed) << family.name;
    }
}

TEST(SelfIntersection, SmallAndLarge) { try_solids({.smallest = 1e-3, .largest = 1e3}, 1e4, 51); }

TEST(SelfIntersection, FarFromTheOrigin) {
    // Down to a size of a thousand units of rounding of the place: there is no shape to speak of below.
    try_solids({.smallest = 1.0, .largest = 1e3, .farthest = 1e4, .rotates = true}, 100.0, 52);
    try_solids({.smallest = 1e-3, .largest = 1.0, .farthest = 10.0}, 100.0, 53);
}

TEST(SelfIntersection, Stretched) {
    try_solids({.smallest = 1e-3, .largest = 1e3, .stretch = 4.0, .rotates = true}, 1e3, 54);
    try_solids({.smallest = 1.0, .largest = 1e3, .stretch = 4.0, .farthest = 1e3, .rotates = true}, 10.0, 55);
}

// Flat shapes: on either side of them.
TEST(SelfIntersection, FlatShapes) {
    Dice dice(56);
    const Family disk{"disk", [](Dice& d) -> scene::Shape { return scene::Disk{d.in_cube(0.5), d.direction(), 1.0}; }};
    const Family plane{"plane", [](Dice& d) -> scene::Shape { return scene::Plane{d.in_cube(0.5), d.direction()}; }};
    const Family triangle{"triangle", [](Dice& d) -> scene::Shape {
                              auto mesh = std::make_shared<scene::TriangleMesh>();
                              for (int i = 0; i < 3; ++i) {
                                  mesh->positions.emplace_back(d.in_cube(1.0));
                              }
                              // Down to a thousandth as high as wide.
                              mesh->positions[2] =
                                  glm::mix(mesh->positions[0], mesh->positions[2], static_cast<float>(d.log_between(1e-3, 1.0)));
                              mesh->triangles = {{0, 1, 2}};
                              return scene::Mesh{mesh, false};
                          }};
    for (const Family& family : {disk, plane, triangle}) {
        int points = 0, again = 0;
        for (int i = 0; i < 2000; ++i) {
            const PlacedShape placed = place(
                family, {.smallest = 1e-3, .largest = 1e3, .stretch = 4.0, .farthest = dice.coin() ? 1.0 : 1e4, .rotates = true}, dice);
            for (int j = 0; j < 5; ++j) {
                const glm::dvec3 eye = rounded(placed.center + dice.direction() * placed.size * dice.log_between(0.1, 1e3));
                const Line line{eye, in_float.unit(placed.center + dice.in_cube(placed.size) - eye)};
                const Met met = in_float.meet(placed.shape, line);
                if (!met.hits()) {
                    continue;
                }
                ++points;
                const Surface surface = in_float.surface(placed.shape, line, met);
                for (int k = 0; k < 8; ++k) {
                    const glm::dvec3 direction = any_direction(surface, k % 2 == 1, dice);
                    again += in_float.meet(placed.shape, {in_float.leave(surface, direction), direction}).hits() ? 1 : 0;
                }
            }
        }
        EXPECT_GT(points, 150) << family.name;
        EXPECT_EQ(again, 0) << family.name;
    }
}

}  // namespace
}  // namespace lancer::tests
