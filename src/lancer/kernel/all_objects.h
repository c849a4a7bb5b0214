// Every object of a small scene against every ray, without a tree: nothing to build, no branch to miss, all lanes busy.
// Objects are numbered kind by kind, as world/ lays them out; meshes (OBJECT_MESH) are not looked at.
#ifndef LANCER_KERNEL_ALL_OBJECTS_H
#define LANCER_KERNEL_ALL_OBJECTS_H

#include "lancer/kernel/plane.h"
#include "lancer/kernel/triangle.h"

NAMESPACE_BEGIN

FN void keep_nearer(Float t, int object, INOUT(Hit) hit) {
    Mask nearer = t < hit.t;
    hit.t = select(nearer, t, hit.t);
    hit.object = select(nearer, Int(object), hit.object);
}

FN TriangleHit meet_triangle(IN(WorldRecord) world, int index, IN(Ray) ray) {
    vec3 a = AT(world.triangles, index).a;
    vec3 b = AT(world.triangles, index).b;
    vec3 c = AT(world.triangles, index).c;
    return triangle_hit(broadcast(a), broadcast(b), broadcast(c), ray);
}

FN void keep_nearer_triangle(IN(WorldRecord) world, int index, int object, IN(Ray) ray, INOUT(Hit) hit) {
    TriangleHit met = meet_triangle(world, index, ray);
    Mask nearer = met.t < hit.t;
    hit.u = select(nearer, met.u, hit.u);
    hit.v = select(nearer, met.v, hit.v);
    hit.part = select(nearer, Int(AT(world.objects, object).sub), hit.part);
    keep_nearer(met.t, object, hit);
}

FN Float triangle_distance(IN(WorldRecord) world, int index, IN(Ray) ray) {
    TriangleHit met = meet_triangle(world, index, ray);
    return met.t;
}

FN Hit closest_of_all(IN(WorldRecord) world, IN(Ray) ray, Mask alive) {
    Hit hit = no_hit(ray);
    int object = 0;
    for (int i = 0; i < world.sphere_count; ++i) {
        keep_nearer(sphere_distance(AT(world.spheres, i), ray, alive), object, hit);
        ++object;
    }
    if (world.box_count > 0) {
        Vec3 inverse = slab_reciprocal(ray.direction);
        for (int i = 0; i < world.box_count; ++i) {
            keep_nearer(box_distance(AT(world.boxes, i), ray, inverse), object, hit);
            ++object;
        }
    }
    for (int i = 0; i < world.plane_count; ++i) {
        keep_nearer(plane_distance(AT(world.planes, i), ray), object, hit);
        ++object;
    }
    for (int i = 0; i < world.placed_count; ++i) {
        keep_nearer(placed_distance(AT(world.placed, i), AT(world.objects, object).kind, ray), object, hit);
        ++object;
    }
    for (int i = 0; i < world.triangle_count; ++i) {
        keep_nearer_triangle(world, i, object, ray, hit);
        ++object;
    }
    return hit;
}

FN Mask occluded_by_any(IN(WorldRecord) world, IN(Ray) ray, Mask alive) {
    Mask open = alive;
    int object = world.sphere_count + world.box_count + world.plane_count;
    for (int i = 0; i < world.sphere_count && some(open); ++i) {
        open = without(open, sphere_distance(AT(world.spheres, i), ray, open) < ray.reach);
    }
    if (world.box_count > 0 && some(open)) {
        Vec3 inverse = slab_reciprocal(ray.direction);
        for (int i = 0; i < world.box_count; ++i) {
            open = without(open, box_distance(AT(world.boxes, i), ray, inverse) < ray.reach);
        }
    }
    for (int i = 0; i < world.plane_count && some(open); ++i) {
        open = without(open, plane_distance(AT(world.planes, i), ray) < ray.reach);
    }
    for (int i = 0; i < world.placed_count && some(open); ++i) {
        open = without(open, placed_distance(AT(world.placed, i), AT(world.objects, object).kind, ray) < ray.reach);
        ++object;
    }
    for (int i = 0; i < world.triangle_count && some(open); ++i) {
        open = without(open, triangle_distance(world, i, ray) < ray.reach);
    }
    return without(alive, open);
}

NAMESPACE_END

#endif
