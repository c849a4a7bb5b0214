// Planes, disks, open cylinders and cones, single triangles: float against closed forms in double. Rays that pass an edge by less than the
// rounding of the question are left out, and counted: they must be few.
#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "analytic/families.h"
#include "analytic/solids.h"

namespace lancer::tests {
namespace {

constexpr double u = 0x1p-24;

struct Expected {
    double t = nothing;
    double error = 0.0;      // of t
    bool is_certain = true;  // whether it is hit at all
};

void compare(const Shape& shape, const Line& line, const Expected& expected, int& compared, int& uncertain, int& faults) {
    if (!expected.is_certain) {
        ++uncertain;
        return;
    }
    ++compared;
    const Met met = in_float.meet(shape, line);
    const bool good = expected.t < nothing ? std::abs(met.t - expected.t) <= expected.error : !met.hits();
    if (!good && ++faults <= 3) {
        ADD_FAILURE() << "t " << met.t << ", exact " << expected.t << " +- " << expected.error;
    }
}

void expect_most_compared(int compared, int uncertain, int faults) {
    EXPECT_EQ(faults, 0);
    EXPECT_GT(compared, 20 * uncertain);
    EXPECT_GT(compared, 2000);
}

// A sum of n products rounds by n + 1 units of the sum of their magnitudes at most; half of that is asked for.
Expected plane_exactly(const Shape& shape, const Line& line) {
    const glm::dvec3 n(shape.plane.normal);
    const double offset = static_cast<double>(shape.plane.offset);
    const double across = glm::dot(n, line.direction);
    const double t = (offset - glm::dot(n, line.origin)) / across;
    Expected e;
    e.error = 4.0 * u * (glm::dot(glm::abs(n), glm::abs(line.origin) + std::abs(t) * glm::abs(line.direction)) + std::abs(offset)) /
              std::abs(across);
    e.is_certain = std::abs(across) > 8.0 * u && std::abs(t) > e.error;
    e.t = t > 0.0 ? t : nothing;
    return e;
}

TEST(OpenShapes, Planes) {
    Dice dice(21);
    int compared = 0, uncertain = 0, faults = 0;
    for (int i = 0; i < 100; ++i) {
        const Shape shape = compile_shape(scene::Plane{dice.in_cube(dice.log_between(0.1, 1e4)), dice.direction()});
        for (int j = 0; j < 60; ++j) {
            const Line line{rounded(dice.in_cube(dice.log_between(0.1, 1e4))), in_float.unit(dice.direction())};
            compare(shape, line, plane_exactly(shape, line), compared, uncertain, faults);
        }
    }
    expect_most_compared(compared, uncertain, faults);
}

TEST(OpenShapes, ParallelRaysMissPlanes) {
    const Shape floor = compile_shape(scene::Plane{{0.0, 2.0, 0.0}, {0.0, 1.0, 0.0}});
    for (const double zero : {0.0, -0.0}) {
        for (const double height : {1.0, 2.0, 3.0}) {
            EXPECT_FALSE(in_float.meet(floor, {{0.0, height, 0.0}, {1.0, zero, 0.0}}).hits());
            EXPECT_FALSE(in_float.meet(floor, {{0.0, height, 0.0}, {-1.0, zero, zero}}).hits());
        }
    }
    EXPECT_FALSE(in_float.meet(floor, {{0.0, 2.0, 0.0}, {0.0, 1.0, 0.0}}).hits()) << "from the plane itself";
    EXPECT_EQ(in_float.meet(floor, {{0.0, 1.0, 0.0}, {0.0, 1.0, 0.0}}).t, 1.0);
}

Expected disk_exactly(const Shape& shape, const Line& line) {
    const auto [o, d] = to_object(shape, line);
    const double t = -o.y / d.y;
    const double e = 4.0 * u * magnitude(shape, line, t);
    const double radius = std::hypot(o.x + t * d.x, o.z + t * d.z);
    Expected expected;
    expected.error = e / std::abs(d.y);
    const double slip = e + expected.error * std::hypot(d.x, d.z);
    expected.is_certain = std::abs(radius - 1.0) > slip && (std::abs(t) > expected.error || radius > 1.0 + slip);
    expected.t = t > 0.0 && radius < 1.0 ? t : nothing;
    return expected;
}

TEST(OpenShapes, Disks) {
    Dice dice(22);
    int compared = 0, uncertain = 0, faults = 0;
    const Family family{"disk", [](Dice& d) -> scene::Shape {
                            return scene::Disk{d.in_cube(0.5), d.direction(), d.log_between(0.2, 2.0)};
                        }};
    for (int i = 0; i < 100; ++i) {
        const PlacedShape placed =
            place(family, {.smallest = 1e-2, .largest = 1e2, .stretch = 4.0, .farthest = 10.0, .rotates = true}, dice);
        for (int j = 0; j < 60; ++j) {
            const glm::dvec3 origin = rounded(placed.center + dice.direction() * placed.size * dice.log_between(0.1, 1e3));
            const Line line{origin, in_float.unit(placed.center + dice.in_cube(2.0 * placed.size) - origin)};
            compare(placed.shape, line, disk_exactly(placed.shape, line), compared, uncertain, faults);
        }
    }
    expect_most_compared(compared, uncertain, faults);
}

// By substitution: x^2 + z^2 = (bottom + k y)^2 is a t^2 + 2 b t + c = 0, from the line's point nearest the shape.
Expected open_cone_exactly(const Shape& shape, const Line& line) {
    const auto [origin, d] = to_object(shape, line);
    const double middle = -glm::dot(origin, d) / glm::dot(d, d);
    const glm::dvec3 o = origin + d * middle;
    const double bottom = static_cast<double>(shape.placed.bottom_radius);
    const double k = static_cast<double>(shape.placed.top_radius) - bottom;
    const double radius = bottom + k * o.y;
    const double a = d.x * d.x + d.z * d.z - k * k * d.y * d.y;
    const double b = o.x * d.x + o.z * d.z - k * d.y * radius;
    const double c = o.x * o.x + o.z * o.z - radius * radius;
    const double discriminant = b * b - a * c;
    const double e = 4.0 * u * magnitude(shape, line, std::abs(middle));
    Expected expected;
    if (discriminant < 0.0) {
        // How far the line stays outside, from the least of the polynomial.
        expected.is_certain = -discriminant / a > 8.0 * e * (std::abs(radius) + std::hypot(o.x, o.z) + e);
        return expected;
    }
    const double root = std::sqrt(discriminant);
    double roots[2] = {middle + (-b - root) / a, middle + (-b + root) / a};
    std::sort(std::begin(roots), std::end(roots));
    for (const double t : roots) {
        const double y = origin.y + t * d.y;
        // The surface's height over the line changes by 2 root for each t: the error of t is the surface's error over that.
        const double t_error =
            8.0 * e * (std::hypot(o.x, o.z) + std::abs(radius) + glm::length(d) * std::abs(t - middle)) / (2.0 * root) + e / glm::length(d);
        const double y_error = e + t_error * std::abs(d.y);
        if (y < -y_error || y > 1.0 + y_error || t < -t_error) {
            continue;
        }
        expected.t = t;
        expected.error = t_error;
        expected.is_certain = y > y_error && y < 1.0 - y_error && t > t_error;
        break;
    }
    return expected;
}

TEST(OpenShapes, CylindersAndConesWithoutCaps) {
    Dice dice(23);
    for (const double top : {1.0, 0.5, 0.0}) {
        int compared = 0, uncertain = 0, faults = 0;
        const Family family{"cone", [top](Dice& d) -> scene::Shape {
                                const glm::dvec3 from = d.in_cube(0.5);
                                const double radius = d.log_between(0.3, 2.0);
                                return scene::Cone{from, from + d.direction() * d.log_between(0.3, 2.0), radius, radius * top, false};
                            }};
        for (int i = 0; i < 100; ++i) {
            const PlacedShape placed =
                place(family, {.smallest = 0.1, .largest = 10.0, .stretch = 3.0, .farthest = 5.0, .rotates = true}, dice);
            for (int j = 0; j < 60; ++j) {
                const glm::dvec3 origin = rounded(placed.center + dice.direction() * placed.size * dice.log_between(0.1, 100.0));
                const Line line{origin, in_float.unit(placed.center + dice.in_cube(2.0 * placed.size) - origin)};
                compare(placed.shape, line, open_cone_exactly(placed.shape, line), compared, uncertain, faults);
            }
        }
        expect_most_compared(compared, uncertain, faults);
    }
}

// One sees through an open cylinder along its axis, and not through a closed one.
TEST(OpenShapes, AlongTheAxis) {
    for (const double zero : {0.0, -0.0}) {
        const Line down{{0.25, 5.0, 0.0}, {zero, -1.0, zero}};
        EXPECT_FALSE(in_float.meet(compile_shape(scene::Cylinder{{0, 0, 0}, {0, 1, 0}, 0.5, false}), down).hits());
        const Shape closed = compile_shape(scene::Cylinder{{0, 0, 0}, {0, 1, 0}, 0.5, true});
        EXPECT_NEAR(in_float.meet(closed, down).t, 4.0, 1e-6);
        EXPECT_NEAR(in_float.meet(closed, {{0.25, 0.5, 0.0}, {zero, -1.0, zero}}).t, 0.5, 1e-6);
        EXPECT_FALSE(in_float.meet(closed, {{0.75, 5.0, 0.0}, {zero, -1.0, zero}}).hits());
        const Shape cone = compile_shape(scene::Cone{{0, 0, 0}, {0, 1, 0}, 1.0, 0.0, true});
        EXPECT_NEAR(in_float.meet(cone, {{0.0, 5.0, 0.0}, {zero, -1.0, zero}}).t, 4.0, 1e-6) << "onto the tip";
        EXPECT_NEAR(in_float.meet(cone, {{0.0, -5.0, 0.0}, {zero, 1.0, zero}}).t, 5.0, 1e-6) << "onto the base";
    }
}

// Möller and Trumbore's solution of o + t d = a + v (b - a) + w (c - a), in double.
Expected triangle_exactly(const Shape& shape, const Line& line) {
    const glm::dvec3 a(shape.triangle.a), b(shape.triangle.b), c(shape.triangle.c);
    const glm::dvec3 ab = b - a, ac = c - a, ao = line.origin - a;
    const glm::dvec3 n = glm::cross(ab, ac);
    const double across = glm::dot(n, line.direction);
    const double t = -glm::dot(n, ao) / across;
    const glm::dvec3 q = glm::cross(ao, line.direction);
    const double v = -glm::dot(ac, q) / across;
    const double w = glm::dot(ab, q) / across;
    const double size = glm::length(ab) + glm::length(ac);
    const double reach = std::max({glm::length(a - line.origin), glm::length(b - line.origin), glm::length(c - line.origin)});
    const double scale = glm::length(ab) * glm::length(ac) / std::abs(across);  // 1 for a right angle seen face on
    Expected expected;
    expected.error = 8.0 * u * reach * scale;
    // The corners as seen move by 4 u reach: a share of the triangle's height over each edge.
    const double share = 8.0 * u * reach * size / std::abs(across);
    const double inside = std::min({v, w, 1.0 - v - w});
    expected.is_certain = std::abs(inside) > share && std::abs(t) > expected.error;
    expected.t = inside > 0.0 && t > 0.0 ? t : nothing;
    return expected;
}

TEST(OpenShapes, Triangles) {
    Dice dice(24);
    int compared = 0, uncertain = 0, faults = 0;
    for (int i = 0; i < 300; ++i) {
        const double size = dice.log_between(1e-3, 1e3);
        const glm::dvec3 center = dice.in_cube(10.0 * size);
        Shape shape;
        shape.kind = kernel::OBJECT_TRIANGLE;
        shape.triangle = {kernel::vec3(center + dice.in_cube(size)), kernel::vec3(center + dice.in_cube(size)),
                          kernel::vec3(center + dice.in_cube(size))};
        for (int j = 0; j < 30; ++j) {
            const glm::dvec3 origin = rounded(center + dice.direction() * size * dice.log_between(0.5, 1e3));
            const Line line{origin, in_float.unit(center + dice.in_cube(size) - origin)};
            compare(shape, line, triangle_exactly(shape, line), compared, uncertain, faults);
        }
    }
    expect_most_compared(compared, uncertain, faults);
}

TEST(OpenShapes, TriangleCoordinatesFollowItsCorners) {
    Shape shape;
    shape.kind = kernel::OBJECT_TRIANGLE;
    shape.triangle = {{0, 0, 0}, {4, 0, 0}, {0, 2, 0}};
    for (const double side : {1.0, -1.0}) {
        const Met met = in_float.meet(shape, {{1.0, 0.5, 3.0 * side}, {0.0, 0.0, -side}});
        EXPECT_EQ(met.t, 3.0);
        EXPECT_NEAR(met.u, 0.25, 1e-6);
        EXPECT_NEAR(met.v, 0.25, 1e-6);
    }
    EXPECT_FALSE(in_float.meet(shape, {{-1.0, 0.5, 0.0}, {1.0, 0.0, 0.0}}).hits()) << "edge on";
    shape.triangle = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    EXPECT_FALSE(in_float.meet(shape, {{1.0, 0.0, 3.0}, {0.0, 0.0, -1.0}}).hits()) << "a triangle without area";
}

}  // namespace
}  // namespace lancer::tests
