#include "lancer/import/mitsuba/meshes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "lancer/import/mitsuba/curves.h"
#include "lancer/import/mitsuba/ply_attribute.h"
#include "lancer/import/mitsuba/serialized.h"

namespace lancer::mitsuba {

namespace {

using scene::TriangleMesh;

// The mean of the faces around each vertex, weighed by their angles there [Thürmer and Wüthrich 1998].
void find_normals(TriangleMesh& mesh) {
    std::vector<glm::dvec3> sums(mesh.positions.size(), glm::dvec3(0.0));
    for (const glm::uvec3& triangle : mesh.triangles) {
        const std::array<glm::dvec3, 3> corner = {glm::dvec3(mesh.positions[triangle.x]), glm::dvec3(mesh.positions[triangle.y]),
                                                  glm::dvec3(mesh.positions[triangle.z])};
        const glm::dvec3 across = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
        if (!(glm::length(across) > 0.0)) {
            continue;
        }
        const glm::dvec3 normal = glm::normalize(across);
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec3 a = corner[(i + 1) % 3] - corner[i], b = corner[(i + 2) % 3] - corner[i];
            const double cosine = glm::dot(a, b) / (glm::length(a) * glm::length(b));
            sums[triangle[static_cast<int>(i)]] += normal * std::acos(std::clamp(cosine, -1.0, 1.0));
        }
    }
    mesh.normals.resize(sums.size());
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const double length = glm::length(sums[i]);
        mesh.normals[i] = length > 0.0 ? glm::vec3(sums[i] / length) : glm::vec3(1.0f, 0.0f, 0.0f);
    }
}

std::shared_ptr<const TriangleMesh> triangles_of(Builder& builder, Plugin& plugin, const std::string& path, int number) {
    if (plugin.type() != "serialized") {
        return builder.context.files.mesh(path, plugin.position());
    }
    const auto bytes = builder.context.files.open(path, plugin.position());
    auto mesh = bytes ? read_serialized(bytes->view(), number, path, builder.context.diagnostics) : std::nullopt;
    return mesh ? std::make_shared<const TriangleMesh>(std::move(*mesh)) : nullptr;
}

void add_attribute(Builder& builder, const Plugin& plugin, const std::string& path, const std::string& attribute, TriangleMesh& mesh) {
    const bool of_faces = attribute.rfind("face_", 0) == 0;
    const auto bytes = builder.context.files.open(path, plugin.position());
    auto colors = bytes ? read_ply_attribute(bytes->view(), attribute) : std::vector<glm::vec4>();
    if (colors.size() != (of_faces ? mesh.triangles.size() : mesh.positions.size())) {
        builder.context.report.dropped(fmt::format("{}: attribute \"{}\"", plugin.title(), attribute),
                                       colors.empty() ? "it is not in the file" : "it does not belong to triangles", plugin.position());
        return;
    }
    (of_faces ? mesh.face_colors : mesh.colors) = std::move(colors);
}

}  // namespace

std::shared_ptr<const TriangleMesh> curves_from_file(Builder& builder, Plugin& plugin) {
    const std::string path = builder.document.resolve(plugin.text("filename", ""), plugin.position());
    const auto bytes = builder.context.files.open(path, plugin.position());
    auto mesh = bytes ? read_curves(bytes->view(), plugin.type() == "bsplinecurve", path, builder.context.diagnostics) : std::nullopt;
    return mesh ? std::make_shared<const TriangleMesh>(std::move(*mesh)) : nullptr;
}

TriangleMesh turned(TriangleMesh mesh) {
    for (glm::vec3& normal : mesh.normals) {
        normal = -normal;
    }
    for (glm::uvec3& triangle : mesh.triangles) {
        std::swap(triangle.y, triangle.z);
    }
    return mesh;
}

std::shared_ptr<const TriangleMesh> mesh_from_file(Builder& builder, Plugin& plugin, const std::string& attribute) {
    const std::string path = builder.document.resolve(plugin.text("filename", ""), plugin.position());
    const bool flips_uv = plugin.flag("flip_tex_coords", plugin.type() == "obj");
    const bool flips_normals = plugin.flag("flip_normals", false);
    const bool faceted = plugin.flag("face_normals", false);
    const int number = plugin.type() == "serialized" ? plugin.integer("shape_index", 0) : 0;
    const std::string key = fmt::format("{} {} {} {} {} {}", path, number, flips_uv, flips_normals, faceted, attribute);
    const auto [found, is_new] = builder.meshes.try_emplace(key);
    if (!is_new) {
        return found->second;
    }
    const auto read = triangles_of(builder, plugin, path, number);
    if (!read) {
        return nullptr;
    }
    TriangleMesh mesh = *read;
    if (!attribute.empty()) {
        add_attribute(builder, plugin, path, attribute, mesh);
    }
    if (faceted) {
        mesh.normals.clear();
    } else if (mesh.normals.empty()) {
        find_normals(mesh);
    }
    if (flips_uv) {
        for (glm::vec2& uv : mesh.uvs) {
            uv.y = 1.0f - uv.y;
        }
    }
    found->second = std::make_shared<const TriangleMesh>(flips_normals ? turned(std::move(mesh)) : std::move(mesh));
    return found->second;
}

std::shared_ptr<const TriangleMesh> rectangle_mesh() {
    TriangleMesh mesh;
    for (const glm::vec2 corner : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)}) {
        mesh.positions.emplace_back(2.0f * corner.x - 1.0f, 2.0f * corner.y - 1.0f, 0.0f);
        mesh.normals.emplace_back(0.0f, 0.0f, 1.0f);
        mesh.uvs.push_back(corner);
    }
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return std::make_shared<const TriangleMesh>(std::move(mesh));
}

std::shared_ptr<const TriangleMesh> cube_mesh() {
    TriangleMesh mesh;
    for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {-1.0f, 1.0f}) {
            glm::vec3 normal(0.0f), u(0.0f);
            normal[axis] = side;
            u[(axis + 1) % 3] = side;
            const glm::vec3 v = glm::cross(normal, u);
            const auto first = static_cast<std::uint32_t>(mesh.positions.size());
            for (const glm::vec2 corner : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)}) {
                mesh.positions.push_back(normal + u * (2.0f * corner.x - 1.0f) + v * (2.0f * corner.y - 1.0f));
                mesh.normals.push_back(normal);
                mesh.uvs.push_back(corner);
            }
            mesh.triangles.emplace_back(first, first + 1, first + 2);
            mesh.triangles.emplace_back(first, first + 2, first + 3);
        }
    }
    return std::make_shared<const TriangleMesh>(std::move(mesh));
}

}  // namespace lancer::mitsuba
