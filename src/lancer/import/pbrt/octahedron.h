// The sphere laid out on a square so that equal parts of one are equal parts of the other.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace lancer::pbrt {

// A direction of length 1 for a point of the unit square, and back: +z lies in the middle, -z in all four corners [Clarberg 2008].
glm::dvec3 direction_of_square(const glm::dvec2& place);
glm::dvec2 square_of_direction(const glm::dvec3& direction);

}  // namespace lancer::pbrt
