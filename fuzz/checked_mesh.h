// What every mesh that a reader returns must keep to, or the fuzzer stops.
#pragma once

#include <cmath>
#include <cstdlib>
#include <optional>

#include "lancer/base/diagnostic.h"
#include "lancer/scene/scene.h"

inline void require(bool condition) {
    if (!condition) {
        std::abort();
    }
}

inline void check_sound_mesh(const lancer::scene::TriangleMesh* mesh) {
    require(!mesh->triangles.empty());
    require(mesh->normals.empty() || mesh->normals.size() == mesh->positions.size());
    require(mesh->uvs.empty() || mesh->uvs.size() == mesh->positions.size());
    for (const glm::uvec3& triangle : mesh->triangles) {
        for (int k = 0; k < 3; ++k) {
            require(triangle[k] < mesh->positions.size());
        }
    }
    for (const glm::vec3& p : mesh->positions) {
        require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
    }
    for (const glm::vec3& n : mesh->normals) {
        const float square = n.x * n.x + n.y * n.y + n.z * n.z;
        require(square > 0.99f && square < 1.01f);
    }
    for (const glm::vec2& uv : mesh->uvs) {
        require(std::isfinite(uv.x) && std::isfinite(uv.y));
    }
}

inline void check_mesh_of_fuzzer(const std::optional<lancer::scene::TriangleMesh>& mesh, const lancer::Diagnostics& diagnostics) {
    require(mesh.has_value() != diagnostics.has_errors());
    require(diagnostics.list().size() < 100);
    if (mesh) {
        check_sound_mesh(&*mesh);
    }
}
