#include "lancer/trace/packet.h"

#include <cstddef>

#include "lancer/kernel/plane.h"
#include "lancer/trace/first_hit.h"
#include "lancer/trace/implementation.h"

namespace lancer {

namespace {

const Tree::Implementation& tree_of(const kernel::WorldRecord& world) {
    return reinterpret_cast<const Tree*>(world.tree)->implementation();
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
        rays.id[i] = static_cast<unsigned>(i);
        rays.flags[i] = 0;
    }
}

// Planes are in no tree: they come first.
void meet_planes(const kernel::WorldRecord& world, TracePacket& p, int lane) {
    const int first = world.sphere_count + world.box_count;
    const kernel::Ray ray = lane_ray(p, lane);
    for (int i = 0; i < world.plane_count; ++i) {
        keep_first(p, lane, first + i, 0, {kernel::plane_distance(world.planes[i], ray), 0.0f, 0.0f});
    }
}

// Triangles of meshes that are part of the tree itself: which one is Embree's word, where it is met is the kernel's.
template <int lanes>
void keep_triangles(const kernel::WorldRecord& world, const typename Packet<lanes>::RayHit& packet, TracePacket& p) {
    const Tree::Implementation& tree = tree_of(world);
    int found[static_cast<std::size_t>(lanes)];
    int count = 0;
    for (int i = 0; i < lanes; ++i) {
        if (is_alive(p, i) && packet.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID && packet.hit.instID[0][i] == RTC_INVALID_GEOMETRY_ID) {
            found[count++] = i;
        }
    }
    // All lanes wait for memory together, first for the corners' numbers, then for the corners.
    const auto object_of = [&](int i) { return tree.objects_of_geometry[packet.hit.geomID[i]]; };
    for (int k = 0; k < count; ++k) {
        __builtin_prefetch(corners_of(world, object_of(found[k]), static_cast<int>(packet.hit.primID[found[k]])));
    }
    for (int k = 0; k < count; ++k) {
        const int object = object_of(found[k]);
        const int* corners = corners_of(world, object, static_cast<int>(packet.hit.primID[found[k]]));
        const kernel::MeshRecord& mesh = world.meshes[world.instances[world.objects[object].index].mesh];
        for (int corner = 0; corner < 3; ++corner) {
            const int vertex = mesh.first_vertex + corners[corner];
            __builtin_prefetch(world.positions + vertex);
            if ((mesh.flags & kernel::MESH_HAS_NORMALS) != 0) {  // shading will ask for these
                __builtin_prefetch(world.normals + vertex);
            }
            if ((mesh.flags & kernel::MESH_HAS_UVS) != 0) {
                __builtin_prefetch(world.uvs + vertex);
            }
        }
    }
    for (int k = 0; k < count; ++k) {
        const int i = found[k], object = object_of(i), part = static_cast<int>(packet.hit.primID[i]);
        keep_first(p, i, object, part, mesh_hit(world, object, part, packet.hit.u[i], packet.hit.v[i], lane_ray(p, i)));
    }
}

template <int lanes>
void closest(const kernel::WorldRecord& world, TracePacket& p) {
    alignas(64) int valid[static_cast<std::size_t>(lanes)];
    for (int i = 0; i < lanes; ++i) {
        p.t[i] = p.reach[i];
        p.object[i] = -1;
        p.part[i] = 0;
        p.u[i] = 0.0f;
        p.v[i] = 0.0f;
        if (is_alive(p, i)) {
            meet_planes(world, p, i);
        }
    }
    typename Packet<lanes>::RayHit packet;
    fill<lanes>(p, packet.ray, valid);
    for (int i = 0; i < lanes; ++i) {
        packet.ray.tfar[i] = first_known(p, i);
        packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
        packet.hit.primID[i] = RTC_INVALID_GEOMETRY_ID;
        packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
    }
    TraceContext context{{}, &world, &p};
    rtcInitIntersectContext(&context.embree);
    Packet<lanes>::intersect(valid, tree_of(world).scene, &context.embree, &packet);
    keep_triangles<lanes>(world, packet, p);
}

template <int lanes>
void occlude(const kernel::WorldRecord& world, TracePacket& p) {
    alignas(64) int valid[static_cast<std::size_t>(lanes)];
    typename Packet<lanes>::Ray packet;
    fill<lanes>(p, packet, valid);
    TraceContext context{{}, &world, &p};
    rtcInitIntersectContext(&context.embree);
    Packet<lanes>::occlude(valid, tree_of(world).scene, &context.embree, &packet);
    for (int i = 0; i < lanes; ++i) {
        bool hidden = packet.tfar[i] < 0.0f;
        for (int plane = 0; plane < world.plane_count && !hidden; ++plane) {
            hidden = kernel::plane_distance(world.planes[plane], lane_ray(p, i)) < p.reach[i];
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
