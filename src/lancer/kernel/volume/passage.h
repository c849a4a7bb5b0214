// Straight on through media and through the borders between them that bend nothing: null ones, panes, and those of bodies that lie within another body
// of higher priority.
#ifndef LANCER_KERNEL_VOLUME_PASSAGE_H
#define LANCER_KERNEL_VOLUME_PASSAGE_H

#include "lancer/kernel/cuts.h"
#include "lancer/kernel/medium.h"
#include "lancer/kernel/volume/bodies.h"
#include "lancer/kernel/volume/flight.h"
#include "lancer/kernel/volume/phase.h"

NAMESPACE_BEGIN

const int MOST_BORDERS = 256;  // that one ray passes; beyond there is nothing

// ---- Borders that bend nothing ----------------------------------------------------------------------------------------------------------

struct Crossing {
    Mask open;  // the ray goes straight on
    Mask pane;  // but for what is mirrored, with the chance `mirrored`
    Float mirrored;
    Spectrum passes;  // of a pane's light
    Mask inside;
    Int material;
    Vec3 position;
    Vec3 error;
    Vec3 normal;
};

FN Crossing meet_border(IN(WorldRecord) world, IN(Ray) ray, IN(Hit) hit, IN(Media) media, Vec4 nanometres, Mask met) {
    Crossing c;
    c.open = without(met, met);
    c.pane = c.open;
    c.mirrored = Float(0.0f);
    c.passes = vec4_all(Float(1.0f));
    c.inside = c.open;
    c.material = Int(-1);
    c.position = ray.origin;
    c.error = vec3_all(Float(0.0f));
    c.normal = ray.direction;
    Mask todo = met;
    while (some(todo)) {
        int number = first_of(hit.object, todo);
        Mask mine = both(todo, is_equal(hit.object, Int(number)));
        ObjectRecord object = AT(world.objects, number);
        MaterialRecord material = AT(world.surfaces, object.material);
        bool is_null = material.kind == BSDF_NULL;
        bool is_body = world.has_priorities != 0 && (material.flags & MATERIAL_BODY) != 0;
        bool is_pane = (material.flags & MATERIAL_BOUNDS) != 0;
        if (is_null || is_body || is_pane) {
            SurfacePoint s = textured_surface(world, object, is_pane ? material.flags : 0, ray, hit, Float(0.0f), mine);
            Mask inside = both(mine, dot(s.normal, ray.direction) > Float(0.0f));
            Mask open = mine;
            if (is_pane) {
                PaneLight light = pane_light(world, material, object.material, s, ray.direction, nanometres, mine);
                c.mirrored = select(mine, mean(light.mirrored), c.mirrored);
                c.passes = select(mine, light.passes, c.passes);
                c.pane = either(c.pane, mine);
            } else if (!is_null) {
                Media beyond = entered_in_order(world, media, Int(object.material), mine);
                Mask under = is_inside(media, Int(object.material));
                Mask covered = without(under, is_equal(media.first, Int(object.material)));
                open = both(mine, select_mask(inside, covered, without(mine, is_equal(beyond.first, Int(object.material)))));
            }
            c.open = either(c.open, open);
            c.inside = either(c.inside, inside);
            c.material = select(mine, Int(object.material), c.material);
            c.position = select(mine, s.position, c.position);
            c.error = select(mine, s.error, c.error);
            c.normal = select(mine, s.normal, c.normal);
        }
        todo = without(todo, mine);
    }
    return c;
}

// ---- A path --------------------------------------------------------------------------------------------------------------------------------

// From a vertex to the next: a surface, a point of a medium, or nothing any more.
struct Passage {
    Ray ray;       // from the last border
    Hit hit;       // along it, `passed` metres of cut surfaces behind; object -1 where it ends elsewhere
    Float passed;  //
    Float before;  // metres from the vertex to the last border
    Media media;
    Spectrum throughput;
    Spectrum emission;  // radiance that the media have added
    Spectrum thinned;   // as of a Flight, all along
    Mask scattered;     // in a medium:
    Vec3 position;
    Spectrum extinction;
    Int phase;
    Float asymmetry;
    Mask lost;  // passed too many borders
};

// `depth`: the vertices before this one.
FN_LARGE Passage pass_media(IN(WorldRecord) world, IN(Sampler) numbers, int depth, Vec3 origin, Vec3 direction, IN(Media) media,
                            Spectrum throughput, Vec4 nanometres, Mask alive) {
    Passage p;
    p.ray.origin = origin;
    p.ray.direction = direction;
    p.ray.reach = Float(FAR);
    p.hit = no_hit(p.ray);
    p.passed = Float(0.0f);
    p.before = Float(0.0f);
    p.media = media;
    p.throughput = throughput;
    p.emission = black();
    p.thinned = vec4_all(Float(1.0f));
    p.extinction = vec4_all(Float(1.0f));
    p.scattered = without(alive, alive);
    p.position = origin;
    p.phase = Int(PHASE_HENYEY_GREENSTEIN);
    p.asymmetry = Float(0.0f);
    UInt number = UInt(uint(DECISION_FLIGHT + depth * DECISIONS_OF_FLIGHT));
    int layers = DECISION_LAYERS + depth * DECISIONS_OF_LAYERS;
    Mask todo = alive;
    for (int i = 0; i < MOST_BORDERS && some(todo); ++i) {
        Ray ray = p.ray;
        Float passed = Float(0.0f);
        Hit hit = closest_there(world, numbers, layers, nanometres, todo, ray, passed, p.throughput);
        int last_layer = layers + DECISIONS_OF_LAYERS - 1;
        layers = DECISION_FLIGHT + depth * DECISIONS_OF_FLIGHT + DECISIONS_OF_FLIGHT / 2 + i * DECISIONS_OF_LAYERS;
        Mask met = both(todo, is_above(hit.object, Int(-1)));
        Float way = select(met, passed + hit.t, Float(FAR));
        Int volume = volume_of(world, p.media.first, todo);
        Mask filled = both(todo, is_above(volume, Int(-1)));
        if (some(filled)) {
            Flight f = fly(world, volume, p.ray.origin, direction, way, p.throughput, nanometres, numbers, filled, number);
            p.emission = select(filled, p.emission + p.throughput * f.emission, p.emission);
            p.throughput = select(filled, p.throughput * f.weight, p.throughput);
            p.position = select(f.scattered, p.ray.origin + direction * f.distance, p.position);
            p.before = select(f.scattered, p.before + f.distance, p.before);
            p.thinned = select(filled, p.thinned * f.thinned, p.thinned);
            p.extinction = select(f.scattered, f.extinction, p.extinction);
            p.phase = select(f.scattered, f.phase, p.phase);
            p.asymmetry = select(f.scattered, f.asymmetry, p.asymmetry);
            p.scattered = either(p.scattered, f.scattered);
            todo = without(without(todo, f.scattered), both(filled, is_black(p.throughput)));
            met = both(met, todo);
        }
        Crossing c = meet_border(world, ray, hit, p.media, nanometres, met);
        Mask crosses = both(met, c.open);
        Mask panes = both(crosses, c.pane);
        if (some(panes)) {
            Vec2 u = sample_pair(numbers, UInt(uint(last_layer)));
            panes = both(panes, u.x >= c.mirrored);
            crosses = either(without(crosses, c.pane), panes);
            p.throughput = select(panes, p.throughput * c.passes / max(Float(1.0f) - c.mirrored, Float(SMALLEST)), p.throughput);
        }
        Mask ends = without(met, crosses);
        p.hit.t = select(ends, hit.t, p.hit.t);
        p.hit.object = select(ends, hit.object, p.hit.object);
        p.hit.part = select(ends, hit.part, p.hit.part);
        p.hit.u = select(ends, hit.u, p.hit.u);
        p.hit.v = select(ends, hit.v, p.hit.v);
        p.passed = select(ends, passed, p.passed);
        p.ray.origin = select(ends, ray.origin, p.ray.origin);
        if (some(crosses)) {
            p.throughput = p.throughput * left_of_light(world, p.media.first, way, nanometres, crosses);
            p.media = select_media(crosses, crossed(world, p.media, c.material, c.inside, crosses), p.media);
            p.ray.origin = select(crosses, leave_surface(c.position, c.error, c.normal, direction), p.ray.origin);
            p.before = select(crosses, p.before + way, p.before);
        }
        todo = crosses;
    }
    p.lost = either(todo, both(alive, is_black(p.throughput)));
    return p;
}

// ---- Light ---------------------------------------------------------------------------------------------------------------------------------

// What share of light comes along each ray to its reach, from within `media`. Numbers from `decision` on. `thinned` becomes that of a path that flies
// there, see Flight.
FN_LARGE Spectrum passing_thinned(IN(WorldRecord) world, IN(Ray) shadow, IN(Media) media, Vec4 nanometres, IN(Sampler) numbers,
                                  UInt decision, Mask asking, INOUT(Spectrum) thinned) {
    Spectrum share = vec4_all(Float(1.0f));
    thinned = share;
    Media around = media;
    Ray ray = shadow;
    UInt number = decision;
    Mask todo = asking;
    for (int i = 0; i < MOST_BORDERS && some(todo); ++i) {
        Hit hit = closest_hit(world, ray, todo);
        Mask met = both(todo, is_above(hit.object, Int(-1)));
        Crossing c = meet_border(world, ray, hit, around, nanometres, met);
        Mask stops = without(met, c.open);
        share = select(both(met, c.pane), share * c.passes, share);
        if (world.has_cuts != 0 && some(stops)) {
            CutLayer layer = meet_layer(world, ray, hit, nanometres, stops);
            share = select(stops, share * passing_layer(layer), share);
            c.position = select(stops, layer.position, c.position);
            c.error = select(stops, layer.error, c.error);
            c.normal = select(stops, layer.normal, c.normal);
        } else {
            share = select(stops, black(), share);
        }
        todo = without(todo, is_black(share));
        met = both(met, todo);
        if (some(todo)) {
            Float way = select(met, hit.t, ray.reach);
            Int volume = volume_of(world, around.first, todo);
            Mask filled = both(todo, is_above(volume, Int(-1)));
            if (some(filled)) {
                share = share * transmittance_of_volume(world, volume, ray.origin, ray.direction, way, nanometres, numbers, filled, number,
                                                        thinned);
            }
            share = share * left_of_light(world, around.first, way, nanometres, both(todo, way < Float(FAR)));
            Vec3 next = leave_surface(c.position, c.error, c.normal, ray.direction);
            Mask far = ray.reach >= Float(FAR);
            Float reach = select(far, Float(FAR), ray.reach - dot(next - ray.origin, ray.direction));
            around = select_media(both(met, c.open), crossed(world, around, c.material, c.inside, met), around);
            ray.origin = select(met, next, ray.origin);
            ray.reach = select(met, reach, ray.reach);
            todo = without(both(met, ray.reach > Float(0.0f)), is_black(share));
        }
    }
    return select(todo, black(), share);
}

FN Spectrum passing_spectrum(IN(WorldRecord) world, IN(Ray) shadow, IN(Media) media, Vec4 nanometres, IN(Sampler) numbers, UInt decision,
                             Mask asking) {
    Spectrum thinned = vec4_all(Float(1.0f));
    return passing_thinned(world, shadow, media, nanometres, numbers, decision, asking, thinned);
}

NAMESPACE_END

#endif
