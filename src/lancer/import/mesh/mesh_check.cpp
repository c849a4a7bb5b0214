#include "lancer/import/mesh/mesh_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace lancer {

namespace {

constexpr float farthest = 1e15f;  // metres: squares stay finite in single precision

bool within_reach(const glm::vec3& p) { return std::abs(p.x) <= farthest && std::abs(p.y) <= farthest && std::abs(p.z) <= farthest; }

// Twice the area times the normal; exact enough that only true needles vanish.
glm::dvec3 face_normal(const scene::TriangleMesh& mesh, const glm::uvec3& triangle) {
    const glm::dvec3 a(mesh.positions[triangle.x]);
    return glm::cross(glm::dvec3(mesh.positions[triangle.y]) - a, glm::dvec3(mesh.positions[triangle.z]) - a);
}

bool check_positions(const scene::TriangleMesh& mesh, MeshMessages& messages, int line, int column) {
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec3& p = mesh.positions[i];
        if (!within_reach(p)) {
            messages.error(line, column,
                           fmt::format("vertex {} at ({}, {}, {}) is out of reach: coordinates must be finite and at most {:g} m", i, p.x,
                                       p.y, p.z, farthest));
            return false;
        }
    }
    return true;
}

bool check_corners(const scene::TriangleMesh& mesh, MeshMessages& messages, int line, int column) {
    std::uint32_t largest = 0;
    for (const glm::uvec3& triangle : mesh.triangles) {
        largest = std::max({largest, triangle.x, triangle.y, triangle.z});
    }
    if (largest < mesh.positions.size()) {
        return true;
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const glm::uvec3& t = mesh.triangles[i];
        const std::uint32_t most = std::max({t.x, t.y, t.z});
        if (most >= mesh.positions.size()) {
            messages.error(line, column,
                           fmt::format("triangle {} names vertex {}, but there are {} vertices, counted from 0", i,
                                       static_cast<std::int32_t>(most), mesh.positions.size()));
            break;
        }
    }
    return false;
}

void leave_out_needles(scene::TriangleMesh& mesh, MeshMessages& messages, int line, int column) {
    const auto is_needle = [&](const glm::uvec3& t) {
        return t.x == t.y || t.y == t.z || t.z == t.x || face_normal(mesh, t) == glm::dvec3(0.0);
    };
    if (!mesh.face_colors.empty()) {
        std::size_t face = 0;
        std::erase_if(mesh.face_colors, [&](const glm::vec4&) { return is_needle(mesh.triangles[face++]); });
    }
    const std::size_t removed = std::erase_if(mesh.triangles, is_needle);
    if (removed > 0) {
        messages.warning(line, column,
                         fmt::format("{} of {} triangles have no area and are left out", removed, removed + mesh.triangles.size()));
    }
}

void repair_normals(scene::TriangleMesh& mesh, MeshMessages& messages, int line, int column) {
    std::vector<std::size_t> without;
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        glm::vec3& n = mesh.normals[i];
        const float square = glm::dot(n, n);
        if (square > 0.999f && square < 1.001f) {
            continue;
        }
        const glm::dvec3 wide(n);
        const double length = glm::length(wide);
        if (length > 0.0 && std::isfinite(length)) {
            n = glm::vec3(wide / length);
        } else {
            without.push_back(i);
        }
    }
    if (without.empty()) {
        return;
    }
    std::vector<glm::dvec3> around(mesh.positions.size(), glm::dvec3(0.0));
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 normal = face_normal(mesh, t);
        for (std::uint32_t corner : {t.x, t.y, t.z}) {
            around[corner] += normal;
        }
    }
    for (std::size_t i : without) {
        const double length = glm::length(around[i]);
        mesh.normals[i] = length > 0.0 ? glm::vec3(around[i] / length) : glm::vec3(0.0f, 1.0f, 0.0f);
    }
    messages.warning(
        line, column,
        fmt::format("{} of {} normals have no direction; the mean of the faces around is used", without.size(), mesh.normals.size()));
}

void repair_uvs(scene::TriangleMesh& mesh, MeshMessages& messages, int line, int column) {
    std::size_t repaired = 0;
    for (glm::vec2& uv : mesh.uvs) {
        if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) {
            uv = glm::vec2(0.0f);
            ++repaired;
        }
    }
    if (repaired > 0) {
        messages.warning(line, column, fmt::format("{} of {} texture coordinates are not finite; 0 is used", repaired, mesh.uvs.size()));
    }
}

void repair_colors(scene::TriangleMesh& mesh, MeshMessages& messages, int line, int column) {
    std::size_t repaired = 0;
    for (glm::vec4& color : mesh.colors) {
        for (int channel = 0; channel < 4; ++channel) {
            // No surface gives back more light than it gets, nor less than none.
            const float value = color[channel];
            color[channel] = value > 0.0f ? std::min(value, 1.0f) : 0.0f;
            repaired += color[channel] != value ? std::size_t{1} : std::size_t{0};
        }
    }
    if (repaired > 0) {
        messages.warning(line, column, fmt::format("{} values of colors lie outside of 0 to 1; the nearest of these is used", repaired));
    }
}

}  // namespace

bool check_mesh(scene::TriangleMesh& mesh, MeshMessages& messages, int line, int column) {
    if (messages.has_errors()) {
        return false;
    }
    if (mesh.triangles.empty()) {
        messages.error(line, column, "this mesh has no triangles");
        return false;
    }
    if (!check_corners(mesh, messages, line, column) || !check_positions(mesh, messages, line, column)) {
        return false;
    }
    leave_out_needles(mesh, messages, line, column);
    if (mesh.triangles.empty()) {
        messages.error(line, column, "this mesh has no triangle with an area");
        return false;
    }
    repair_normals(mesh, messages, line, column);
    repair_uvs(mesh, messages, line, column);
    repair_colors(mesh, messages, line, column);
    return true;
}

}  // namespace lancer
