// In which bodies a point is.
#pragma once

#include <array>

#include <glm/vec3.hpp>

#include "lancer/world/world.h"

namespace lancer {

// The materials of the clear or null bodies around a point in world space, as kernel::Media holds them: the one that fills the place first, -1 where
// there are no more. Larger bodies count as entered earlier. Borders must be closed.
std::array<int, 4> bodies_around(const World& world, const glm::dvec3& point);

}  // namespace lancer
