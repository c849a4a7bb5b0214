#include "lancer/import/pbrt/octahedron.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lancer::pbrt {

// Each quarter of the square is a triangle of the upper half of the sphere, next to the middle, and one of the lower half. In a triangle the
// distance from the middle gives the height, and the way along its rim the angle about z.
glm::dvec3 direction_of_square(const glm::dvec2& place) {
    const double x = 2.0 * place.x - 1.0, y = 2.0 * place.y - 1.0;
    const double inside = 1.0 - std::abs(x) - std::abs(y);  // below 0: the lower half
    const double radius = 1.0 - std::abs(inside);
    const double share = radius > 0.0 ? (std::abs(y) - std::abs(x)) / radius + 1.0 : 1.0;
    const double angle = share * (std::numbers::pi / 4.0);
    const double z = std::copysign(1.0 - radius * radius, inside);
    const double ring = radius * std::sqrt(std::max(2.0 - radius * radius, 0.0));
    return {std::copysign(std::cos(angle), x) * ring, std::copysign(std::sin(angle), y) * ring, z};
}

glm::dvec2 square_of_direction(const glm::dvec3& d) {
    const double radius = std::sqrt(std::max(1.0 - std::abs(d.z), 0.0));
    const double angle = std::atan2(std::abs(d.y), std::abs(d.x)) * (2.0 / std::numbers::pi);
    double y = angle * radius;
    double x = radius - y;
    if (d.z < 0.0) {  // to the other side of the diagonal
        const double kept = x;
        x = 1.0 - y;
        y = 1.0 - kept;
    }
    return {0.5 * (std::copysign(x, d.x) + 1.0), 0.5 * (std::copysign(y, d.y) + 1.0)};
}

}  // namespace lancer::pbrt
