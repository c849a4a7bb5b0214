// Surfaces that are not there everywhere: leaves cut out of squares, wire, gauze. What lets half of the light pass is met by half of the paths. And panes
// of glass: what they reflect is met, by as many paths, and the rest goes straight on, as light to lamps does.
#ifndef LANCER_KERNEL_CUTS_H
#define LANCER_KERNEL_CUTS_H

#include "lancer/kernel/intersect.h"
#include "lancer/kernel/medium.h"
#include "lancer/kernel/sampler.h"

NAMESPACE_BEGIN

const int MOST_LAYERS = 256;  // surfaces that one ray passes; the next one is there

// What a ray meets, and how much of it is there.
struct CutLayer {
    Float opacity;    // the chance to meet it
    Spectrum passes;  // of light that goes on, where `tints`
    Mask tints;
    Vec3 position;
    Vec3 error;
    Vec3 normal;
};

// What becomes of light that meets a pane, at each wavelength.
struct PaneLight {
    Spectrum mirrored;
    Spectrum passes;  // its tint included
};

// `number`: of the material.
FN PaneLight pane_light(IN(WorldRecord) world, IN(MaterialRecord) material, int number, IN(SurfacePoint) s, Vec3 direction, Vec4 nanometres,
                        Mask mask) {
    PaneLight light;
    light.mirrored = pane_spectrum(abs(dot(s.shading, direction)), refractive_indices(world, Int(number), nanometres, mask));
    light.passes = color_value(world, material.color, s, nanometres, mask) * (vec4_all(Float(1.0f)) - light.mirrored);
    return light;
}

// Textures are looked at in full detail, so that edges stay where they are and rays to lamps find the same as paths do.
FN CutLayer meet_layer(IN(WorldRecord) world, IN(Ray) ray, IN(Hit) hit, Vec4 nanometres, Mask met) {
    CutLayer layer;
    layer.opacity = Float(1.0f);
    layer.passes = black();
    layer.tints = without(met, met);
    layer.position = ray.origin;
    layer.error = vec3_all(Float(0.0f));
    layer.normal = ray.direction;
    Mask todo = met;
    while (some(todo)) {
        int number = first_of(hit.object, todo);
        Mask mine = both(todo, is_equal(hit.object, Int(number)));
        ObjectRecord object = AT(world.objects, number);
        MaterialRecord material = AT(world.surfaces, object.material);
        // A pane that bounds a medium is crossed, see volume/passage.h.
        bool is_pane = (material.flags & MATERIAL_PANE) != 0 && (material.flags & MATERIAL_BOUNDS) == 0;
        if ((material.flags & MATERIAL_CUT) != 0 || is_pane) {
            SurfacePoint s = textured_surface(world, object, material.flags, ray, hit, Float(0.0f), mine);
            Float opacity = Float(1.0f);
            if ((material.flags & MATERIAL_CUT) != 0) {
                opacity = share_value(world, material.opacity, material.opacity_input, s, mine);
            }
            if (material.opacity_cutoff > 0.0f) {
                opacity = select(opacity >= Float(material.opacity_cutoff), Float(1.0f), Float(0.0f));
            }
            if ((material.flags & MATERIAL_OPEN_BEHIND) != 0) {
                opacity = select(dot(s.normal, ray.direction) > Float(0.0f), Float(0.0f), opacity);
            }
            if (is_pane) {
                PaneLight light = pane_light(world, material, object.material, s, ray.direction, nanometres, mine);
                layer.passes = select(mine, vec4_all(Float(1.0f) - opacity) + light.passes * opacity, layer.passes);
                layer.tints = either(layer.tints, mine);
                opacity = opacity * mean(light.mirrored);
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

// Of light that goes on.
FN Spectrum passing_layer(IN(CutLayer) layer) { return select(layer.tints, layer.passes, vec4_all(Float(1.0f) - layer.opacity)); }

// The first surface that is there; `ray` ends up starting from the last one that was not, `passed` metres from where it was. Layers are drawn
// from numbers of their own, from `decision` on.
FN Hit closest_there(IN(WorldRecord) world, IN(Sampler) numbers, int decision, Vec4 nanometres, Mask alive, INOUT(Ray) ray,
                     INOUT(Float) passed, INOUT(Spectrum) throughput) {
    Hit hit = closest_hit(world, ray, alive);
    if (world.has_cuts != 0) {
        Mask todo = both(alive, is_above(hit.object, Int(-1)));
        for (int i = 0; i < MOST_LAYERS && some(todo); ++i) {
            CutLayer layer = meet_layer(world, ray, hit, nanometres, todo);
            todo = both(todo, layer.opacity < Float(1.0f));
            if (some(todo)) {
                Vec2 u = sample_pair(numbers, UInt(uint(decision + i)));
                todo = both(todo, u.x >= layer.opacity);
            }
            if (some(todo)) {
                Spectrum weight = layer.passes / max(Float(1.0f) - layer.opacity, Float(SMALLEST));
                throughput = select(both(todo, layer.tints), throughput * weight, throughput);
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
FN Spectrum passing_light(IN(WorldRecord) world, IN(Ray) shadow, Vec4 nanometres, Mask asking) {
    Mask hidden = occluded(world, shadow, asking);
    Spectrum share = select(hidden, black(), vec4_all(Float(1.0f)));
    if (world.has_cuts != 0 && some(hidden)) {
        Ray ray = shadow;
        share = vec4_all(Float(1.0f));
        Mask todo = hidden;
        for (int i = 0; i < MOST_LAYERS && some(todo); ++i) {
            Hit hit = closest_hit(world, ray, todo);
            todo = both(todo, is_above(hit.object, Int(-1)));
            CutLayer layer = meet_layer(world, ray, hit, nanometres, todo);
            share = select(todo, share * passing_layer(layer), share);
            todo = without(todo, is_black(share));
            Vec3 next = leave_surface(layer.position, layer.error, layer.normal, ray.direction);
            Mask far = ray.reach >= Float(FAR);
            Float reach = select(far, Float(FAR), ray.reach - dot(next - ray.origin, ray.direction));
            ray.origin = select(todo, next, ray.origin);
            ray.reach = select(todo, reach, ray.reach);
            todo = both(todo, ray.reach > Float(0.0f));
        }
        // More layers than are counted.
        share = select(todo, black(), share);
    }
    return share;
}

NAMESPACE_END

#endif
