#include "lancer/world/surroundings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <glm/geometric.hpp>

namespace lancer {

namespace {

struct Body {
    int material = 0;
    double size = 0.0;  // about its volume
};

glm::dvec3 apply(const kernel::AffineRecord& map, const glm::dvec3& p) {
    return glm::dvec3(glm::dot(glm::dvec3(map.row_x), p), glm::dot(glm::dvec3(map.row_y), p), glm::dot(glm::dvec3(map.row_z), p)) +
           glm::dvec3(map.shift);
}

double volume_of(const glm::dvec3& low, const glm::dvec3& high) { return (high.x - low.x) * (high.y - low.y) * (high.z - low.z); }

double growth(const kernel::AffineRecord& map) {
    return std::abs(glm::dot(glm::dvec3(map.row_x), glm::cross(glm::dvec3(map.row_y), glm::dvec3(map.row_z))));
}

class Triangles {
public:
    explicit Triangles(const glm::dvec3& point) : point_(point) {}

    void add(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
        low_ = glm::min(low_, glm::min(a, glm::min(b, c)));
        high_ = glm::max(high_, glm::max(a, glm::max(b, c)));
        for (std::size_t i = 0; i < crossed_.size(); ++i) {
            crossed_[i] += crosses(directions()[i], a, b, c) ? 1 : 0;
        }
    }

    // By the majority of three rays: one may run along an edge.
    bool around() const { return crossed_[0] % 2 + crossed_[1] % 2 + crossed_[2] % 2 >= 2; }
    double size() const { return volume_of(low_, high_); }

private:
    static const std::array<glm::dvec3, 3>& directions() {
        static const std::array<glm::dvec3, 3> all{glm::dvec3(0.5377, 0.8339, -0.1257), glm::dvec3(-0.8622, 0.3188, 0.3937),
                                                   glm::dvec3(0.1342, -0.4336, 0.8911)};
        return all;
    }

    bool crosses(const glm::dvec3& d, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) const {
        const glm::dvec3 u = b - a, v = c - a, p = glm::cross(d, v), from = point_ - a;
        const double determinant = glm::dot(u, p);
        if (determinant == 0.0) {
            return false;
        }
        const double s = glm::dot(from, p) / determinant;
        const glm::dvec3 q = glm::cross(from, u);
        const double t = glm::dot(d, q) / determinant;
        return s >= 0.0 && t >= 0.0 && s + t <= 1.0 && glm::dot(v, q) / determinant > 0.0;
    }

    glm::dvec3 point_;
    glm::dvec3 low_{1e300}, high_{-1e300};
    std::array<int, 3> crossed_{};
};

class Around {
public:
    Around(const World& world, const glm::dvec3& point) : world_(world), point_(point) {}

    std::vector<Body> find() {
        std::map<int, Triangles> loose;  // by instance
        std::map<int, int> material_of;
        for (const kernel::ObjectRecord& object : world_.objects) {
            const kernel::MaterialRecord& material = world_.surfaces[static_cast<std::size_t>(object.material)];
            if (material.kind != kernel::BSDF_NULL && (material.flags & (kernel::MATERIAL_BODY | kernel::MATERIAL_BOUNDS)) == 0) {
                continue;
            }
            if (object.kind == kernel::OBJECT_TRIANGLE) {
                const kernel::TriangleRecord& t = world_.triangles[static_cast<std::size_t>(object.index)];
                loose.try_emplace(object.instance, point_).first->second.add(glm::dvec3(t.a), glm::dvec3(t.b), glm::dvec3(t.c));
                material_of[object.instance] = object.material;
            } else {
                look_at(object);
            }
        }
        for (const auto& [instance, triangles] : loose) {
            add(triangles.around(), material_of[instance], triangles.size());
        }
        return bodies_;
    }

private:
    void add(bool around, int material, double size) {
        if (around) {
            bodies_.push_back({material, size});
        }
    }

    void look_at(const kernel::ObjectRecord& object) {
        const auto i = static_cast<std::size_t>(object.index);
        if (object.kind == kernel::OBJECT_SPHERE) {
            const double radius = static_cast<double>(world_.spheres[i].radius);
            add(glm::distance(glm::dvec3(world_.spheres[i].center), point_) < radius, object.material, 8.0 * radius * radius * radius);
        } else if (object.kind == kernel::OBJECT_BOX) {
            const glm::dvec3 low(world_.boxes[i].low), high(world_.boxes[i].high);
            const bool inside =
                point_.x > low.x && point_.y > low.y && point_.z > low.z && point_.x < high.x && point_.y < high.y && point_.z < high.z;
            add(inside, object.material, volume_of(low, high));
        } else if (object.kind == kernel::OBJECT_PLANE) {
            const kernel::PlaneRecord& plane = world_.planes[i];
            add(glm::dot(glm::dvec3(plane.normal), point_) < static_cast<double>(plane.offset), object.material, 1e300);
        } else if (object.kind == kernel::OBJECT_MESH) {
            look_at_mesh(object);
        } else {
            look_at_placed(object, world_.placed[i]);
        }
    }

    void look_at_placed(const kernel::ObjectRecord& object, const kernel::PlacedRecord& shape) {
        const glm::dvec3 p = apply(shape.to_object, point_);
        bool inside = false;
        if (object.kind == kernel::OBJECT_PLACED_SPHERE) {
            inside = glm::dot(p, p) < 1.0;
        } else if (object.kind == kernel::OBJECT_PLACED_BOX) {
            inside = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) < 1.0;
        } else if (object.kind == kernel::OBJECT_PLACED_CONE && shape.capped != 0) {
            const double radius = static_cast<double>(shape.bottom_radius) * (1.0 - p.y) + static_cast<double>(shape.top_radius) * p.y;
            inside = p.y > 0.0 && p.y < 1.0 && p.x * p.x + p.z * p.z < radius * radius;
        }
        add(inside, object.material, growth(shape.to_world));
    }

    void look_at_mesh(const kernel::ObjectRecord& object) {
        const kernel::InstanceRecord& instance = world_.instances[static_cast<std::size_t>(object.index)];
        const kernel::MeshRecord& mesh = world_.meshes[static_cast<std::size_t>(instance.mesh)];
        Triangles triangles(point_);
        for (int i = 0; i < mesh.triangle_count; ++i) {
            glm::dvec3 corner[3];
            for (int j = 0; j < 3; ++j) {
                const int vertex = world_.indices[static_cast<std::size_t>(3 * (mesh.first_triangle + i) + j)] + mesh.first_vertex;
                corner[j] = apply(instance.to_world, glm::dvec3(world_.positions[static_cast<std::size_t>(vertex)]));
            }
            triangles.add(corner[0], corner[1], corner[2]);
        }
        add(triangles.around(), object.material, triangles.size());
    }

    const World& world_;
    glm::dvec3 point_;
    std::vector<Body> bodies_;
};

}  // namespace

std::array<int, 4> bodies_around(const World& world, const glm::dvec3& point) {
    std::vector<Body> bodies = Around(world, point).find();
    std::stable_sort(bodies.begin(), bodies.end(), [](const Body& a, const Body& b) { return a.size < b.size; });
    // The highest first; of equals the smaller one, which was entered later.
    const auto priority = [&](const Body& body) { return world.media[static_cast<std::size_t>(body.material)].priority; };
    std::stable_sort(bodies.begin(), bodies.end(), [&](const Body& a, const Body& b) { return priority(a) > priority(b); });
    std::array<int, 4> result{-1, -1, -1, -1};
    for (std::size_t i = 0; i < std::min(bodies.size(), result.size()); ++i) {
        result[i] = bodies[i].material;
    }
    return result;
}

}  // namespace lancer
