// Patches between four corners each, straight along u and along v.
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "lancer/import/pbrt/mesh_parameters.h"
#include "lancer/import/pbrt/meshes.h"

namespace lancer::pbrt {

namespace {

constexpr int steps = 8;  // along each side of a patch that is not flat
constexpr std::size_t most_curved = 200'000;

struct Patch {
    std::array<std::uint32_t, 4> corners;  // at (0, 0), (1, 0), (0, 1), (1, 1)
};

template <class Vector>
auto between(const std::vector<Vector>& list, const Patch& patch, double u, double v) {
    using Wide = glm::vec<Vector::length(), double>;
    return (Wide(list[patch.corners[0]]) * (1.0 - u) + Wide(list[patch.corners[1]]) * u) * (1.0 - v) +
           (Wide(list[patch.corners[2]]) * (1.0 - u) + Wide(list[patch.corners[3]]) * u) * v;
}

// How far the fourth corner is off the plane of the others, in terms of the patch's size.
bool is_flat(const scene::TriangleMesh& mesh, const Patch& patch) {
    const auto p = [&](std::size_t i) { return glm::dvec3(mesh.positions[patch.corners[i]]); };
    const glm::dvec3 normal = glm::cross(p(1) - p(0), p(2) - p(0));
    const double off = std::abs(glm::dot(normal, p(3) - p(0)));
    return off <= 1e-5 * glm::length(normal) * (glm::length(p(1) - p(0)) + glm::length(p(2) - p(0)));
}

scene::TriangleMesh flat_mesh(scene::TriangleMesh mesh, const std::vector<Patch>& patches) {
    for (const Patch& patch : patches) {
        const auto& c = patch.corners;
        mesh.triangles.emplace_back(c[0], c[1], c[3]);
        mesh.triangles.emplace_back(c[0], c[3], c[2]);
    }
    return mesh;
}

scene::TriangleMesh curved_mesh(const scene::TriangleMesh& mesh, const std::vector<Patch>& patches) {
    scene::TriangleMesh fine;
    for (const Patch& patch : patches) {
        const auto first = static_cast<std::uint32_t>(fine.positions.size());
        const auto p = [&](std::size_t i) { return glm::dvec3(mesh.positions[patch.corners[i]]); };
        for (int j = 0; j <= steps; ++j) {
            for (int i = 0; i <= steps; ++i) {
                const double u = static_cast<double>(i) / steps, v = static_cast<double>(j) / steps;
                const glm::dvec3 along_u = (p(1) - p(0)) * (1.0 - v) + (p(3) - p(2)) * v;
                const glm::dvec3 along_v = (p(2) - p(0)) * (1.0 - u) + (p(3) - p(1)) * u;
                fine.positions.emplace_back(between(mesh.positions, patch, u, v));
                fine.normals.emplace_back(mesh.normals.empty() ? glm::cross(along_u, along_v) : between(mesh.normals, patch, u, v));
                fine.uvs.emplace_back(mesh.uvs.empty() ? glm::dvec2(u, v) : between(mesh.uvs, patch, u, v));
            }
        }
        for (std::uint32_t j = 0; j < steps; ++j) {
            for (std::uint32_t i = 0; i < steps; ++i) {
                const std::uint32_t a = first + j * (steps + 1) + i, b = a + steps + 1;
                fine.triangles.emplace_back(a, a + 1, b + 1);
                fine.triangles.emplace_back(a, b + 1, b);
            }
        }
    }
    for (glm::vec3& n : fine.normals) {
        const glm::dvec3 wide(n);
        n = glm::length(wide) > 0.0 ? glm::vec3(glm::normalize(wide)) : n;
    }
    return fine;
}

}  // namespace

SharedMesh read_bilinear_mesh(const Parameters& parameters, bool reversed) {
    scene::TriangleMesh mesh;
    std::vector<std::uint32_t> corners;
    if (!read_vertices(parameters, mesh) || !read_corners(parameters, mesh.positions.size(), 4, corners)) {
        return nullptr;
    }
    std::vector<Patch> patches;
    bool flat = true;
    for (std::size_t i = 0; i < corners.size(); i += 4) {
        patches.push_back({{corners[i], corners[i + 1], corners[i + 2], corners[i + 3]}});
        flat = flat && is_flat(mesh, patches.back());
    }
    if (parameters.has("emissionfilename")) {
        parameters.context().report.dropped("\"emissionfilename\"", "the same light everywhere", parameters.position());
    }
    if (mesh.uvs.empty() && patches.size() == 1) {
        mesh.uvs.resize(mesh.positions.size());
        const std::array<glm::vec2, 4> usual = {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(0, 1), glm::vec2(1, 1)};
        for (std::size_t i = 0; i < 4; ++i) {
            mesh.uvs[patches[0].corners[i]] = usual[i];
        }
    }
    if (flat || patches.size() > most_curved) {
        return finished_mesh(flat_mesh(std::move(mesh), patches), parameters, reversed);
    }
    parameters.context().report.approximated(parameters.owner() + ", not flat", "triangles", parameters.position());
    return finished_mesh(curved_mesh(mesh, patches), parameters, reversed);
}

}  // namespace lancer::pbrt
