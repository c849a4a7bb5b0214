#include "lancer/import/gltf/geometry.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "lancer/import/gltf/attributes.h"
#include "lancer/import/mesh/mesh_check.h"
#include "lancer/import/mesh/tangents.h"

namespace lancer::gltf {

namespace {

using Triangles = std::vector<glm::uvec3>;

// Corner i of the primitive as a vertex.
class Corners {
public:
    explicit Corners(const Attributes& attributes)
        : indices_(attributes.indices), count_(indices_.empty() ? attributes.positions.size() : indices_.size()) {}

    std::size_t count() const { return count_; }
    std::uint32_t operator[](std::size_t i) const { return indices_.empty() ? static_cast<std::uint32_t>(i) : indices_[i]; }

private:
    const std::vector<std::uint32_t>& indices_;
    std::size_t count_;
};

// The winding of every other triangle of a strip is turned, as [Khronos 2021, section 3.7.2.1] has it.
Triangles triangles_of(Mode mode, const Corners& corner) {
    Triangles triangles;
    const std::size_t count = corner.count();
    if (mode == Mode::triangles) {
        triangles.reserve(count / 3);
        for (std::size_t i = 0; i + 2 < count; i += 3) {
            triangles.emplace_back(corner[i], corner[i + 1], corner[i + 2]);
        }
    } else if (count >= 3) {
        triangles.reserve(count - 2);
        for (std::size_t i = 0; i + 2 < count; ++i) {
            if (mode == Mode::triangle_strip) {
                triangles.emplace_back(corner[i], corner[i + 1 + i % 2], corner[i + 2 - i % 2]);
            } else {
                triangles.emplace_back(corner[i + 1], corner[i + 2], corner[0]);
            }
        }
    }
    return triangles;
}

void leave_out_missing_vertices(Document& document, Json primitive, Triangles& triangles, std::size_t vertices) {
    const std::size_t before = triangles.size();
    triangles.erase(std::remove_if(triangles.begin(), triangles.end(),
                                   [&](const glm::uvec3& t) { return t.x >= vertices || t.y >= vertices || t.z >= vertices; }),
                    triangles.end());
    if (triangles.size() < before) {
        document.warning(primitive["indices"], fmt::format("{} triangles name vertices that are not there, of {}, and are left out",
                                                           before - triangles.size(), vertices));
    }
}

bool has_area(const Attributes& attributes, const glm::uvec3& t) {
    const glm::dvec3 a(attributes.positions[t.x]);
    return glm::cross(glm::dvec3(attributes.positions[t.y]) - a, glm::dvec3(attributes.positions[t.z]) - a) != glm::dvec3(0.0);
}

bool is_finite(const glm::vec4& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w); }

// What only pictures depend on becomes harmless where it is no number.
void repair_looks(scene::TriangleMesh& mesh) {
    for (glm::vec2& uv : mesh.second_uvs) {
        uv = std::isfinite(uv.x) && std::isfinite(uv.y) ? uv : glm::vec2(0.0f);
    }
    for (glm::vec4& color : mesh.colors) {
        color = is_finite(color) ? glm::clamp(color, 0.0f, 1.0f) : glm::vec4(1.0f);
    }
    for (glm::vec4& tangent : mesh.tangents) {
        tangent = is_finite(tangent) ? tangent : glm::vec4(0.0f);
    }
}

// Those of the file, or made; of length 1, at right angles to the normal.
void finish_tangents(scene::TriangleMesh& mesh) {
    if (mesh.tangents.empty()) {
        add_tangents(mesh);
    }
    for (std::size_t i = 0; i < mesh.tangents.size(); ++i) {
        const glm::vec3& normal = mesh.normals[i];
        glm::vec3 tangent(mesh.tangents[i]);
        tangent -= normal * glm::dot(normal, tangent);
        float length = glm::length(tangent);
        if (!(length > 0.0f) || !std::isfinite(length)) {
            tangent = glm::cross(normal, std::abs(normal.x) < 0.9f ? glm::vec3(1.0f, 0.0f, 0.0f) : glm::vec3(0.0f, 1.0f, 0.0f));
            length = glm::length(tangent);
        }
        const float side = mesh.tangents[i].w < 0.0f ? -1.0f : 1.0f;
        mesh.tangents[i] = glm::vec4(tangent / length, side);
    }
}

}  // namespace

Mode mode_of(Json primitive) { return static_cast<Mode>(std::min<std::size_t>(primitive.natural("mode").value_or(4), 6)); }

std::shared_ptr<const scene::TriangleMesh> make_triangles(Document& document, Accessors& accessors, Json primitive, const Pose& pose,
                                                          const Wishes& wishes) {
    Attributes attributes;
    if (!read_attributes(document, accessors, primitive, pose, wishes, attributes)) {
        return nullptr;
    }
    auto mesh = std::make_shared<scene::TriangleMesh>();
    mesh->triangles = triangles_of(mode_of(primitive), Corners(attributes));
    leave_out_missing_vertices(document, primitive, mesh->triangles, attributes.positions.size());
    // Strips are sewn together by triangles without area.
    if (mode_of(primitive) == Mode::triangle_strip) {
        std::erase_if(mesh->triangles, [](const glm::uvec3& t) { return t.x == t.y || t.y == t.z || t.z == t.x; });
    }
    if (std::none_of(mesh->triangles.begin(), mesh->triangles.end(), [&](const glm::uvec3& t) { return has_area(attributes, t); })) {
        document.warning(primitive, "the primitive has no triangle with an area");
        return nullptr;
    }
    mesh->positions = std::move(attributes.positions);
    mesh->normals = std::move(attributes.normals);
    mesh->uvs = std::move(attributes.uvs[0]);
    mesh->second_uvs = std::move(attributes.uvs[1]);
    mesh->tangents = std::move(attributes.tangents);
    mesh->colors = std::move(attributes.colors);
    MeshMessages messages(document.path(), document.diagnostics());
    if (!check_mesh(*mesh, messages)) {
        return nullptr;
    }
    repair_looks(*mesh);
    if (wishes.tangents) {
        finish_tangents(*mesh);
    }
    return mesh;
}

}  // namespace lancer::gltf
