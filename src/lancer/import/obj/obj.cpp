#include "lancer/import/obj/obj.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <unordered_map>

#include <glm/geometric.hpp>

#include "lancer/import/mesh/mesh_check.h"
#include "lancer/import/mesh/polygon.h"
#include "lancer/import/obj/obj_parse.h"

namespace lancer {

namespace {

using obj::absent;
using obj::Corner;
using obj::Statements;

struct CornerHash {
    std::size_t operator()(const std::array<std::int32_t, 3>& key) const {
        std::uint64_t h = 0;
        for (std::int32_t number : key) {
            h = (h ^ static_cast<std::uint32_t>(number)) * 0x9e3779b97f4a7c15u;
            h ^= h >> 29;
        }
        return static_cast<std::size_t>(h);
    }
};

// An OBJ corner has three numbers, a vertex of ours has one: equal corners become one vertex.
class Welder {
public:
    Welder(const Statements& statements, scene::TriangleMesh& mesh) : statements_(statements), mesh_(mesh) {
        for (const Corner& corner : statements.corners) {
            has_uvs_ = has_uvs_ || corner.uv != absent;
            has_normals_ = has_normals_ || corner.normal != absent;
        }
        if (plain()) {
            mesh_.positions = statements.positions;
        }
    }

    bool plain() const { return !has_uvs_ && !has_normals_; }

    // A corner without a normal, in a mesh that has some, gets `face`'s number for one: it has the normal of its face to itself.
    std::uint32_t vertex(const Corner& corner, std::size_t face, const glm::vec3& face_normal) {
        if (plain()) {
            return static_cast<std::uint32_t>(corner.position);
        }
        const bool own = has_normals_ && corner.normal == absent;
        const std::int32_t normal = own ? -2 - static_cast<std::int32_t>(face) : corner.normal;
        const auto [found, is_new] = vertices_.try_emplace({corner.position, corner.uv, normal}, static_cast<std::uint32_t>(mesh_.positions.size()));
        if (is_new) {
            mesh_.positions.push_back(statements_.positions[static_cast<std::size_t>(corner.position)]);
            if (has_uvs_) {
                mesh_.uvs.push_back(corner.uv == absent ? glm::vec2(0.0f) : statements_.uvs[static_cast<std::size_t>(corner.uv)]);
            }
            if (has_normals_) {
                mesh_.normals.push_back(own ? face_normal : statements_.normals[static_cast<std::size_t>(corner.normal)]);
            }
        }
        return found->second;
    }

private:
    const Statements& statements_;
    scene::TriangleMesh& mesh_;
    bool has_uvs_ = false;
    bool has_normals_ = false;
    std::unordered_map<std::array<std::int32_t, 3>, std::uint32_t, CornerHash> vertices_;
};

scene::TriangleMesh build(const Statements& statements) {
    scene::TriangleMesh mesh;
    Welder welder(statements, mesh);
    std::vector<glm::vec3> points;
    std::vector<std::array<std::size_t, 3>> cut;
    std::size_t begin = 0;
    for (std::size_t face = 0; face < statements.face_ends.size(); ++face) {
        const std::size_t end = statements.face_ends[face];
        points.clear();
        glm::dvec3 normal(0.0);
        for (std::size_t i = begin; i < end; ++i) {
            points.push_back(statements.positions[static_cast<std::size_t>(statements.corners[i].position)]);
            if (i >= begin + 2) {
                const glm::dvec3 origin(points[0]);
                normal += glm::cross(glm::dvec3(points[i - begin - 1]) - origin, glm::dvec3(points[i - begin]) - origin);
            }
        }
        cut.clear();
        cut_polygon(points, cut);
        const double length = glm::length(normal);
        const glm::vec3 face_normal(length > 0.0 ? normal / length : glm::dvec3(0.0));
        for (const auto& triangle : cut) {
            glm::uvec3 corners;
            for (int k = 0; k < 3; ++k) {
                corners[k] = welder.vertex(statements.corners[begin + triangle[static_cast<std::size_t>(k)]], face, face_normal);
            }
            mesh.triangles.push_back(corners);
        }
        begin = end;
    }
    return mesh;
}

}  // namespace

std::optional<scene::TriangleMesh> read_obj(std::string_view bytes, const std::string& file, Diagnostics& diagnostics) {
    MeshMessages messages(file, diagnostics);
    const Statements statements = obj::parse(bytes, messages);
    if (messages.has_errors()) {
        return std::nullopt;
    }
    scene::TriangleMesh mesh = build(statements);
    if (!check_mesh(mesh, messages)) {
        return std::nullopt;
    }
    return mesh;
}

}  // namespace lancer
