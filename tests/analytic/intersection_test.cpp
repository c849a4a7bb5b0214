// Where rays meet shapes: the kernel in float and in double against closed forms worked out apart from it.
//
// The bound. Every number that goes into a crossing is a sum of products of what is given, so the crossing found is the exact one of a shape
// whose surface is moved by some units of rounding of the largest sum, which grows with the distance to the origin and the distance travelled:
// `magnitude`. Count for the longest chain, a placed cone: 4 for the ray's origin in object space and 4 for its direction, 4 for moving it near
// the shape, 6 for the coefficients of the polynomial, 4 for a direction that is a unit vector to 4 roundings only, 2 for the sums of t: 24 at
// the very worst. They never all pull one way; these tests ask for e = 4 u magnitude. The answer must lie between those for the shape shrunk by e
// and grown by e. Near a silhouette the two lie far apart, by the conditioning of the question and not by a tolerance: where the shrunk one is
// missed and the grown one met, either answer is right.
#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "analytic/families.h"
#include "analytic/solids.h"

namespace lancer::tests {
namespace {

constexpr double float_rounding = 0x1p-24;
constexpr double double_rounding = 0x1p-53;
constexpr double roundings = 4.0;

// Empty when the kernel's answer is one that exact arithmetic gives for a surface moved by no more than the bound.
std::string find_fault(const Shape& shape, const Line& line, const Met& met, double rounding) {
    const Span exact = inside_of(shape, line, 0.0);
    const double t = met.hits() ? met.t : exact.empty() ? 0.0 : exact.in > 0.0 ? exact.in : std::max(exact.out, 0.0);
    const double middle = std::abs(glm::dot(line.origin, line.direction));  // where a line that misses passes, at most
    const double moved = roundings * rounding * magnitude(shape, line, exact.empty() && !met.hits() ? middle : t);
    const Span grown = inside_of(shape, line, moved);
    const Span shrunk = inside_of(shape, line, -moved);
    const double slack = roundings * rounding * std::abs(t);
    const auto text = [&](const char* what) {
        return std::string(what) + ": t " + std::to_string(met.t) + ", exact " + std::to_string(exact.in) + " to " +
               std::to_string(exact.out) + ", surface moved by " + std::to_string(moved);
    };
    if (!met.hits()) {
        return !shrunk.empty() && shrunk.out > slack ? text("missed") : "";
    }
    if (!(met.t > 0.0)) {
        return text("not in front");
    }
    if (grown.empty()) {
        return text("met where nothing is");
    }
    const double last_entry = shrunk.empty() ? grown.out : shrunk.in;
    const double first_exit = shrunk.empty() ? grown.in : shrunk.out;
    const bool enters = met.t >= grown.in - slack && met.t <= last_entry + slack;
    const bool leaves = met.t >= first_exit - slack && met.t <= grown.out + slack && grown.in <= slack;
    return enters || leaves ? "" : text("at a wrong place");
}

Line aimed(const glm::dvec3& from, const glm::dvec3& at, const Kernel& kernel) {
    const glm::dvec3 origin = rounded(from);
    return {origin, kernel.unit(at - origin)};
}

// Rays of all sorts: from far and near, from inside, at random, grazing the silhouette, along the axes.
Line any_line(const PlacedShape& placed, int sort, Dice& dice, const Kernel& kernel) {
    const auto& [shape, center, size] = placed;
    const double distance = size * dice.log_between(2.0, 1e4);
    const glm::dvec3 outside = center + dice.direction() * distance;
    const glm::dvec3 near = center + dice.in_cube(2.0 * size);
    switch (sort % 5) {
        case 0:
            return aimed(outside, near, kernel);
        case 1:
            return aimed(near, center + dice.in_cube(2.0 * size), kernel);
        case 2: {  // along an axis, with zeros of both signs
            const int axis = dice.below(3);
            glm::dvec3 direction(0.0);
            for (int i = 0; i < 3; ++i) {
                direction[i] = i == axis ? dice.sign() : std::copysign(0.0, dice.sign());
            }
            return {rounded(near - direction * (dice.coin() ? distance : 0.0)), direction};
        }
        case 3: {  // nearly in a coordinate plane
            glm::dvec3 direction = dice.direction();
            direction[dice.below(3)] = dice.sign() * dice.log_between(1e-30, 1e-3);
            direction = kernel.unit(direction);
            return {rounded(near - direction * distance), direction};
        }
        default: {  // past the silhouette: aim at a point near the last one that is met, found by bisection in double
            const glm::dvec3 origin = rounded(outside);
            glm::dvec3 in = center, out = center + dice.direction() * 8.0 * size;
            for (int i = 0; i < 40; ++i) {
                const glm::dvec3 half = 0.5 * (in + out);
                (inside_of(shape, {origin, glm::normalize(half - origin)}, 0.0).empty() ? out : in) = half;
            }
            return aimed(origin, in + (in - center) * dice.sign() * dice.log_between(1e-12, 1e-2), kernel);
        }
    }
}

void try_family(const Family& family, const Placing& placing, std::uint64_t seed) {
    Dice dice(seed);
    int hits = 0, misses = 0, faults = 0;
    for (int i = 0; i < 60; ++i) {
        const PlacedShape placed = place(family, placing, dice);
        for (int j = 0; j < 100; ++j) {
            const Line line = any_line(placed, j, dice, in_float);
            const Met met = in_float.meet(placed.shape, line);
            (met.hits() ? hits : misses)++;
            const std::string fault = find_fault(placed.shape, line, met, float_rounding);
            // The same question in double, to a double's rounding: the formulas are right, not only as exact as a float.
            const Line exact_line = any_line(placed, j, dice, in_double);
            const std::string exact_fault =
                find_fault(placed.shape, exact_line, in_double.meet(placed.shape, exact_line), double_rounding * (1 << 6));
            if ((!fault.empty() || !exact_fault.empty()) && ++faults <= 3) {
                ADD_FAILURE() << family.name << " " << i << ", line " << j << ": float: " << fault << "; double: " << exact_fault;
            }
        }
    }
    EXPECT_EQ(faults, 0);
    EXPECT_GT(hits, 500);
    EXPECT_GT(misses, 500);
}

TEST(Intersection, SolidsInWorldSpace) {
    for (const Family& family : solid_families()) {
        SCOPED_TRACE(family.name);
        try_family(family, {}, 11);
        try_family(family, {.smallest = 1e-3, .largest = 1e3, .farthest = 10.0}, 12);
    }
}

TEST(Intersection, SolidsTurnedAndStretched) {
    for (const Family& family : solid_families()) {
        SCOPED_TRACE(family.name);
        try_family(family, {.smallest = 1e-3, .largest = 1e3, .stretch = 5.0, .farthest = 1.0, .rotates = true}, 13);
        try_family(family, {.smallest = 1.0, .largest = 100.0, .stretch = 5.0, .farthest = 1e4, .rotates = true}, 14);
    }
}

}  // namespace
}  // namespace lancer::tests
