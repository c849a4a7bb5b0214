// Which hit of a ray comes first, in whatever order a tree offers them.
#pragma once

#include "lancer/kernel/triangle.h"
#include "lancer/trace/packet.h"

namespace lancer {

inline kernel::Ray lane_ray(const TracePacket& p, int lane) {
    return {kernel::vec3_of(p.origin_x[lane], p.origin_y[lane], p.origin_z[lane]),
            kernel::vec3_of(p.direction_x[lane], p.direction_y[lane], p.direction_z[lane]), p.reach[lane]};
}

// The nearest; at the same distance the object with the smaller number, and of its triangles the first. True where this one is it.
inline bool keep_first(TracePacket& p, int lane, int object, int part, const kernel::TriangleHit& hit) {
    const bool is_before = object < p.object[lane] || (object == p.object[lane] && part < p.part[lane]);
    const bool is_first = hit.t < p.t[lane] || (hit.t == p.t[lane] && is_before);
    if (is_first) {
        p.t[lane] = hit.t;
        p.object[lane] = object;
        p.part[lane] = part;
        p.u[lane] = hit.u;
        p.v[lane] = hit.v;
    }
    return is_first;
}

// How far Embree has to look for something that may come first: some dozens of units of rounding behind the first hit so far, since its own
// distances are not those of the kernel. An equal or slightly nearer one must not be culled.
inline float first_known(const TracePacket& p, int lane) {
    if (p.object[lane] < 0) {
        return p.t[lane];
    }
    const float size = kernel::abs(p.origin_x[lane]) + kernel::abs(p.origin_y[lane]) + kernel::abs(p.origin_z[lane]) + p.t[lane];
    return p.t[lane] + size * (64.0f * kernel::ROUNDING);
}

// The numbers of a triangle's corners, counted from its mesh's first vertex.
inline const int* corners_of(const kernel::WorldRecord& world, int object, int part) {
    return world.indices + 3 * (world.meshes[world.instances[world.objects[object].index].mesh].first_triangle + part);
}

// The kernel's answer for a triangle that Embree would accept. Where only the two roundings of its edge differ, Embree's word counts: it
// refused the neighbour. But the distance is the kernel's, in world space, where the ray's origin was moved off its surface.
inline kernel::TriangleHit mesh_hit(const kernel::WorldRecord& world, int object, int part, float u, float v, const kernel::Ray& ray) {
    const kernel::InstanceRecord& instance = world.instances[world.objects[object].index];
    const kernel::MeshRecord& mesh = world.meshes[instance.mesh];
    const int* corners = corners_of(world, object, part);
    const auto corner = [&](int i) {
        return kernel::apply_affine(instance.to_world, kernel::broadcast(world.positions[mesh.first_vertex + corners[i]]));
    };
    const kernel::Vec3 a = corner(0), b = corner(1), c = corner(2);
    kernel::TriangleHit hit = kernel::triangle_hit(a, b, c, ray);
    if (hit.t >= kernel::FAR) {
        const float t = kernel::triangle_plane_distance(a, b, c, ray);
        hit = {t, u, v};
    }
    return hit;
}

}  // namespace lancer
