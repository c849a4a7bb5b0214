#include "lancer/import/obj/obj.h"

#include <algorithm>
#include <array>
#include <bit>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "lancer/image/image.h"
#include "lancer/import/mesh/mesh_check.h"
#include "lancer/import/mesh/polygon.h"
#include "lancer/import/obj/obj_build.h"

namespace lancer {

namespace obj {

namespace {

// An OBJ corner has three numbers, a vertex of ours has one: equal corners become one vertex.
class Welder {
public:
    // For a mesh of all faces, or of some that have `corners` corners.
    Welder(const Statements& statements, const std::vector<FaceRange>& faces, scene::TriangleMesh& mesh)
        : statements_(statements), mesh_(mesh) {
        std::size_t corners = 0;
        for (const FaceRange& range : faces) {
            const std::size_t last = statements.face_ends[range.end - 1];
            for (std::size_t i = range.begin == 0 ? 0 : statements.face_ends[range.begin - 1]; i < last; ++i) {
                has_uvs_ = has_uvs_ || statements.corners[i].uv != absent;
                has_normals_ = has_normals_ || statements.corners[i].normal != absent;
                ++corners;
            }
        }
        has_all_ = corners == statements.corners.size();
        if (plain()) {
            mesh_.positions = statements.positions;
            for (const glm::vec3& color : statements.colors) {
                mesh_.colors.push_back(decoded(color));
            }
        } else {
            slots_.assign(std::bit_ceil(2 * std::min(statements.positions.size(), corners) + 16), empty);
        }
    }

    bool plain() const { return has_all_ && !has_uvs_ && !has_normals_; }

    // A corner without a normal, in a mesh that has some, gets `face`'s number for one: it has the normal of its face to itself.
    std::uint32_t vertex(Corner corner, std::size_t face, const glm::vec3& face_normal) {
        if (plain()) {
            return static_cast<std::uint32_t>(corner.position);
        }
        const bool own = has_normals_ && corner.normal == absent;
        if (own) {
            corner.normal = -2 - static_cast<std::int32_t>(face);
        }
        std::uint32_t& slot = find_slot(corner);
        if (slot != empty) {
            return slot;
        }
        const std::uint32_t number = static_cast<std::uint32_t>(corners_.size());
        slot = number;
        corners_.push_back(corner);
        mesh_.positions.push_back(statements_.positions[static_cast<std::size_t>(corner.position)]);
        if (!statements_.colors.empty()) {
            mesh_.colors.push_back(decoded(statements_.colors[static_cast<std::size_t>(corner.position)]));
        }
        if (has_uvs_) {
            mesh_.uvs.push_back(corner.uv == absent ? glm::vec2(0.0f) : statements_.uvs[static_cast<std::size_t>(corner.uv)]);
        }
        if (has_normals_) {
            mesh_.normals.push_back(own ? face_normal : statements_.normals[static_cast<std::size_t>(corner.normal)]);
        }
        if (2 * corners_.size() > slots_.size()) {
            grow();
        }
        return number;
    }

private:
    // Programs write what displays take, over 255.
    static glm::vec4 decoded(const glm::vec3& color) { return {srgb_decode(color.x), srgb_decode(color.y), srgb_decode(color.z), 1.0f}; }

    static constexpr std::uint32_t empty = 0xffffffffu;

    static std::size_t scatter(const Corner& corner) {
        std::uint64_t h = 0;
        for (std::int32_t number : {corner.position, corner.uv, corner.normal}) {
            h = (h ^ static_cast<std::uint32_t>(number)) * 0x9e3779b97f4a7c15u;
            h ^= h >> 29;
        }
        return static_cast<std::size_t>(h);
    }

    // Open addressing: the slot of the vertex with this corner, or the empty one where it belongs.
    std::uint32_t& find_slot(const Corner& corner) {
        const std::size_t mask = slots_.size() - 1;
        std::size_t at = scatter(corner) & mask;
        while (slots_[at] != empty && corners_[slots_[at]] != corner) {
            at = (at + 1) & mask;
        }
        return slots_[at];
    }

    void grow() {
        slots_.assign(2 * slots_.size(), empty);
        for (std::size_t i = 0; i < corners_.size(); ++i) {
            find_slot(corners_[i]) = static_cast<std::uint32_t>(i);
        }
    }

    const Statements& statements_;
    scene::TriangleMesh& mesh_;
    bool has_uvs_ = false;
    bool has_normals_ = false;
    bool has_all_ = false;
    std::vector<Corner> corners_;       // of each vertex
    std::vector<std::uint32_t> slots_;  // numbers of vertices; the count is a power of two, at least twice the vertices
};

}  // namespace

scene::TriangleMesh build(const Statements& statements, const std::vector<FaceRange>& faces) {
    scene::TriangleMesh mesh;
    if (faces.empty()) {
        return mesh;
    }
    Welder welder(statements, faces, mesh);
    std::vector<glm::vec3> points;
    std::vector<std::array<std::size_t, 3>> cut;
    const auto add = [&](std::size_t face) {
        const std::size_t begin = face == 0 ? 0 : statements.face_ends[face - 1];
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
    };
    for (const FaceRange& range : faces) {
        for (std::size_t face = range.begin; face < range.end; ++face) {
            add(face);
        }
    }
    return mesh;
}

std::vector<FaceRange> all_faces(const Statements& statements) {
    return statements.face_ends.empty() ? std::vector<FaceRange>() : std::vector<FaceRange>{{0, statements.face_ends.size()}};
}

}  // namespace obj

std::optional<scene::TriangleMesh> read_obj(std::string_view bytes, const std::string& file, Diagnostics& diagnostics) {
    MeshMessages messages(file, diagnostics);
    const obj::Statements statements = obj::parse(bytes, messages);
    if (messages.has_errors()) {
        return std::nullopt;
    }
    if (statements.lines_and_points > 0) {
        messages.note(fmt::format("{} statements for lines and points are left out", statements.lines_and_points));
    }
    if (!statements.materials.empty()) {
        messages.note("materials (usemtl) are left out; the mesh has the material that the scene gives it");
    }
    scene::TriangleMesh mesh = obj::build(statements, obj::all_faces(statements));
    if (!check_mesh(mesh, messages)) {
        return std::nullopt;
    }
    return mesh;
}

}  // namespace lancer
