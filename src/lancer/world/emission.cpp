#include "lancer/world/emission.h"

#include <algorithm>
#include <numbers>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "lancer/kernel/placed.h"

namespace lancer {

namespace {

using std::numbers::pi;

struct Extent {
    glm::dvec3 low{1e300};
    glm::dvec3 high{-1e300};

    void add(const kernel::Vec3& p) { add(glm::dvec3(static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z))); }
    void add(const glm::dvec3& p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
};

// The corners of a box under a map.
void add_box(const kernel::AffineRecord& map, const glm::dvec3& low, const glm::dvec3& high, Extent& extent) {
    for (int corner = 0; corner < 8; ++corner) {
        const kernel::vec3 p((corner & 1) != 0 ? high.x : low.x, (corner & 2) != 0 ? high.y : low.y, (corner & 4) != 0 ? high.z : low.z);
        extent.add(kernel::apply_affine(map, kernel::broadcast(p)));
    }
}

void add_placed(const kernel::PlacedRecord& shape, int kind, Extent& extent) {
    const double wide = kind == kernel::OBJECT_PLACED_CONE ? static_cast<double>(std::max(shape.bottom_radius, shape.top_radius)) : 1.0;
    const double low = kind == kernel::OBJECT_PLACED_CONE || kind == kernel::OBJECT_PLACED_DISK ? 0.0 : -1.0;
    const double high = kind == kernel::OBJECT_PLACED_DISK ? 0.0 : 1.0;
    add_box(shape.to_world, {-wide, low, -wide}, {wide, high, wide}, extent);
}

Extent extent_of(const World& world) {
    Extent extent;
    for (const kernel::SphereRecord& sphere : world.spheres) {
        extent.add(glm::dvec3(sphere.center) - static_cast<double>(sphere.radius));
        extent.add(glm::dvec3(sphere.center) + static_cast<double>(sphere.radius));
    }
    for (const kernel::BoxRecord& box : world.boxes) {
        extent.add(glm::dvec3(box.low));
        extent.add(glm::dvec3(box.high));
    }
    for (const kernel::TriangleRecord& t : world.triangles) {
        for (const kernel::vec3& corner : {t.a, t.b, t.c}) {
            extent.add(glm::dvec3(corner));
        }
    }
    std::vector<Extent> meshes(world.meshes.size());
    for (const kernel::ObjectRecord& object : world.objects) {
        const auto index = static_cast<std::size_t>(object.index);
        if (object.kind == kernel::OBJECT_MESH) {
            const kernel::InstanceRecord& instance = world.instances[index];
            Extent& own = meshes[static_cast<std::size_t>(instance.mesh)];
            const kernel::MeshRecord& mesh = world.meshes[static_cast<std::size_t>(instance.mesh)];
            for (int i = own.low.x > own.high.x ? 0 : 3 * mesh.triangle_count; i < 3 * mesh.triangle_count; ++i) {
                const int vertex = world.indices[static_cast<std::size_t>(3 * mesh.first_triangle + i)] + mesh.first_vertex;
                own.add(glm::dvec3(world.positions[static_cast<std::size_t>(vertex)]));
            }
            if (mesh.triangle_count > 0) {
                add_box(instance.to_world, own.low, own.high, extent);
            }
        } else if (object.kind >= kernel::OBJECT_PLACED_SPHERE && object.kind <= kernel::OBJECT_PLACED_CONE) {
            add_placed(world.placed[index], object.kind, extent);
        }
    }
    return extent;
}

// In watts or lumens, about; `strength` is what the emitter makes at a distance of one metre, or anywhere.
double power_of(const kernel::EmitterRecord& emitter, double scene_radius) {
    const double strength = static_cast<double>(emitter.strength);
    switch (emitter.kind) {
        case kernel::EMITTER_DIRECTIONAL:
            return strength * pi * scene_radius * scene_radius;
        case kernel::EMITTER_ENVIRONMENT:
            return strength * 4.0 * pi * scene_radius * scene_radius;
        case kernel::EMITTER_SPOT:
            return strength * 2.0 * pi * (1.0 - static_cast<double>(emitter.cos_outer));
        default:
            return strength * pi * (emitter.planar == 0 ? 4.0 : emitter.two_sided != 0 ? 2.0 : 1.0);
    }
}

}  // namespace

void compile_emission(World& world) {
    const Extent extent = extent_of(world);
    world.scene_radius = 1.0f;
    if (extent.low.x <= extent.high.x) {
        world.scene_middle = kernel::vec3((extent.low + extent.high) * 0.5);
        world.scene_radius = static_cast<float>(std::max(glm::length(extent.high - extent.low) * 0.50001, 1e-6));
    }
    std::vector<double> powers;
    double sum = 0.0;
    for (const kernel::EmitterRecord& emitter : world.emitters) {
        powers.push_back(std::max(power_of(emitter, static_cast<double>(world.scene_radius)), 1e-30));
        sum += powers.back();
    }
    world.first_emission = static_cast<int>(world.distributions.size());
    double so_far = 0.0;
    for (const double power : powers) {
        so_far += power;
        world.distributions.push_back(static_cast<float>(so_far / sum));
    }
    if (!powers.empty()) {
        world.distributions.back() = 1.0f;
    }
}

}  // namespace lancer
