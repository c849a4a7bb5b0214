// From a Shape directive to a shape of the scene.
#pragma once

#include <optional>
#include <string>

#include <glm/mat4x4.hpp>

#include "lancer/import/pbrt/parameters.h"
#include "lancer/scene/shapes.h"

namespace lancer::pbrt {

struct BuiltShape {
    scene::Shape shape;
    glm::dmat4 to_object{1.0};  // from the space of `shape` to that in which pbrt describes it
};

// `reversed`: normals point the other way. Nothing when there is an error, or nothing to see; both are said.
std::optional<BuiltShape> build_shape(const Parameters& parameters, const std::string& type, bool reversed);

// Square metres after a transform, of one side.
double surface_area(const scene::Shape& shape, const glm::dmat4& to_world);

}  // namespace lancer::pbrt
