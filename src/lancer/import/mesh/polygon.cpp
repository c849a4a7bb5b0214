#include "lancer/import/mesh/polygon.h"

#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace lancer {

namespace {

constexpr std::size_t most_corners = 128;

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

// The corners along the mean normal, counter-clockwise. The normal by Newell's sum over the edges [Sutherland et al. 1974].
std::vector<glm::dvec2> flatten(std::span<const glm::vec3> corners) {
    glm::dvec3 normal(0.0);
    const glm::dvec3 origin(corners[0]);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        normal += glm::cross(glm::dvec3(corners[i]) - origin, glm::dvec3(corners[(i + 1) % corners.size()]) - origin);
    }
    const glm::dvec3 size = glm::abs(normal);
    const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    const bool flipped = normal[axis] < 0.0;
    std::vector<glm::dvec2> flat;
    flat.reserve(corners.size());
    for (const glm::vec3& corner : corners) {
        const glm::dvec3 p = glm::dvec3(corner) - origin;
        const double u = p[(axis + 1) % 3];
        const double v = p[(axis + 2) % 3];
        flat.push_back(flipped ? glm::dvec2(v, u) : glm::dvec2(u, v));
    }
    return flat;
}

// Which diagonal of a quadrilateral lies inside: the triangles on both sides of a wrong one face opposite ways.
bool first_diagonal_is_inside(std::span<const glm::vec3> p) {
    const glm::dvec3 a(p[0]);
    const glm::dvec3 diagonal = glm::dvec3(p[2]) - a;
    return glm::dot(glm::cross(glm::dvec3(p[1]) - a, diagonal), glm::cross(diagonal, glm::dvec3(p[3]) - a)) >= 0.0;
}

bool is_convex(const std::vector<glm::dvec2>& p) {
    for (std::size_t i = 0; i < p.size(); ++i) {
        const glm::dvec2& b = p[(i + 1) % p.size()];
        if (cross(b - p[i], p[(i + 2) % p.size()] - b) < 0.0) {
            return false;
        }
    }
    return true;
}

bool holds(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& p) {
    return cross(b - a, p - a) >= 0.0 && cross(c - b, p - b) >= 0.0 && cross(a - c, p - c) >= 0.0;
}

}  // namespace

void cut_polygon(std::span<const glm::vec3> corners, std::vector<std::array<std::size_t, 3>>& triangles) {
    if (corners.size() == 4) {
        const bool first = first_diagonal_is_inside(corners);
        triangles.push_back(first ? std::array<std::size_t, 3>{0, 1, 2} : std::array<std::size_t, 3>{0, 1, 3});
        triangles.push_back(first ? std::array<std::size_t, 3>{0, 2, 3} : std::array<std::size_t, 3>{1, 2, 3});
        return;
    }
    const auto fan = [&](const std::vector<std::size_t>& left) {
        for (std::size_t i = 2; i < left.size(); ++i) {
            triangles.push_back({left[0], left[i - 1], left[i]});
        }
    };
    std::vector<std::size_t> left(corners.size());
    std::iota(left.begin(), left.end(), std::size_t{0});
    if (corners.size() <= 3 || corners.size() > most_corners) {
        return fan(left);
    }
    const std::vector<glm::dvec2> flat = flatten(corners);
    if (is_convex(flat)) {
        return fan(left);
    }

    // An ear: a convex corner whose triangle holds no other corner.
    const auto is_ear = [&](std::size_t i) {
        const glm::dvec2& a = flat[left[(i + left.size() - 1) % left.size()]];
        const glm::dvec2& b = flat[left[i]];
        const glm::dvec2& c = flat[left[(i + 1) % left.size()]];
        if (cross(b - a, c - b) <= 0.0) {
            return false;
        }
        for (std::size_t other : left) {
            const glm::dvec2& p = flat[other];
            if (p != a && p != b && p != c && holds(a, b, c, p)) {
                return false;
            }
        }
        return true;
    };
    while (left.size() > 3) {
        std::size_t ear = 0;
        while (ear < left.size() && !is_ear(ear)) {
            ++ear;
        }
        if (ear == left.size()) {
            break;  // it crosses itself; a fan of the rest is as good as anything
        }
        triangles.push_back({left[(ear + left.size() - 1) % left.size()], left[ear], left[(ear + 1) % left.size()]});
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    fan(left);
}

}  // namespace lancer
