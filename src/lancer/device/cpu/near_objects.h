// The objects of a small world that a bundle of rays may meet at all. Where all_objects.h asks every object, this first throws out, many
// objects at a time, those whose bounding sphere lies off the way of the whole bundle. What is left is asked in the same order by the same
// functions, so the answers are the same bits.
#pragma once

#include <cstdint>

#include "lancer/kernel/all_objects.h"

namespace lancer::LANCER_KERNEL {

// One bit for each object. All rays stay within r + k t of a middle ray o + t d, where r bounds the distances of their origins from o and k
// those of their directions from d. A sphere (c, R) whose centre lies at distance h from the middle line and tp along it is met only if
// sqrt(h^2 + (t - tp)^2) <= R + r + k t for some t >= 0. With k < 1 that asks for both
//   h sqrt(1 - k^2) <= R + r + k tp   (the least of the difference over all t) and
//   0 <= R + r + tp                   (since the left side is at least t - tp).
FN std::uint64_t near_objects(IN(WorldRecord) world, IN(Ray) ray, Mask alive) {
    const unsigned bits = mask_bits(alive);
    if (bits == 0) {
        return 0;
    }
    // A lane in the middle of the block where it is on: the bundle is narrowest around it.
    const int middle = ((bits >> (LANES / 2 - 1)) & 1u) != 0 ? LANES / 2 - 1 : __builtin_ctz(bits);
    const Vec3 o =
        vec3_of(Float(lane_of(ray.origin.x, middle)), Float(lane_of(ray.origin.y, middle)), Float(lane_of(ray.origin.z, middle)));
    const Vec3 d =
        vec3_of(Float(lane_of(ray.direction.x, middle)), Float(lane_of(ray.direction.y, middle)), Float(lane_of(ray.direction.z, middle)));
    const Vec3 o_off = ray.origin - o;
    const Vec3 d_off = ray.direction - d;
    const Float zero = Float(0.0f);
    const Float r = sqrt(Float(highest(select(alive, dot(o_off, o_off), zero))));
    const Float k = sqrt(Float(highest(select(alive, dot(d_off, d_off), zero))));
    const Float narrowing = Float(1.0f) - k * k;
    const Mask spreads = k >= Float(1.0f);  // all over the place: nothing can be said
    std::uint64_t result = 0;
    for (int first = 0; first < world.object_count; first += LANES) {
        const Vec3 f = vec3_of(Float::load_unaligned(world.bound_x + first), Float::load_unaligned(world.bound_y + first),
                               Float::load_unaligned(world.bound_z + first)) -
                       o;
        const Float along = dot(f, d);
        const Vec3 off = f - d * along;
        // What the objects' own tests lose to rounding over a distance counts as part of them.
        const Float size = Float::load_unaligned(world.bound_radius + first) + r + abs(along) * Float(16.0f * ROUNDING);
        const Float reach = size + k * along;
        const Mask near = both(reach >= zero, dot(off, off) * narrowing <= reach * reach);
        const Mask met = either(both(near, along + size >= zero), both(spreads, size >= zero));
        result |= static_cast<std::uint64_t>(mask_bits(met)) << first;
    }
    return result;
}

FN int next_object(std::uint64_t& left) {
    const int object = __builtin_ctzll(left);
    left &= left - 1;
    return object;
}

// Bits first to first + count - 1.
FN std::uint64_t take(std::uint64_t objects, int first, int count) {
    const std::uint64_t upper = count >= 64 ? ~0ull : (1ull << count) - 1;
    return first >= 64 ? 0 : objects & (upper << first);
}

FN Hit closest_of_near(IN(WorldRecord) world, IN(Ray) ray, Mask alive) {
    Hit hit = no_hit(ray);
    const std::uint64_t objects = near_objects(world, ray, alive);
    int first = 0;
    for (std::uint64_t left = take(objects, first, world.sphere_count); left != 0;) {
        const int object = next_object(left);
        keep_nearer(sphere_distance(AT(world.spheres, object - first), ray, alive), object, hit);
    }
    first += world.sphere_count;
    if (std::uint64_t left = take(objects, first, world.box_count); left != 0) {
        const Vec3 inverse = slab_reciprocal(ray.direction);
        while (left != 0) {
            const int object = next_object(left);
            keep_nearer(box_distance(AT(world.boxes, object - first), ray, inverse), object, hit);
        }
    }
    first += world.box_count;
    for (std::uint64_t left = take(objects, first, world.plane_count); left != 0;) {
        const int object = next_object(left);
        keep_nearer(plane_distance(AT(world.planes, object - first), ray), object, hit);
    }
    first += world.plane_count;
    for (std::uint64_t left = take(objects, first, world.placed_count); left != 0;) {
        const int object = next_object(left);
        keep_nearer(placed_distance(AT(world.placed, object - first), AT(world.objects, object).kind, ray), object, hit);
    }
    first += world.placed_count;
    for (std::uint64_t left = take(objects, first, world.triangle_count); left != 0;) {
        const int object = next_object(left);
        keep_nearer_triangle(world, object - first, object, ray, hit);
    }
    return hit;
}

FN Mask occluded_by_near(IN(WorldRecord) world, IN(Ray) ray, Mask alive) {
    Mask open = alive;
    const std::uint64_t objects = near_objects(world, ray, alive);
    int first = 0;
    for (std::uint64_t left = take(objects, first, world.sphere_count); left != 0 && some(open);) {
        open = without(open, sphere_distance(AT(world.spheres, next_object(left) - first), ray, open) < ray.reach);
    }
    first += world.sphere_count;
    if (std::uint64_t left = take(objects, first, world.box_count); left != 0 && some(open)) {
        const Vec3 inverse = slab_reciprocal(ray.direction);
        while (left != 0) {
            open = without(open, box_distance(AT(world.boxes, next_object(left) - first), ray, inverse) < ray.reach);
        }
    }
    first += world.box_count;
    for (std::uint64_t left = take(objects, first, world.plane_count); left != 0 && some(open);) {
        open = without(open, plane_distance(AT(world.planes, next_object(left) - first), ray) < ray.reach);
    }
    first += world.plane_count;
    for (std::uint64_t left = take(objects, first, world.placed_count); left != 0 && some(open);) {
        const int object = next_object(left);
        open = without(open, placed_distance(AT(world.placed, object - first), AT(world.objects, object).kind, ray) < ray.reach);
    }
    first += world.placed_count;
    for (std::uint64_t left = take(objects, first, world.triangle_count); left != 0 && some(open);) {
        open = without(open, triangle_distance(world, next_object(left) - first, ray) < ray.reach);
    }
    return without(alive, open);
}

}  // namespace lancer::LANCER_KERNEL
