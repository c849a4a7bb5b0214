// The maps that directives make: all from the space that they begin to the one around it.
#pragma once

#include <array>
#include <optional>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace lancer::pbrt {

glm::dmat4 translation(const glm::dvec3& shift);
glm::dmat4 scaling(const glm::dvec3& factors);
glm::dmat4 rotation(double degrees, const glm::dvec3& axis);  // the identity about an axis of no length
glm::dmat4 from_sixteen(const std::array<double, 16>& columns);

// From the world to a camera that looks along +z, with +y up and +x to the right of the picture. In these coordinates the right hand is the left
// one. Nothing when the three points do not say where up is.
std::optional<glm::dmat4> look_at(const glm::dvec3& eye, const glm::dvec3& at, const glm::dvec3& up);

// What can be inverted and is finite.
bool is_usable(const glm::dmat4& map);

glm::dvec3 apply_to_point(const glm::dmat4& map, const glm::dvec3& point);
glm::dvec3 apply_to_direction(const glm::dmat4& map, const glm::dvec3& direction);

}  // namespace lancer::pbrt
