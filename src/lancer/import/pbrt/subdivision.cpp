#include "lancer/import/pbrt/subdivision.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

namespace lancer::pbrt {

namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

Edge edge_between(std::uint32_t a, std::uint32_t b) { return a < b ? Edge(a, b) : Edge(b, a); }

struct EdgeFacts {
    int faces = 0;
    std::uint32_t opposite[2] = {0, 0};
    std::uint32_t middle = 0;  // the new vertex
};

// The neighbours of a vertex in order; on a border from its one end to the other.
struct Ring {
    std::vector<std::uint32_t> vertices;
    bool closed = true;
};

std::vector<Ring> find_rings(std::size_t vertex_count, const std::vector<glm::uvec3>& triangles) {
    // Of each vertex: from the second corner of a face around it to the third.
    std::vector<std::vector<Edge>> next(vertex_count);
    for (const glm::uvec3& t : triangles) {
        next[t.x].emplace_back(t.y, t.z);
        next[t.y].emplace_back(t.z, t.x);
        next[t.z].emplace_back(t.x, t.y);
    }
    std::vector<Ring> rings(vertex_count);
    for (std::size_t v = 0; v < vertex_count; ++v) {
        std::vector<Edge>& steps = next[v];
        if (steps.empty()) {
            continue;
        }
        const auto reached = [&](std::uint32_t a) {
            return std::any_of(steps.begin(), steps.end(), [&](const Edge& s) { return s.second == a; });
        };
        const auto start = std::find_if(steps.begin(), steps.end(), [&](const Edge& s) { return !reached(s.first); });
        Ring& ring = rings[v];
        ring.closed = start == steps.end();
        std::uint32_t at = ring.closed ? steps.front().first : start->first;
        ring.vertices.push_back(at);
        for (std::size_t i = 0; i < steps.size(); ++i) {
            const auto step = std::find_if(steps.begin(), steps.end(), [&](const Edge& s) { return s.first == at; });
            if (step == steps.end() || (ring.closed && step->second == ring.vertices.front())) {
                break;
            }
            at = step->second;
            ring.vertices.push_back(at);
        }
    }
    return rings;
}

double inner_weight(std::size_t valence) { return valence == 3 ? 3.0 / 16.0 : 3.0 / (8.0 * static_cast<double>(valence)); }

class Subdivision {
public:
    explicit Subdivision(scene::TriangleMesh cage) : triangles_(std::move(cage.triangles)) {
        for (const glm::vec3& p : cage.positions) {
            points_.emplace_back(p);
        }
    }

    void refine() {
        const std::vector<Ring> rings = find_rings(points_.size(), triangles_);
        std::map<Edge, EdgeFacts> edges;
        for (const glm::uvec3& t : triangles_) {
            for (int i = 0; i < 3; ++i) {
                EdgeFacts& edge = edges[edge_between(t[i], t[(i + 1) % 3])];
                edge.opposite[edge.faces > 0 ? 1 : 0] = t[(i + 2) % 3];
                ++edge.faces;
            }
        }
        std::vector<glm::dvec3> refined(points_.size());
        for (std::size_t v = 0; v < points_.size(); ++v) {
            refined[v] = weighed(v, rings[v], inner_weight(rings[v].vertices.size()), 1.0 / 8.0);
        }
        for (auto& [ends, edge] : edges) {
            const glm::dvec3 ends_sum = points_[ends.first] + points_[ends.second];
            edge.middle = static_cast<std::uint32_t>(refined.size());
            refined.push_back(edge.faces == 2
                                  ? ends_sum * (3.0 / 8.0) + (points_[edge.opposite[0]] + points_[edge.opposite[1]]) * (1.0 / 8.0)
                                  : ends_sum * 0.5);
        }
        std::vector<glm::uvec3> smaller;
        smaller.reserve(4 * triangles_.size());
        for (const glm::uvec3& t : triangles_) {
            const std::uint32_t xy = edges[edge_between(t.x, t.y)].middle, yz = edges[edge_between(t.y, t.z)].middle,
                                zx = edges[edge_between(t.z, t.x)].middle;
            smaller.emplace_back(t.x, xy, zx);
            smaller.emplace_back(xy, t.y, yz);
            smaller.emplace_back(zx, yz, t.z);
            smaller.emplace_back(xy, yz, zx);
        }
        points_ = std::move(refined);
        triangles_ = std::move(smaller);
    }

    scene::TriangleMesh limit() const {
        const std::vector<Ring> rings = find_rings(points_.size(), triangles_);
        scene::TriangleMesh mesh;
        std::vector<glm::dvec3> limits(points_.size());
        for (std::size_t v = 0; v < points_.size(); ++v) {
            const std::size_t valence = rings[v].vertices.size();
            const double weight = valence > 0 ? 1.0 / (static_cast<double>(valence) + 3.0 / (8.0 * inner_weight(valence))) : 0.0;
            limits[v] = weighed(v, rings[v], weight, 1.0 / 5.0);
        }
        std::vector<glm::dvec3> outwards(points_.size(), glm::dvec3(0.0));
        for (const glm::uvec3& t : triangles_) {
            const glm::dvec3 face = glm::cross(limits[t.y] - limits[t.x], limits[t.z] - limits[t.x]);
            for (int i = 0; i < 3; ++i) {
                outwards[t[i]] += face;
            }
        }
        for (std::size_t v = 0; v < points_.size(); ++v) {
            const glm::vec3 n = normal(v, rings[v], limits);
            mesh.positions.emplace_back(limits[v]);
            mesh.normals.push_back(glm::dot(glm::dvec3(n), outwards[v]) < 0.0 ? -n : n);
        }
        mesh.triangles = triangles_;
        return mesh;
    }

private:
    // A vertex between its neighbours; on a border between those two that lie on it, too.
    glm::dvec3 weighed(std::size_t v, const Ring& ring, double inner, double border) const {
        if (ring.vertices.size() < 2) {
            return points_[v];
        }
        if (!ring.closed) {
            return points_[v] * (1.0 - 2.0 * border) + (points_[ring.vertices.front()] + points_[ring.vertices.back()]) * border;
        }
        glm::dvec3 sum(0.0);
        for (const std::uint32_t neighbour : ring.vertices) {
            sum += points_[neighbour];
        }
        return points_[v] * (1.0 - inner * static_cast<double>(ring.vertices.size())) + sum * inner;
    }

    // Two tangents by the masks of the limit surface; on a border, one of them along it.
    glm::vec3 normal(std::size_t v, const Ring& ring, const std::vector<glm::dvec3>& limits) const {
        const std::size_t n = ring.vertices.size();
        if (n < 2) {
            return glm::vec3(0.0f, 0.0f, 1.0f);
        }
        const auto neighbour = [&](std::size_t i) { return limits[ring.vertices[i]]; };
        glm::dvec3 s(0.0), t(0.0);
        if (ring.closed) {
            for (std::size_t i = 0; i < n; ++i) {
                const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
                s += std::cos(angle) * neighbour(i);
                t += std::sin(angle) * neighbour(i);
            }
        } else {
            s = neighbour(0) - neighbour(n - 1);
            if (n == 2) {
                t = neighbour(0) + neighbour(1) - 2.0 * limits[v];
            } else if (n == 3) {
                t = neighbour(1) - limits[v];
            } else {
                const double theta = std::numbers::pi / static_cast<double>(n - 1);
                t = std::sin(theta) * (neighbour(0) + neighbour(n - 1));
                for (std::size_t i = 1; i + 1 < n; ++i) {
                    t += (2.0 * std::cos(theta) - 2.0) * std::sin(static_cast<double>(i) * theta) * neighbour(i);
                }
                t = -t;
            }
        }
        const glm::dvec3 across = glm::cross(s, t);
        const double length = glm::length(across);
        return length > 0.0 ? glm::vec3(across / length) : glm::vec3(0.0f);
    }

    std::vector<glm::dvec3> points_;
    std::vector<glm::uvec3> triangles_;
};

}  // namespace

scene::TriangleMesh loop_subdivision(scene::TriangleMesh cage, int levels) {
    Subdivision subdivision(std::move(cage));
    for (int i = 0; i < levels; ++i) {
        subdivision.refine();
    }
    return subdivision.limit();
}

}  // namespace lancer::pbrt
