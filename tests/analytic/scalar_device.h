// The kernel compiled as plain C++, one ray at a time, every object asked: what all other ways of following rays must agree with.
#pragma once

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lancer/world/world.h"

namespace lancer::tests {

// The world's meshes must be small.
std::vector<glm::vec3> follow_one_by_one(const World& world, const std::vector<glm::vec2>& points);

}  // namespace lancer::tests
