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
