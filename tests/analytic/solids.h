// Closed forms of the convex shapes, worked out apart from the kernel and in double: where a line is inside.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "analytic/kernel_shapes.h"

namespace lancer::tests {

// Distances along a line between which it is inside; empty where in > out.
struct Span {
    double in = 1.0;
    double out = 0.0;

    bool empty() const { return !(in < out); }
};

// The shape with its surface moved outwards by `grow` (inwards where negative), in the space that it is canonical in. Disks, planes and
// triangles are no solids; capped cones are.
Span inside_of(const Shape& shape, const Line& line, double grow);

// The line in the space that the shape is canonical in: world space but for placed shapes.
Line to_object(const Shape& shape, const Line& line);

// How far a point in that space is outside of the shape's surface, negative inside; near the surface exact to first order.
double height_over(const Shape& shape, const glm::dvec3& p);

// The largest sum of magnitudes that goes into a coordinate of that line's point at distance t, plus the shape's own size: what the rounding of
// that point is proportional to.
double magnitude(const Shape& shape, const Line& line, double t);

}  // namespace lancer::tests
