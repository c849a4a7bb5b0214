#include "lancer/scene/bounds.h"

#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace lancer::scene {

void Bounds::include(const glm::dvec3& point) {
    low = glm::min(low, point);
    high = glm::max(high, point);
}

void Bounds::include(const Bounds& other) {
    if (!other.empty()) {
        include(other.low);
        include(other.high);
    }
}

namespace {

// A disk reaches radius * sqrt(1 - n_i^2) along axis i.
void include_disk(Bounds& box, const glm::dvec3& center, const glm::dvec3& normal, double radius) {
    const glm::dvec3 n = glm::normalize(normal);
    const glm::dvec3 reach = radius * glm::sqrt(glm::max(glm::dvec3(0.0), 1.0 - n * n));
    box.include(center - reach);
    box.include(center + reach);
}

Bounds bounds_of(const Sphere& s) { return {s.center - s.radius, s.center + s.radius}; }
Bounds bounds_of(const Box& b) { return {b.min, b.max}; }
Bounds bounds_of(const Plane& p) { return {p.point, p.point}; }

Bounds bounds_of(const Disk& d) {
    Bounds box;
    include_disk(box, d.center, d.normal, d.radius);
    return box;
}

Bounds bounds_of(const Cylinder& c) {
    Bounds box;
    include_disk(box, c.from, c.to - c.from, c.radius);
    include_disk(box, c.to, c.to - c.from, c.radius);
    return box;
}

Bounds bounds_of(const Cone& c) {
    Bounds box;
    include_disk(box, c.from, c.to - c.from, c.radius);
    include_disk(box, c.to, c.to - c.from, c.top_radius);
    return box;
}

Bounds bounds_of(const Mesh& mesh) {
    glm::vec3 low(std::numeric_limits<float>::infinity());
    glm::vec3 high(-std::numeric_limits<float>::infinity());
    for (const glm::uvec3& triangle : mesh.data->triangles) {  // a vertex without a triangle is not seen
        for (std::uint32_t corner : {triangle.x, triangle.y, triangle.z}) {
            low = glm::min(low, mesh.data->positions[corner]);
            high = glm::max(high, mesh.data->positions[corner]);
        }
    }
    return {glm::dvec3(low), glm::dvec3(high)};
}

Bounds contents(const std::vector<Object>& objects, const std::vector<Placement>& placements, const std::vector<Bounds>& groups) {
    Bounds box;
    for (const Object& object : objects) {
        box.include(transform(object.to_parent, bounds(object.shape)));
    }
    for (const Placement& placement : placements) {
        box.include(transform(placement.to_parent, groups[static_cast<std::size_t>(placement.group)]));
    }
    return box;
}

}  // namespace

Bounds bounds(const Shape& shape) {
    return std::visit([](const auto& s) { return bounds_of(s); }, shape);
}

Bounds transform(const glm::dmat4& to_parent, const Bounds& bounds) {
    Bounds result;
    for (int corner = 0; !bounds.empty() && corner < 8; ++corner) {
        const glm::dvec3 p((corner & 1) ? bounds.high.x : bounds.low.x, (corner & 2) ? bounds.high.y : bounds.low.y,
                           (corner & 4) ? bounds.high.z : bounds.low.z);
        result.include(glm::dvec3(to_parent * glm::dvec4(p, 1.0)));
    }
    return result;
}

std::vector<Bounds> group_bounds(const Scene& scene) {
    std::vector<Bounds> all;
    for (const Group& group : scene.groups) {  // a group comes after those it places
        all.push_back(contents(group.objects, group.placements, all));
    }
    return all;
}

Bounds bounds(const Scene& scene) { return contents(scene.objects, scene.placements, group_bounds(scene)); }

}  // namespace lancer::scene
