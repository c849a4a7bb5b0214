// What the kernel says about the point that was hit: on the surface within the stated error, with outward normals of length 1, texture coordinates
// in their range, and all as in double.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "analytic/families.h"
#include "analytic/solids.h"

namespace lancer::tests {
namespace {

constexpr double u = 0x1p-24;

// World-space normal of the surface of a solid, and how fast its height in object space grows along it: by central differences.
glm::dvec3 slope(const Shape& shape, const glm::dvec3& p) {
    const double size = std::max(1.0, std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}));
    const double step = 1e-6 * size;
    glm::dvec3 gradient;
    for (int i = 0; i < 3; ++i) {
        glm::dvec3 to(0.0);
        to[i] = step;
        const Line above = to_object(shape, {p + to, glm::dvec3(1.0)});
        const Line below = to_object(shape, {p - to, glm::dvec3(1.0)});
        gradient[i] = (height_over(shape, above.origin) - height_over(shape, below.origin)) / (2.0 * step);
    }
    return gradient;
}

void try_solids(const Placing& placing, std::uint64_t seed) {
    for (const Family& family : solid_families()) {
        SCOPED_TRACE(family.name);
        Dice dice(seed);
        int points = 0, off = 0;
        double most = 0.0;
        for (int i = 0; i < 200; ++i) {
            const PlacedShape placed = place(family, placing, dice);
            for (int j = 0; j < 30; ++j) {
                const glm::dvec3 eye = rounded(placed.center + dice.direction() * placed.size * dice.log_between(0.1, 1e3));
                const Line line{eye, in_float.unit(placed.center + dice.in_cube(placed.size) - eye)};
                const Met met = in_float.meet(placed.shape, line);
                if (!met.hits()) {
                    continue;
                }
                ++points;
                const Surface s = in_float.surface(placed.shape, line, met);
                EXPECT_NEAR(glm::length(s.normal), 1.0, 8.0 * u);
                EXPECT_GE(std::min(s.uv.x, s.uv.y), 0.0);
                EXPECT_LE(std::max(s.uv.x, s.uv.y), 1.0);
                // How far off the exact surface the point lies, against the error's share across the surface.
                const double height = std::abs(height_over(placed.shape, to_object(placed.shape, {s.position, line.direction}).origin));
                const double rise = glm::length(slope(placed.shape, s.position));
                const double allowed = glm::dot(glm::abs(s.normal), s.error);
                most = std::max(most, height / rise / allowed);
                off += height / rise > allowed ? 1 : 0;
                // Outwards: seen from outside it faces the eye, from inside it does not.
                const bool outside = height_over(placed.shape, to_object(placed.shape, line).origin) > 0.0;
                EXPECT_EQ(glm::dot(s.normal, line.direction) < 0.0, outside);
            }
        }
        EXPECT_GT(points, 1500);
        EXPECT_EQ(off, 0) << "the error is exceeded " << most << " times";
        if (family.name != "box" || placing.rotates) {  // boxes along the axes are met exactly
            EXPECT_GT(most, 0.02) << "the error is too large to be a useful bound";
        }
    }
}

TEST(SurfacePoints, LieOnSolidsWithinTheirError) {
    try_solids({.smallest = 1e-3, .largest = 1e3, .farthest = 1.0}, 61);
    try_solids({.smallest = 1e-2, .largest = 1e2, .stretch = 4.0, .farthest = 10.0, .rotates = true}, 62);
}

// Away from edges and silhouettes the float's normal and coordinates are the double's.
TEST(SurfacePoints, AreThoseOfDoubles) {
    for (const Family& family : solid_families()) {
        SCOPED_TRACE(family.name);
        Dice dice(63);
        int compared = 0;
        for (int i = 0; i < 200; ++i) {
            const PlacedShape placed =
                place(family, {.smallest = 0.1, .largest = 10.0, .stretch = 2.0, .farthest = 1.0, .rotates = true}, dice);
            for (int j = 0; j < 20; ++j) {
                const glm::dvec3 eye = rounded(placed.center + dice.direction() * placed.size * 3.0);
                const Line line{eye, in_float.unit(placed.center + dice.in_cube(0.5 * placed.size) - eye)};
                const Met met = in_float.meet(placed.shape, line);
                const Met exact_met = in_double.meet(placed.shape, line);
                if (!met.hits() || !exact_met.hits()) {
                    continue;
                }
                const Surface s = in_float.surface(placed.shape, line, met);
                const Surface exact = in_double.surface(placed.shape, line, exact_met);
                if (glm::dot(exact.normal, line.direction) > -0.2 || glm::dot(s.normal, exact.normal) < 0.9) {
                    continue;
                }
                ++compared;
                const double scale = placed.size + glm::length(placed.center);
                EXPECT_LT(glm::length(s.position - exact.position), 2e-5 * scale);
                EXPECT_LT(glm::length(s.normal - exact.normal), 2e-5);
                EXPECT_LT(glm::length(s.local - exact.local), 2e-5 * scale);
                const double across = std::abs(s.uv.x - exact.uv.x);
                EXPECT_LT(std::min(across, 1.0 - across), 1e-4);  // around the seam, 0 is 1
                EXPECT_LT(std::abs(s.uv.y - exact.uv.y), 1e-4);
            }
        }
        EXPECT_GT(compared, 1000);
    }
}

TEST(SurfacePoints, LieOnPlanesAndTrianglesWithinTheirError) {
    Dice dice(64);
    int points = 0;
    for (int i = 0; i < 3000; ++i) {
        const glm::dvec3 middle = dice.in_cube(dice.log_between(0.1, 1e4));
        const Shape plane = compile_shape(scene::Plane{middle, dice.direction()});
        const glm::dvec3 eye = rounded(middle + dice.direction() * dice.log_between(0.1, 1e3));
        const Line line{eye, in_float.unit(middle + dice.in_cube(1.0) - eye)};
        if (const Met met = in_float.meet(plane, line); met.hits()) {
            ++points;
            const Surface s = in_float.surface(plane, line, met);
            EXPECT_NEAR(glm::length(s.normal), 1.0, 4.0 * u);
            const glm::dvec3 n(plane.plane.normal);
            EXPECT_LE(std::abs(glm::dot(n, s.position) - static_cast<double>(plane.plane.offset)), glm::dot(glm::abs(s.normal), s.error));
        }
        Shape triangle;
        triangle.kind = kernel::OBJECT_TRIANGLE;
        triangle.triangle = {kernel::vec3(middle + dice.in_cube(1.0)), kernel::vec3(middle + dice.in_cube(1.0)),
                             kernel::vec3(middle + dice.in_cube(1.0))};
        if (const Met met = in_float.meet(triangle, line); met.hits()) {
            ++points;
            const Surface s = in_float.surface(triangle, line, met);
            const glm::dvec3 a(triangle.triangle.a), b(triangle.triangle.b), c(triangle.triangle.c);
            const glm::dvec3 n = glm::normalize(glm::cross(b - a, c - a));
            EXPECT_NEAR(glm::length(s.normal), 1.0, 8.0 * u);
            EXPECT_LE(std::abs(glm::dot(n, s.position - a)), glm::dot(glm::abs(n), s.error));
        }
    }
    EXPECT_GT(points, 2000);
}

// Counter-clockwise seen from outside.
TEST(SurfacePoints, TrianglesFaceThoseWhoSeeThemCounterClockwise) {
    Shape shape;
    shape.kind = kernel::OBJECT_TRIANGLE;
    shape.triangle = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const Line line{{0.25, 0.25, -2.0}, {0.0, 0.0, 1.0}};
    EXPECT_EQ(in_float.surface(shape, line, in_float.meet(shape, line)).normal, glm::dvec3(0.0, 0.0, 1.0));
}

}  // namespace
}  // namespace lancer::tests
