// Surfaces that are not there everywhere: leaves cut out of squares, wire, gauze. What lets half of the light pass is met by half of the paths.
#ifndef LANCER_KERNEL_CUTS_H
#define LANCER_KERNEL_CUTS_H

#include "lancer/kernel/intersect.h"
#include "lancer/kernel/material.h"
#include "lancer/kernel/sampler.h"

NAMESPACE_BEGIN

const int MOST_LAYERS = 256;  // surfaces that one ray passes; the next one is there

// What a ray meets, and how much of it is there.
struct CutLayer {
    Float opacity;
    Vec3 position;
    Vec3 error;
    Vec3 normal;
};

// Textures are looked at in full detail, so that edges stay where they are and rays to lamps find the same as paths do.
FN CutLayer meet_layer(IN(WorldRecord) world, IN(Ray) ray, IN(Hit) hit, Mask met) {
    CutLayer layer;
    layer.opacity = Float(1.0f);
    layer.position = ray.origin;
    layer.error = vec3_all(Float(0.0f));
    layer.normal = ray.direction;
    Mask todo = met;
    while (some(todo)) {
        int number = first_of(hit.object, todo);
        Mask mine = both(todo, is_equal(hit.object, Int(number)));
        ObjectRecord object = AT(world.objects, number);
        MaterialRecord material = AT(world.surfaces, object.material);
        if ((material.flags & MATERIAL_CUT) != 0) {
            SurfacePoint s = textured_surface(world, object, material.flags, ray, hit, Float(0.0f), mine);
            Float opacity = share_value(world, material.opacity, material.opacity_input, s, mine);
            if (material.opacity_cutoff > 0.0f) {
                opacity = select(opacity >= Float(material.opacity_cutoff), Float(1.0f), Float(0.0f));
            }
            layer.opacity = select(mine, opacity, layer.opacity);
            layer.position = select(mine, s.position, layer.position);
            layer.error = select(mine, s.error, layer.error);
            layer.normal = select(mine, s.normal, layer.normal);
        }
        todo = without(todo, mine);
    }
    return layer;
}

// The first surface that is there; `ray` ends up starting from the last one that was not, `passed` metres from where it was. Layers are drawn
// from numbers of their own, from `decision` on.
FN Hit closest_there(IN(WorldRecord) world, IN(Sampler) numbers, int decision, Mask alive, INOUT(Ray) ray, INOUT(Float) passed) {
    Hit hit = closest_hit(world, ray, alive);
    if (world.has_cuts != 0) {
        Mask todo = both(alive, is_above(hit.object, Int(-1)));
        for (int i = 0; i < MOST_LAYERS && some(todo); ++i) {
            CutLayer layer = meet_layer(world, ray, hit, todo);
            todo = both(todo, layer.opacity < Float(1.0f));
            if (some(todo)) {
                Vec2 u = sample_pair(numbers, UInt(uint(decision + i)));
                todo = both(todo, u.x >= layer.opacity);
            }
            if (some(todo)) {
                ray.origin = select(todo, leave_surface(layer.position, layer.error, layer.normal, ray.direction), ray.origin);
                passed = select(todo, passed + hit.t, passed);
                Hit next = closest_hit(world, ray, todo);
                hit.t = select(todo, next.t, hit.t);
                hit.object = select(todo, next.object, hit.object);
                hit.part = select(todo, next.part, hit.part);
                hit.u = select(todo, next.u, hit.u);
                hit.v = select(todo, next.v, hit.v);
                todo = both(todo, is_above(hit.object, Int(-1)));
            }
        }
    }
    return hit;
}

// What share of light comes along each ray to its reach.
FN Float passing_light(IN(WorldRecord) world, IN(Ray) shadow, Mask asking) {
    Mask hidden = occluded(world, shadow, asking);
    Float share = select(hidden, Float(0.0f), Float(1.0f));
    if (world.has_cuts != 0 && some(hidden)) {
        Ray ray = shadow;
        share = Float(1.0f);
        Mask todo = hidden;
        for (int i = 0; i < MOST_LAYERS && some(todo); ++i) {
            Hit hit = closest_hit(world, ray, todo);
            todo = both(todo, is_above(hit.object, Int(-1)));
            CutLayer layer = meet_layer(world, ray, hit, todo);
            share = select(todo, share * (Float(1.0f) - layer.opacity), share);
            todo = both(todo, share > Float(0.0f));
            Vec3 next = leave_surface(layer.position, layer.error, layer.normal, ray.direction);
            Mask far = ray.reach >= Float(FAR);
            Float reach = select(far, Float(FAR), ray.reach - dot(next - ray.origin, ray.direction));
            ray.origin = select(todo, next, ray.origin);
            ray.reach = select(todo, reach, ray.reach);
            todo = both(todo, ray.reach > Float(0.0f));
        }
        // More layers than are counted.
        share = select(todo, Float(0.0f), share);
    }
    return share;
}

NAMESPACE_END

#endif
