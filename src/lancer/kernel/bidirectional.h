// Paths from both ends: a path of light is followed from a lamp, one of importance from the camera; each vertex of either is joined to each of the
// other, to the lamps, and to the camera. All the ways in which the same path could have been found share it by the power heuristic [Veach 1997].
#ifndef LANCER_KERNEL_BIDIRECTIONAL_H
#define LANCER_KERNEL_BIDIRECTIONAL_H

#include "lancer/kernel/bidirectional/glance.h"
#include "lancer/kernel/bidirectional/merge.h"
#include "lancer/kernel/outcome.h"

NAMESPACE_BEGIN

// The vertex of a path of light after `depth` others: it is kept, and the camera may see it. `keeps`: false where no path from the camera follows.
FN_LARGE FilmSplat light_step(IN(WorldRecord) world, int depth, Float light_paths, bool keeps, IN(LightStart) start,
                              IN(MergeWeights) merging, INOUT(Subpath) sub, INOUT(RayTally) tally) {
    tally.secondary += lanes_in(sub.path.alive);
    Meeting met;
    BidirVertex v;
    meet_vertex(world, depth, true, sub, met, v);
    FilmSplat splat = no_splat();
    if (depth >= world.max_depth) {
        v.valid = nowhere();
        sub.path.alive = nowhere();
    }
    if (some(sub.path.alive)) {
        if (depth == 0) {
            sub.ways = ways_of_first_light(world, start, met, v, merging);
            v.ways = sub.ways;
        }
        splat = join_camera(world, depth, v, sub, light_paths, keeps, sub.path.alive, merging, tally);
        if (keeps) {
            keep_light_vertex(world, depth, v);
        }
        Vec2 choice = decide(sub.path, depth, DECISION_CHOICE);
        scatter_subpath(world, depth, true, choice.y, v, merging, sub);
    } else if (keeps) {
        v.valid = nowhere();
        keep_light_vertex(world, depth, v);
    }
    return splat;
}

// ---- Light that the camera's half meets by itself. ------------------------------------------------------------------------------------------

// `sent`: the density with which light is sent back along the ray.
FN Float weight_of_met(IN(Ways) before, IN(Meeting) met, Float asked, Float sent) {
    Float by_asking = before.meet * square_of_density(asked / met.thinned);
    Float by_light = before.join * square_of_density(sent * met.leaves / met.cosine);
    return Float(1.0f) / (Float(1.0f) + by_asking + by_light);
}

// `before`: the ways to the ray that has met it.
FN void meet_sky_both_ways(IN(WorldRecord) world, IN(Ways) before, IN(Meeting) met, Mask missed, INOUT(Subpath) sub) {
    Spectrum sky = sky_radiance(world, sub.path.direction, sub.path.nanometres, missed);
    Float density = sky_density(world, sub.path.direction, missed);
    Float asked = emitter_chance(world, sub.path.origin, sub.path.facing, Int(world.environment), missed) * density;
    Float place = select(comes_through_disk(world, sub.path.origin, -sub.path.direction), scene_disk_density(world), Float(0.0f));
    Float sent = emission_chance(world, world.environment, missed) * place * density;
    Float weight = weight_of_met(before, met, asked, sent);
    Spectrum brought = first_alone(sub.path.throughput * sky * weight, sub.single);
    sub.path.radiance = select(missed, sub.path.radiance + brought, sub.path.radiance);
}

FN void meet_lamp_both_ways(IN(WorldRecord) world, IN(Ways) before, IN(Meeting) met, Mask shining, INOUT(Subpath) sub) {
    Float weight = Float(1.0f);
    Mask compared = both(shining, is_above(met.surface.emitter, Int(-1)));
    if (some(compared)) {
        Float chance = emitter_chance(world, sub.path.origin, sub.path.facing, met.surface.emitter, compared);
        Mask todo = compared;
        while (some(todo)) {
            int number = first_of(met.surface.emitter, todo);
            Mask mine = both(todo, is_equal(met.surface.emitter, Int(number)));
            EmitterRecord emitter = AT(world.emitters, number);
            Float asked = chance * emitter_density(world, emitter, sub.path.origin, sub.path.direction, met.surface.point, met.part, mine);
            EmissionDensity back = emission_density(world, emitter, met.surface.point, -sub.path.direction, sub.path.origin,
                                                    place_density(world, emitter, met.surface.point, met.part, mine), mine);
            Float sent = back.place * back.direction * emission_chance(world, number, mine);
            weight = select(mine, weight_of_met(before, met, asked, sent), weight);
            todo = without(todo, mine);
        }
    }
    Spectrum brought = first_alone(sub.path.throughput * met.surface.emission * weight, sub.single);
    sub.path.radiance = select(shining, sub.path.radiance + brought, sub.path.radiance);
}

// The vertex of a path from the camera after `depth` others: what it meets but for what glances see, what it asks for, and its joints with the `kept` vertices of the same lane's path of light. The light
// found so far is `sub.path.radiance`. `gathers`: whether photons are merged.
FN_LARGE void camera_step(IN(WorldRecord) world, int depth, int kept, bool gathers, IN(PhotonField) field, IN(MergeWeights) merging,
                          INOUT(Subpath) sub, INOUT(RayTally) tally) {
    if (depth == 0) {
        tally.camera += lanes_in(sub.path.alive);
    } else {
        tally.secondary += lanes_in(sub.path.alive);
    }
    Ways before = sub.ways;
    Meeting met;
    BidirVertex v;
    meet_vertex(world, depth, false, sub, met, v);
    if (world.has_media != 0) {
        sub.path.radiance = sub.path.radiance + first_alone(met.glow, sub.single);
    }
    Mask sky = without(met.missed, sub.straight);
    if (world.environment >= 0 && some(sky)) {
        meet_sky_both_ways(world, before, met, sky, sub);
    }
    if (some(met.here)) {
        Mask shining = without(without(met.here, sub.straight), is_black(met.surface.emission));
        if (some(shining)) {
            meet_lamp_both_ways(world, before, met, shining, sub);
        }
        if (depth >= world.max_depth) {
            sub.path.alive = nowhere();
        }
        if (some(sub.path.alive)) {
            Mask asking = both(sub.path.alive, v.valid);
            Vec2 choice = decide(sub.path, depth, DECISION_CHOICE);
            if (some(asking)) {
                if (world.emitter_count > 0) {
                    Spectrum brought =
                        join_emitter(world, depth, v, sub, choice.x, decide(sub.path, depth, DECISION_LIGHT), asking, merging, tally);
                    sub.path.radiance = sub.path.radiance + brought;
                }
                if (gathers) {
                    sub.path.radiance = sub.path.radiance + merge_photons(world, depth, v, field, merging, without(asking, v.floats));
                }
                // As many scatterings as are allowed, these two among them.
                for (int i = 0; i < kept && i + depth + 2 <= world.max_depth; ++i) {
                    BidirVertex l = light_vertex(world, i);
                    Mask joined = both(asking, l.valid);
                    if (some(joined)) {
                        Sampler numbers = joint_numbers(sub.path.numbers, depth, i);
                        sub.path.radiance =
                            sub.path.radiance + join_vertices(world, v, l, sub.path.nanometres, numbers, joined, merging, tally);
                    }
                }
            }
            scatter_subpath(world, depth, false, choice.y, v, merging, sub);
        }
    }
}

// ---- The whole of one sample. ---------------------------------------------------------------------------------------------------------------

// The device adds light to the film where `splat.valid`, weighed by each pixel's filter.
FN void put_splat(IN(WorldRecord) world, IN(FilmSplat) splat, Vec4 nanometres);

FN void put_if_sound(IN(WorldRecord) world, IN(FilmSplat) splat, Vec4 nanometres, INOUT(Mask) sound) {
    Mask good = is_sound(splat.light);
    sound = without(sound, without(splat.valid, good));
    FilmSplat put = splat;
    put.valid = both(splat.valid, good);
    put_splat(world, put, nanometres);
}

// One sample of a pixel, with the path of light that belongs to it.
struct PixelSample {
    Float x;  // of the pixel
    Float y;
    UInt key;
    UInt number;  // of the sample
    UInt light;   // of the path of light
    Mask mask;
};

// The number of the path of light that belongs to a sample of a pixel.
FN UInt path_of_light(IN(WorldRecord) world, UInt x, UInt y, UInt number) {
    UInt width = UInt(uint(world.camera.width));
    return number * (width * UInt(uint(world.camera.height))) + y * width + x;
}

FN Float light_paths(IN(WorldRecord) world) { return Float(world.camera.width * world.camera.height); }

// Puts the path of light on the film; returns how many of its vertices are kept. `sound` loses those whose light is no number.
FN_LARGE int follow_light(IN(WorldRecord) world, IN(PixelSample) one, Vec4 nanometres, bool keeps, IN(MergeWeights) merging,
                          INOUT(Mask) sound, INOUT(RayTally) tally) {
    LightStart start;
    Subpath lit = start_from_light(world, one.light, nanometres, one.mask, start);
    FilmSplat splat = join_light_to_camera(world, start, lit, light_paths(world), keeps, tally);
    put_if_sound(world, splat, nanometres, sound);
    int kept = 0;
    while (some(lit.path.alive)) {
        splat = light_step(world, kept, light_paths(world), keeps, start, merging, lit, tally);
        put_if_sound(world, splat, nanometres, sound);
        ++kept;
    }
    return kept;
}

// What the camera's half, joined with the `kept` vertices of light's, and glances bring to the pixel, as linear RGB.
FN_LARGE Vec3 follow_camera(IN(WorldRecord) world, IN(PixelSample) one, int kept, bool gathers, IN(PhotonField) field,
                            IN(MergeWeights) merging, INOUT(Subpath) camera, INOUT(Mask) sound, INOUT(RayTally) tally) {
    for (int depth = 0; some(camera.path.alive); ++depth) {
        camera_step(world, depth, kept, gathers, field, merging, camera, tally);
    }
    sound = both(sound, is_sound(camera.path.radiance));
    Vec3 rgb = light_in_pixel(world, camera.path, camera.path.radiance, one.mask);
    for (int i = 0; i < GLANCES; ++i) {
        UInt number = one.number * UInt(uint(GLANCES)) + UInt(uint(i));
        Subpath glance = start_glance(world, one.x, one.y, one.key, number, one.mask);
        for (int depth = 0; some(glance.path.alive); ++depth) {
            glance_step(world, depth, i, glance, tally);
        }
        sound = both(sound, is_sound(glance.path.radiance));
        rgb = rgb + light_in_pixel(world, glance.path, glance.path.radiance, one.mask) * Float(1.0f / float(GLANCES));
    }
    return rgb;
}

NAMESPACE_END

#endif
