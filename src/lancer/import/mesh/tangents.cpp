#include "lancer/import/mesh/tangents.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numeric>

#include <glm/geometric.hpp>

namespace lancer {

namespace {

constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);

// Sets of corners that share a tangent.
class Sets {
public:
    explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }

    std::uint32_t find(std::uint32_t i) {
        while (parent_[i] != i) {
            parent_[i] = parent_[parent_[i]];
            i = parent_[i];
        }
        return i;
    }
    void join(std::uint32_t a, std::uint32_t b) {
        a = find(a);
        b = find(b);
        parent_[std::max(a, b)] = std::min(a, b);  // the first corner stands for its set
    }

private:
    std::vector<std::uint32_t> parent_;
};

// How u grows over a triangle, and whether the picture lies on it as it is or mirrored; neither where it has no extent in the picture.
struct Face {
    glm::dvec3 along_u{0.0};
    int side = 0;
};

class Tangents {
public:
    explicit Tangents(scene::TriangleMesh& mesh) : mesh_(mesh), sets_(3 * mesh.triangles.size()) {}

    void add() {
        weld();
        for (const glm::uvec3& triangle : mesh_.triangles) {
            faces_.push_back(face(triangle));
        }
        join_across_edges();
        sum();
        adopt();
        split();
    }

private:
    std::uint32_t vertex(std::size_t corner) const { return mesh_.triangles[corner / 3][static_cast<int>(corner % 3)]; }
    std::uint32_t welded(std::size_t corner) const { return same_[vertex(corner)]; }

    // Vertices with the same position, normal and uv count as one, however the file has numbered them.
    void weld() {
        const std::size_t count = mesh_.positions.size();
        const auto key = [&](std::uint32_t i) {
            const glm::vec3 &p = mesh_.positions[i], &n = mesh_.normals[i];
            const glm::vec2& t = mesh_.uvs[i];
            return std::array<float, 8>{p.x, p.y, p.z, n.x, n.y, n.z, t.x, t.y};
        };
        std::vector<std::uint32_t> order(count);
        std::iota(order.begin(), order.end(), 0u);
        std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
            const auto first = key(a), second = key(b);
            return first != second ? first < second : a < b;
        });
        same_.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            same_[order[i]] = i > 0 && key(order[i]) == key(order[i - 1]) ? same_[order[i - 1]] : order[i];
        }
    }

    Face face(const glm::uvec3& t) const {
        const glm::dvec3 p(mesh_.positions[t.x]);
        const glm::dvec3 edge1 = glm::dvec3(mesh_.positions[t.y]) - p, edge2 = glm::dvec3(mesh_.positions[t.z]) - p;
        const glm::dvec2 uv(mesh_.uvs[t.x]);
        const glm::dvec2 uv1 = glm::dvec2(mesh_.uvs[t.y]) - uv, uv2 = glm::dvec2(mesh_.uvs[t.z]) - uv;
        const double area = uv1.x * uv2.y - uv1.y * uv2.x;
        Face face;
        if (area != 0.0) {
            face.side = area > 0.0 ? 1 : -1;
            face.along_u = (edge1 * uv2.y - edge2 * uv1.y) * static_cast<double>(face.side);
            const double length = glm::length(face.along_u);
            face.along_u = length > 0.0 ? face.along_u / length : glm::dvec3(0.0);
            face.side = length > 0.0 ? face.side : 0;
        }
        return face;
    }

    // Two triangles at an edge belong together when the picture lies on both the same way round. Of more than two, pairs do.
    void join_across_edges() {
        struct Edge {
            std::uint32_t low, high;
            std::uint32_t corner;  // where it begins
        };
        std::vector<Edge> edges;
        edges.reserve(3 * mesh_.triangles.size());
        for (std::uint32_t c = 0; c < 3 * mesh_.triangles.size(); ++c) {
            const std::uint32_t a = welded(c), b = welded(next(c));
            if (a != b && faces_[c / 3].side != 0) {
                edges.push_back({std::min(a, b), std::max(a, b), c});
            }
        }
        std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
            return a.low != b.low ? a.low < b.low : a.high != b.high ? a.high < b.high : a.corner < b.corner;
        });
        for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
            const Edge &first = edges[i], &second = edges[i + 1];
            // Neighbours run along their edge in opposite directions.
            if (first.low != second.low || first.high != second.high || welded(first.corner) == welded(second.corner)) {
                continue;
            }
            if (faces_[first.corner / 3].side == faces_[second.corner / 3].side) {
                sets_.join(first.corner, next(second.corner));
                sets_.join(next(first.corner), second.corner);
            }
            ++i;
        }
    }

    static std::uint32_t next(std::uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }

    static glm::dvec3 flatten(const glm::dvec3& v, const glm::dvec3& normal) {
        const glm::dvec3 flat = v - normal * glm::dot(normal, v);
        const double length = glm::length(flat);
        return length > 0.0 ? flat / length : glm::dvec3(0.0);
    }

    // The mean of what the triangles around say, in the plane of the vertex, weighed by their angles.
    void sum() {
        sums_.assign(3 * mesh_.triangles.size(), glm::dvec3(0.0));
        for (std::uint32_t c = 0; c < sums_.size(); ++c) {
            if (faces_[c / 3].side == 0) {
                continue;
            }
            const glm::dvec3 normal(mesh_.normals[vertex(c)]);
            const glm::dvec3 p(mesh_.positions[vertex(c)]);
            const glm::dvec3 forth = flatten(glm::dvec3(mesh_.positions[vertex(next(c))]) - p, normal);
            const glm::dvec3 back = flatten(glm::dvec3(mesh_.positions[vertex(next(next(c)))]) - p, normal);
            const double angle = std::acos(std::clamp(glm::dot(forth, back), -1.0, 1.0));
            sums_[sets_.find(c)] += angle * flatten(faces_[c / 3].along_u, normal);
        }
    }

    // Triangles without extent in the picture take the tangent of another one at the same vertex.
    void adopt() {
        std::vector<std::uint32_t> hosts(mesh_.positions.size(), none);
        for (std::uint32_t c = 0; c < sums_.size(); ++c) {
            if (faces_[c / 3].side != 0 && hosts[welded(c)] == none) {
                hosts[welded(c)] = c;
            }
        }
        for (std::uint32_t c = 0; c < sums_.size(); ++c) {
            if (faces_[c / 3].side == 0 && hosts[welded(c)] != none) {
                sets_.join(c, hosts[welded(c)]);
            }
        }
    }

    glm::vec4 tangent_of(std::uint32_t corner) {
        const std::uint32_t set = sets_.find(corner);
        // The set's first corner may be an adopted one, which has neither sum nor side.
        std::uint32_t speaker = speakers_[set];
        const glm::dvec3 normal(mesh_.normals[vertex(corner)]);
        glm::dvec3 direction = speaker == none ? glm::dvec3(0.0) : flatten(sums_of_sets_[set], normal);
        if (direction == glm::dvec3(0.0)) {
            const glm::dvec3 axis = std::abs(normal.x) < 0.9 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
            direction = flatten(axis, normal);
        }
        const int side = speaker == none ? 1 : faces_[speaker / 3].side;
        return {glm::vec3(direction), static_cast<float>(side)};
    }

    // One vertex for each pair of a vertex of the file and a set.
    void split() {
        const std::size_t corners = sums_.size();
        speakers_.assign(corners, none);
        sums_of_sets_.assign(corners, glm::dvec3(0.0));
        for (std::uint32_t c = 0; c < corners; ++c) {
            const std::uint32_t set = sets_.find(c);
            sums_of_sets_[set] += sums_[c];
            if (faces_[c / 3].side != 0 && speakers_[set] == none) {
                speakers_[set] = c;
            }
        }
        const std::size_t old_count = mesh_.positions.size();
        std::vector<std::uint32_t> set_of(old_count, none);  // of each vertex, old or new
        std::vector<std::uint32_t> twin(old_count, none);    // the next vertex that came from the same one
        mesh_.tangents.assign(old_count, glm::vec4(1.0f, 0.0f, 0.0f, 1.0f));
        for (std::uint32_t c = 0; c < corners; ++c) {
            const std::uint32_t set = sets_.find(c);
            std::uint32_t v = vertex(c);
            while (set_of[v] != set && set_of[v] != none && twin[v] != none) {
                v = twin[v];
            }
            if (set_of[v] == none) {
                set_of[v] = set;
                mesh_.tangents[v] = tangent_of(c);
            } else if (set_of[v] != set) {
                const auto copy = static_cast<std::uint32_t>(mesh_.positions.size());
                const glm::vec4 tangent = tangent_of(c);
                repeat(mesh_.positions, v);
                repeat(mesh_.normals, v);
                repeat(mesh_.uvs, v);
                repeat(mesh_.second_uvs, v);
                repeat(mesh_.colors, v);
                mesh_.tangents.push_back(tangent);
                twin[v] = copy;
                set_of.push_back(set);
                twin.push_back(none);
                v = copy;
            }
            mesh_.triangles[c / 3][static_cast<int>(c % 3)] = v;
        }
    }

    template <class Item>
    static void repeat(std::vector<Item>& list, std::uint32_t index) {
        if (!list.empty()) {
            const Item item = list[index];
            list.push_back(item);
        }
    }

    scene::TriangleMesh& mesh_;
    Sets sets_;
    std::vector<std::uint32_t> same_;  // of each vertex, the one that stands for all like it
    std::vector<Face> faces_;
    std::vector<glm::dvec3> sums_;  // of each set, at its first corner
    std::vector<glm::dvec3> sums_of_sets_;
    std::vector<std::uint32_t> speakers_;  // of each set, its first corner that knows its side
};

}  // namespace

void add_tangents(scene::TriangleMesh& mesh) {
    if (!mesh.normals.empty() && !mesh.uvs.empty()) {
        Tangents(mesh).add();
    }
}

}  // namespace lancer
