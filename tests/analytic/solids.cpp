#include "analytic/solids.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace lancer::tests {

namespace {

glm::dvec3 rows_times(const kernel::AffineRecord& map, const glm::dvec3& v) {
    return {glm::dot(glm::dvec3(map.row_x), v), glm::dot(glm::dvec3(map.row_y), v), glm::dot(glm::dvec3(map.row_z), v)};
}

double largest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

// Real roots of a t^2 + 2 b t + c.
void add_roots(double a, double b, double c, std::vector<double>& roots) {
    if (a == 0.0) {
        if (b != 0.0) {
            roots.push_back(-c / (2.0 * b));
        }
        return;
    }
    const double discriminant = b * b - a * c;
    if (discriminant >= 0.0) {
        const double q = -(b + std::copysign(std::sqrt(discriminant), b));
        roots.push_back(q / a);
        if (q != 0.0) {
            roots.push_back(c / q);
        }
    }
}

void add_planes(double origin, double direction, double low, double high, std::vector<double>& roots) {
    if (direction != 0.0) {
        roots.push_back((low - origin) / direction);
        roots.push_back((high - origin) / direction);
    }
}

bool is_box(int kind) { return kind == kernel::OBJECT_BOX || kind == kernel::OBJECT_PLACED_BOX; }

double sphere_radius(const Shape& shape) { return shape.kind == kernel::OBJECT_SPHERE ? static_cast<double>(shape.sphere.radius) : 1.0; }

glm::dvec3 box_low(const Shape& shape) { return shape.kind == kernel::OBJECT_BOX ? glm::dvec3(shape.box.low) : glm::dvec3(-1.0); }
glm::dvec3 box_high(const Shape& shape) { return shape.kind == kernel::OBJECT_BOX ? glm::dvec3(shape.box.high) : glm::dvec3(1.0); }

}  // namespace

Line to_object(const Shape& shape, const Line& line) {
    if (shape.kind < kernel::OBJECT_PLACED_SPHERE || shape.kind > kernel::OBJECT_PLACED_CONE) {
        return {shape.kind == kernel::OBJECT_SPHERE ? line.origin - glm::dvec3(shape.sphere.center) : line.origin, line.direction};
    }
    return {rows_times(shape.placed.to_object, line.origin) + glm::dvec3(shape.placed.to_object.shift),
            rows_times(shape.placed.to_object, line.direction)};
}

double height_over(const Shape& shape, const glm::dvec3& p) {
    if (is_box(shape.kind)) {
        return largest(glm::max(box_low(shape) - p, p - box_high(shape)));
    }
    if (shape.kind == kernel::OBJECT_PLACED_CONE) {
        const double bottom = static_cast<double>(shape.placed.bottom_radius);
        const double k = static_cast<double>(shape.placed.top_radius) - bottom;
        return std::max({-p.y, p.y - 1.0, (std::hypot(p.x, p.z) - (bottom + k * p.y)) / std::sqrt(1.0 + k * k)});
    }
    return glm::length(p) - sphere_radius(shape);
}

Span inside_of(const Shape& shape, const Line& line, double grow) {
    const auto [origin, d] = to_object(shape, line);
    // From the line's point nearest the middle: so the rounding of this very function stays far below that of floats.
    const double middle = -glm::dot(origin, d) / glm::dot(d, d);
    const glm::dvec3 o = origin + d * middle;
    std::vector<double> roots;
    if (is_box(shape.kind)) {
        const glm::dvec3 low = box_low(shape) - grow;
        const glm::dvec3 high = box_high(shape) + grow;
        for (int i = 0; i < 3; ++i) {
            add_planes(o[i], d[i], low[i], high[i], roots);
        }
    } else if (shape.kind == kernel::OBJECT_PLACED_CONE) {
        // Moving the side outwards makes its radius larger by the slanted width.
        const double k = static_cast<double>(shape.placed.top_radius) - static_cast<double>(shape.placed.bottom_radius);
        const double bottom = static_cast<double>(shape.placed.bottom_radius) + grow * std::sqrt(1.0 + k * k);
        const double radius = bottom + k * o.y;
        add_roots(d.x * d.x + d.z * d.z - k * d.y * k * d.y, o.x * d.x + o.z * d.z - k * d.y * radius,
                  o.x * o.x + o.z * o.z - radius * radius, roots);
        add_planes(o.y, d.y, -grow, 1.0 + grow, roots);
    } else {
        const double radius = sphere_radius(shape) + grow;
        const double half_2 = (radius * radius - glm::dot(o, o)) / glm::dot(d, d);
        if (radius > 0.0 && half_2 > 0.0) {
            roots = {-std::sqrt(half_2), std::sqrt(half_2)};
        }
    }
    roots.erase(std::remove_if(roots.begin(), roots.end(), [](double t) { return !std::isfinite(t); }), roots.end());
    std::sort(roots.begin(), roots.end());
    // The shape is convex: the stretches whose middles are inside stand side by side.
    Span span;
    for (std::size_t i = 0; i + 1 < roots.size(); ++i) {
        if (roots[i] < roots[i + 1] && height_over(shape, o + d * (0.5 * (roots[i] + roots[i + 1]))) < grow) {
            span.in = span.empty() ? roots[i] + middle : span.in;
            span.out = roots[i + 1] + middle;
        }
    }
    return span;
}

double magnitude(const Shape& shape, const Line& line, double t) {
    const glm::dvec3 o = glm::abs(line.origin);
    const glm::dvec3 d = glm::abs(line.direction) * std::abs(t);
    if (shape.kind == kernel::OBJECT_SPHERE) {
        const glm::dvec3 f = glm::abs(line.origin - glm::dvec3(shape.sphere.center));
        return glm::length(f) + glm::length(d) + static_cast<double>(shape.sphere.radius);
    }
    if (shape.kind == kernel::OBJECT_BOX) {
        return largest(o + d + glm::max(glm::abs(box_low(shape)), glm::abs(box_high(shape))));
    }
    glm::dvec3 sum = glm::abs(glm::dvec3(shape.placed.to_object.shift)) + 1.0;
    const kernel::vec3 rows[3] = {shape.placed.to_object.row_x, shape.placed.to_object.row_y, shape.placed.to_object.row_z};
    for (int i = 0; i < 3; ++i) {
        sum[i] += glm::dot(glm::abs(glm::dvec3(rows[i])), o + d);
    }
    return largest(sum);
}

}  // namespace lancer::tests
