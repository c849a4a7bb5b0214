#include "lancer/trace/packet.h"

#include <cstddef>

#include "lancer/kernel/plane.h"
#include "lancer/kernel/triangle.h"
#include "lancer/trace/implementation.h"

namespace lancer {

namespace {

const Tree::Implementation& tree_of(const kernel::WorldRecord& world) { return reinterpret_cast<const Tree*>(world.tree)->implementation(); }

kernel::Ray ray_of(const TracePacket& p, int lane) {
    return {kernel::vec3_of(p.origin_x[lane], p.origin_y[lane], p.origin_z[lane]),
            kernel::vec3_of(p.direction_x[lane], p.direction_y[lane], p.direction_z[lane]), p.reach[lane]};
}

template <int lanes>
struct Packet;
template <>
struct Packet<4> {
    using Ray = RTCRay4;
    using RayHit = RTCRayHit4;
    static constexpr auto intersect = rtcIntersect4;
    static constexpr auto occlude = rtcOccluded4;
};
template <>
struct Packet<8> {
    using Ray = RTCRay8;
    using RayHit = RTCRayHit8;
    static constexpr auto intersect = rtcIntersect8;
    static constexpr auto occlude = rtcOccluded8;
};
template <>
struct Packet<16> {
    using Ray = RTCRay16;
    using RayHit = RTCRayHit16;
    static constexpr auto intersect = rtcIntersect16;
    static constexpr auto occlude = rtcOccluded16;
};

bool is_alive(const TracePacket& p, int lane) { return ((p.alive >> lane) & 1u) != 0; }

template <int lanes>
void fill(const TracePacket& p, typename Packet<lanes>::Ray& rays, int* valid) {
    for (int i = 0; i < lanes; ++i) {
        valid[i] = is_alive(p, i) ? -1 : 0;
        rays.org_x[i] = p.origin_x[i];
        rays.org_y[i] = p.origin_y[i];
        rays.org_z[i] = p.origin_z[i];
        rays.dir_x[i] = p.direction_x[i];
        rays.dir_y[i] = p.direction_y[i];
        rays.dir_z[i] = p.direction_z[i];
        rays.tnear[i] = 0.0f;
        rays.tfar[i] = p.reach[i];
        rays.time[i] = 0.0f;
        rays.mask[i] = ~0u;
        rays.flags[i] = 0;
    }
}

// The kernel's own distance and place on the triangle; Embree's where the two disagree at its very edge.
void meet_again(const kernel::WorldRecord& world, int object, TracePacket& p, int lane) {
    const kernel::InstanceRecord& instance = world.instances[world.objects[object].index];
    const kernel::MeshRecord& mesh = world.meshes[instance.mesh];
    const int* corners = world.indices + 3 * (mesh.first_triangle + p.part[lane]);
    const auto corner = [&](int i) {
        return kernel::apply_affine(instance.to_world, kernel::broadcast(world.positions[mesh.first_vertex + corners[i]]));
    };
    const kernel::TriangleHit hit = kernel::triangle_hit(corner(0), corner(1), corner(2), ray_of(p, lane));
    if (hit.t < kernel::FAR) {
        p.t[lane] = hit.t;
        p.u[lane] = hit.u;
        p.v[lane] = hit.v;
    }
}

// Planes are in no tree. One at the same distance as an object with a smaller number stays behind it.
void meet_planes(const kernel::WorldRecord& world, TracePacket& p, int lane) {
    const int first = world.sphere_count + world.box_count;
    const kernel::Ray ray = ray_of(p, lane);
    for (int i = 0; i < world.plane_count; ++i) {
        const float t = kernel::plane_distance(world.planes[i], ray);
        if (t < p.t[lane] || (t == p.t[lane] && t < ray.reach && first + i < p.object[lane])) {
            p.t[lane] = t;
            p.object[lane] = first + i;
            p.part[lane] = 0;
        }
    }
}

template <int lanes>
void closest(const kernel::WorldRecord& world, TracePacket& p) {
    const Tree::Implementation& tree = tree_of(world);
    alignas(64) int valid[static_cast<std::size_t>(lanes)];
    typename Packet<lanes>::RayHit packet;
    fill<lanes>(p, packet.ray, valid);
    for (int i = 0; i < lanes; ++i) {
        packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
        packet.hit.primID[i] = RTC_INVALID_GEOMETRY_ID;
        packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
    }
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    Packet<lanes>::intersect(valid, tree.scene, &context, &packet);
    for (int i = 0; i < lanes; ++i) {
        p.t[i] = p.reach[i];
        p.object[i] = -1;
        p.part[i] = 0;
        p.u[i] = 0.0f;
        p.v[i] = 0.0f;
        if (!is_alive(p, i)) {
            continue;
        }
        const unsigned instance = packet.hit.instID[0][i];
        if (instance != RTC_INVALID_GEOMETRY_ID) {
            p.t[i] = packet.ray.tfar[i];
            p.object[i] = tree.objects_of_geometry[instance];
            p.part[i] = static_cast<int>(packet.hit.primID[i]);
            p.u[i] = packet.hit.u[i];
            p.v[i] = packet.hit.v[i];
            meet_again(world, p.object[i], p, i);
        } else if (packet.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID) {
            p.t[i] = packet.ray.tfar[i];
            p.object[i] = tree.shapes[packet.hit.primID[i]];
            p.part[i] = world.objects[p.object[i]].sub;
            p.u[i] = packet.hit.u[i];
            p.v[i] = packet.hit.v[i];
        }
        meet_planes(world, p, i);
    }
}

template <int lanes>
void occlude(const kernel::WorldRecord& world, TracePacket& p) {
    const Tree::Implementation& tree = tree_of(world);
    alignas(64) int valid[static_cast<std::size_t>(lanes)];
    typename Packet<lanes>::Ray packet;
    fill<lanes>(p, packet, valid);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    Packet<lanes>::occlude(valid, tree.scene, &context, &packet);
    for (int i = 0; i < lanes; ++i) {
        bool hidden = packet.tfar[i] < 0.0f;
        for (int plane = 0; plane < world.plane_count && !hidden; ++plane) {
            hidden = kernel::plane_distance(world.planes[plane], ray_of(p, i)) < p.reach[i];
        }
        p.object[i] = hidden && is_alive(p, i) ? 1 : 0;
    }
}

}  // namespace

void trace_closest(const kernel::WorldRecord& world, TracePacket& packet) {
    if (packet.lanes == 16) {
        closest<16>(world, packet);
    } else if (packet.lanes == 8) {
        closest<8>(world, packet);
    } else {
        closest<4>(world, packet);
    }
}

void trace_occluded(const kernel::WorldRecord& world, TracePacket& packet) {
    if (packet.lanes == 16) {
        occlude<16>(world, packet);
    } else if (packet.lanes == 8) {
        occlude<8>(world, packet);
    } else {
        occlude<4>(world, packet);
    }
}

}  // namespace lancer
