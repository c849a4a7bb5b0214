#include "lancer/import/pbrt/transforms.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

namespace lancer::pbrt {

namespace {

glm::dmat4 from_columns(const glm::dvec3& x, const glm::dvec3& y, const glm::dvec3& z, const glm::dvec3& shift) {
    return glm::dmat4(glm::dvec4(x, 0.0), glm::dvec4(y, 0.0), glm::dvec4(z, 0.0), glm::dvec4(shift, 1.0));
}

}  // namespace

glm::dmat4 translation(const glm::dvec3& shift) { return from_columns({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, shift); }

glm::dmat4 scaling(const glm::dvec3& f) { return from_columns({f.x, 0, 0}, {0, f.y, 0}, {0, 0, f.z}, {}); }

glm::dmat4 rotation(double degrees, const glm::dvec3& axis) {
    const double length = glm::length(axis);
    if (!(length > 0.0)) {
        return glm::dmat4(1.0);
    }
    const glm::dvec3 a = axis / length;
    const double angle = glm::radians(degrees);
    const double s = std::sin(angle), c = std::cos(angle);
    const auto turned = [&](const glm::dvec3& v) { return a * glm::dot(a, v) * (1.0 - c) + v * c + glm::cross(a, v) * s; };
    return from_columns(turned({1, 0, 0}), turned({0, 1, 0}), turned({0, 0, 1}), {});
}

glm::dmat4 from_sixteen(const std::array<double, 16>& columns) {
    glm::dmat4 map;
    for (int i = 0; i < 16; ++i) {
        map[i / 4][i % 4] = columns[static_cast<std::size_t>(i)];
    }
    return map;
}

std::optional<glm::dmat4> look_at(const glm::dvec3& eye, const glm::dvec3& at, const glm::dvec3& up) {
    const glm::dvec3 forward = at - eye;
    const glm::dvec3 right = glm::cross(up, forward);
    if (!(glm::length(forward) > 0.0) || !(glm::length(right) > 0.0)) {
        return std::nullopt;
    }
    const glm::dvec3 z = glm::normalize(forward);
    const glm::dvec3 x = glm::normalize(right);
    return glm::inverse(from_columns(x, glm::cross(z, x), z, eye));
}

bool is_usable(const glm::dmat4& map) {
    for (int i = 0; i < 16; ++i) {
        if (!std::isfinite(map[i / 4][i % 4])) {
            return false;
        }
    }
    const double determinant = glm::determinant(glm::dmat3(map));
    return determinant != 0.0 && std::isfinite(determinant);
}

glm::dvec3 apply_to_point(const glm::dmat4& map, const glm::dvec3& point) {
    const glm::dvec4 p = map * glm::dvec4(point, 1.0);
    return p.w == 1.0 || p.w == 0.0 ? glm::dvec3(p) : glm::dvec3(p) / p.w;
}

glm::dvec3 apply_to_direction(const glm::dmat4& map, const glm::dvec3& direction) { return glm::dvec3(map * glm::dvec4(direction, 0.0)); }

}  // namespace lancer::pbrt
