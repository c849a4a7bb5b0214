#include "lancer/import/pbrt/meshes.h"

#include <algorithm>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "lancer/import/mesh/mesh_check.h"
#include "lancer/import/pbrt/files.h"
#include "lancer/import/pbrt/mesh_parameters.h"
#include "lancer/import/pbrt/subdivision.h"

namespace lancer::pbrt {

namespace {

constexpr std::size_t most_subdivided = 4'000'000;  // triangles

bool looks_away(const scene::TriangleMesh& mesh, const glm::uvec3& t) {
    const glm::vec3& a = mesh.positions[t.x];
    const glm::dvec3 face = glm::cross(glm::dvec3(mesh.positions[t.y] - a), glm::dvec3(mesh.positions[t.z] - a));
    return glm::dot(face, glm::dvec3(mesh.normals[t.x] + mesh.normals[t.y] + mesh.normals[t.z])) < 0.0;
}

// The normals say where the outside is, whatever the order of the corners.
void follow_normals(scene::TriangleMesh& mesh) {
    if (mesh.normals.empty()) {
        return;
    }
    for (glm::uvec3& t : mesh.triangles) {
        if (looks_away(mesh, t)) {
            std::swap(t.y, t.z);
        }
    }
}

void turn_inside_out(scene::TriangleMesh& mesh) {
    for (glm::uvec3& t : mesh.triangles) {
        std::swap(t.y, t.z);
    }
    for (glm::vec3& n : mesh.normals) {
        n = -n;
    }
}

}  // namespace

SharedMesh finished_mesh(scene::TriangleMesh mesh, const Parameters& parameters, bool reversed) {
    ImportContext& context = parameters.context();
    const SourcePosition& position = parameters.position();
    Diagnostics problems;
    MeshMessages messages(position.file, problems);
    const bool good = !mesh.triangles.empty() && check_mesh(mesh, messages, position.line, position.column);
    if (mesh.triangles.empty()) {
        context.diagnostics.warning(position, parameters.owner() + " has no triangle with an area: it is left out");
        return nullptr;
    }
    context.diagnostics.append(std::move(problems));
    if (!good) {
        return nullptr;
    }
    follow_normals(mesh);
    if (reversed) {
        turn_inside_out(mesh);
    }
    return std::make_shared<const scene::TriangleMesh>(std::move(mesh));
}

SharedMesh read_triangle_mesh(const Parameters& parameters, bool reversed) {
    scene::TriangleMesh mesh;
    std::vector<std::uint32_t> corners;
    if (!read_vertices(parameters, mesh) || !read_corners(parameters, mesh.positions.size(), 3, corners)) {
        return nullptr;
    }
    mesh.triangles.reserve(corners.size() / 3);
    for (std::size_t i = 0; i < corners.size(); i += 3) {
        mesh.triangles.emplace_back(corners[i], corners[i + 1], corners[i + 2]);
    }
    return finished_mesh(std::move(mesh), parameters, reversed);
}

SharedMesh read_subdivision(const Parameters& parameters, bool reversed) {
    scene::TriangleMesh cage;
    std::vector<std::uint32_t> corners;
    cage.positions = parameters.triples("P");
    if (cage.positions.empty() || !read_corners(parameters, cage.positions.size(), 3, corners)) {
        return nullptr;
    }
    for (std::size_t i = 0; i < corners.size(); i += 3) {
        if (corners[i] != corners[i + 1] && corners[i + 1] != corners[i + 2] && corners[i + 2] != corners[i]) {
            cage.triangles.emplace_back(corners[i], corners[i + 1], corners[i + 2]);
        }
    }
    const int wanted = std::max(parameters.integer(parameters.has("levels") ? "levels" : "nlevels", 3), 0);
    int levels = 0;
    for (std::size_t count = 4 * cage.triangles.size(); levels < wanted && count < most_subdivided; count *= 4) {
        ++levels;
    }
    if (levels < wanted) {
        parameters.context().report.approximated(parameters.owner() + fmt::format(", {} levels", wanted), fmt::format("{} levels", levels),
                                                 parameters.position());
    }
    parameters.pass_over({"scheme"});
    return finished_mesh(loop_subdivision(std::move(cage), levels), parameters, reversed);
}

SharedMesh read_ply_mesh(const Parameters& parameters, bool reversed) {
    ImportContext& context = parameters.context();
    const Parameter* parameter = parameters.find("filename");
    const auto name = parameters.string("filename");
    if (!name) {
        context.diagnostics.error(parameters.position(), parameters.owner() + " needs \"string filename\"");
        return nullptr;
    }
    const SourcePosition position = Parameters::position_of(*parameter);
    const SharedMesh mesh = context.files.mesh(find_file(context, *name, *parameter->text), position);
    const auto away = [&](const glm::uvec3& t) { return looks_away(*mesh, t); };
    if (!mesh || (!reversed && (mesh->normals.empty() || std::none_of(mesh->triangles.begin(), mesh->triangles.end(), away)))) {
        return mesh;
    }
    return finished_mesh(*mesh, parameters, reversed);
}

}  // namespace lancer::pbrt
