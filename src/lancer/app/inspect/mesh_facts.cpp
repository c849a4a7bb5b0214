#include "lancer/app/inspect/mesh_facts.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <tuple>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace lancer::app {

namespace {

// For each vertex the first one at the same place. -0 is 0.
std::vector<std::uint32_t> weld(const std::vector<glm::vec3>& positions) {
    std::vector<std::uint32_t> order(positions.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        order[i] = static_cast<std::uint32_t>(i);
    }
    const auto key = [&](std::uint32_t i) { return std::tuple(positions[i].x, positions[i].y, positions[i].z); };
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    std::vector<std::uint32_t> first(positions.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        first[order[i]] = i > 0 && key(order[i]) == key(order[i - 1]) ? first[order[i - 1]] : order[i];
    }
    return first;
}

}  // namespace

MeshFacts examine(const scene::TriangleMesh& mesh) {
    const std::vector<std::uint32_t> welded = weld(mesh.positions);
    // Edges from the lower to the higher number, and whether they are run along in that direction.
    std::vector<std::tuple<std::uint32_t, std::uint32_t, bool>> edges;
    edges.reserve(mesh.triangles.size() * 3);
    MeshFacts facts;
    facts.low = facts.high = mesh.positions.empty() ? glm::vec3(0.0f) : mesh.positions.front();
    for (const glm::vec3& position : mesh.positions) {
        facts.low = glm::min(facts.low, position);
        facts.high = glm::max(facts.high, position);
    }
    for (const glm::uvec3& triangle : mesh.triangles) {
        const std::array<std::uint32_t, 3> corners = {welded[triangle.x], welded[triangle.y], welded[triangle.z]};
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t from = corners[i];
            const std::uint32_t to = corners[(i + 1) % 3];
            edges.emplace_back(std::min(from, to), std::max(from, to), from < to);
        }
        const glm::dvec3 a(mesh.positions[triangle.x]);
        facts.volume += glm::dot(a, glm::cross(glm::dvec3(mesh.positions[triangle.y]), glm::dvec3(mesh.positions[triangle.z]))) / 6.0;
    }
    std::sort(edges.begin(), edges.end());
    facts.closed = edges.size() % 2 == 0 && !edges.empty();
    for (std::size_t i = 0; facts.closed && i < edges.size();) {
        // As many one way as the other.
        std::size_t end = i;
        std::size_t forwards = 0;
        while (end < edges.size() && std::get<0>(edges[end]) == std::get<0>(edges[i]) && std::get<1>(edges[end]) == std::get<1>(edges[i])) {
            forwards += std::get<2>(edges[end]) ? 1U : 0U;
            ++end;
        }
        facts.closed = forwards * 2 == end - i;
        i = end;
    }
    return facts;
}

bool lies_inside(const scene::TriangleMesh& mesh, const glm::dvec3& point) {
    // Askew, so that it goes through no edge of anything that is built along the axes.
    const glm::dvec3 direction = glm::normalize(glm::dvec3(0.4123, 0.7211, 0.5573));
    bool inside = false;
    for (const glm::uvec3& triangle : mesh.triangles) {
        const glm::dvec3 a(mesh.positions[triangle.x]);
        const glm::dvec3 ab = glm::dvec3(mesh.positions[triangle.y]) - a;
        const glm::dvec3 ac = glm::dvec3(mesh.positions[triangle.z]) - a;
        const glm::dvec3 p = glm::cross(direction, ac);
        const double determinant = glm::dot(ab, p);
        if (determinant == 0.0) {
            continue;
        }
        const glm::dvec3 way = point - a;
        const double u = glm::dot(way, p) / determinant;
        const glm::dvec3 q = glm::cross(way, ab);
        const double v = glm::dot(direction, q) / determinant;
        if (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && glm::dot(ac, q) / determinant > 0.0) {
            inside = !inside;
        }
    }
    return inside;
}

}  // namespace lancer::app
