// From shapes as authors write them to shapes as the kernel meets them.
#pragma once

#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "analytic/kernel_shapes.h"
#include "lancer/scene/scene.h"
#include "lancer/world/world.h"

namespace lancer::tests {

// Throws std::runtime_error with the first diagnostic where the shape does not compile.
Shape compile_shape(const scene::Shape& shape, const glm::dmat4& to_world = glm::dmat4(1.0));

// All objects of a compiled world; its meshes must be small.
std::vector<Shape> shapes_of(const World& world);

}  // namespace lancer::tests
