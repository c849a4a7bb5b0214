// The kernel's two questions to the scene, answered for a register full of rays: by all objects of a small world, by the tree of a large one.
#pragma once

#include "lancer/device/cpu/near_objects.h"
#include "lancer/kernel/intersect.h"
#include "lancer/trace/packet.h"

namespace lancer::LANCER_KERNEL {

FN TracePacket to_packet(IN(Ray) ray, Mask alive) {
    TracePacket p;
    ray.origin.x.store_aligned(p.origin_x);
    ray.origin.y.store_aligned(p.origin_y);
    ray.origin.z.store_aligned(p.origin_z);
    ray.direction.x.store_aligned(p.direction_x);
    ray.direction.y.store_aligned(p.direction_y);
    ray.direction.z.store_aligned(p.direction_z);
    ray.reach.store_aligned(p.reach);
    p.alive = mask_bits(alive);
    p.lanes = LANES;
    return p;
}

Hit closest_hit(IN(WorldRecord) world, IN(Ray) ray, Mask alive) {
    if (world.tree == nullptr) {
        return closest_of_near(world, ray, alive);
    }
    TracePacket p = to_packet(ray, alive);
    trace_closest(world, p);
    Hit hit;
    hit.t = Float::load_aligned(p.t);
    hit.object = Int::load_aligned(p.object);
    hit.part = Int::load_aligned(p.part);
    hit.u = Float::load_aligned(p.u);
    hit.v = Float::load_aligned(p.v);
    return hit;
}

Mask occluded(IN(WorldRecord) world, IN(Ray) ray, Mask alive) {
    if (world.tree == nullptr) {
        return occluded_by_near(world, ray, alive);
    }
    TracePacket p = to_packet(ray, alive);
    trace_occluded(world, p);
    return to_mask(Int::load_aligned(p.object) == Int(1));
}

}  // namespace lancer::LANCER_KERNEL
