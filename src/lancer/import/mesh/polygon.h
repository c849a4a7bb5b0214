// Cutting polygons into triangles.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace lancer {

// Appends triangles, as numbers of corners, that cover a polygon in space. A convex polygon becomes a fan from its first corner; others lose one
// ear after the other, seen along the polygon's mean normal [Meisters 1975]. Polygons of more than 128 corners always become a fan, so that
// the time stays bounded.
void cut_polygon(std::span<const glm::vec3> corners, std::vector<std::array<std::size_t, 3>>& triangles);

}  // namespace lancer
