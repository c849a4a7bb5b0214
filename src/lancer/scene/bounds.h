// How far things reach.
#pragma once

#include <limits>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "lancer/scene/scene.h"

namespace lancer::scene {

// An axis-aligned box; empty when low > high.
struct Bounds {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};

    bool empty() const { return !(low.x <= high.x && low.y <= high.y && low.z <= high.z); }
    void include(const glm::dvec3& point);
    void include(const Bounds& other);
};

// In the shape's own space. Infinite planes count with the point that they are written with: they reach everywhere and frame nothing.
Bounds bounds(const Shape& shape);

// The smallest box around the eight corners of `bounds` after the map.
Bounds transform(const glm::dmat4& to_parent, const Bounds& bounds);

// In each group's own space, in the order of Scene::groups.
std::vector<Bounds> group_bounds(const Scene& scene);

// Of everything that is seen.
Bounds bounds(const Scene& scene);

}  // namespace lancer::scene
