// Paths from both ends: a path of light is followed from a lamp, one of importance from the camera; each vertex of either is joined to each of the
// other, to the lamps, and to the camera. All the ways in which the same path could have been found share it by the power heuristic [Veach 1997].
#ifndef LANCER_KERNEL_BIDIRECTIONAL_H
#define LANCER_KERNEL_BIDIRECTIONAL_H

#include "lancer/kernel/bidirectional/join.h"
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
        splat = join_camera(world, v, sub, light_paths, keeps, sub.path.alive, merging, tally);
        if (keeps) {
            keep_light_vertex(world, depth, v);
        }
        scatter_subpath(world, depth, true, met.surface.material, met.surface.inside, v, merging, sub);
    } else if (keeps) {
        v.valid = nowhere();
        keep_light_vertex(world, depth, v);
    }
    return splat;
}

// ---- Lamps and sky that are seen at once, or in mirrors and through smooth glass alone. --------------------------------------------------------
//
// Only the camera finds them, whatever is followed from the lamps; and what they need is edges without steps. So each sample of a path that is
// joined comes with some of these, which cost little.

const int GLANCES = 4;  // for each sample

FN Subpath start_glance(IN(WorldRecord) world, Float pixel_x, Float pixel_y, UInt key, UInt number, Mask alive) {
    return start_from_camera(world, pixel_x, pixel_y, scramble(key ^ UInt(0x4c4f4f4bu)), number, Float(1.0f), alive);
}

FN_LARGE void glance_step(IN(WorldRecord) world, int depth, INOUT(Subpath) sub, INOUT(RayTally) tally) {
    if (depth == 0) {
        tally.camera += lanes_in(sub.path.alive);
    } else {
        tally.secondary += lanes_in(sub.path.alive);
    }
    Meeting met;
    BidirVertex v;
    meet_vertex(world, depth, false, sub, met, v);
    Spectrum light = met.surface.emission;
    if (world.environment >= 0 && (depth > 0 || world.sky.visible != 0) && some(met.missed)) {
        light = select(met.missed, sky_radiance(world, sub.path.direction, sub.path.nanometres, met.missed), light);
    }
    sub.path.radiance =
        select(either(met.here, met.missed), sub.path.radiance + first_alone(sub.path.throughput * light, sub.single), sub.path.radiance);
    Mask matt = either(is_equal(v.closure.kind, Int(BSDF_DIFFUSE)), is_equal(v.closure.kind, Int(BSDF_ROUGH_DIFFUSE)));
    sub.path.alive = without(both(sub.path.alive, met.here), matt);
    if (depth >= world.max_depth) {
        sub.path.alive = nowhere();
    }
    if (some(sub.path.alive)) {
        scatter_subpath(world, depth, false, met.surface.material, met.surface.inside, v, no_merging(), sub);
        sub.path.alive = both(sub.path.alive, sub.straight);
    }
}

// ---- Light that the camera's half meets by itself. ------------------------------------------------------------------------------------------

FN Float weight_of_met(IN(Ways) before, Float asked, Float sent, Float cosine) {
    Float by_asking = before.meet * square_of_density(asked);
    Float by_light = before.join / square(cosine) * square_of_density(sent);
    return Float(1.0f) / (Float(1.0f) + by_asking + by_light);
}

// `before`: the ways to the ray that has met it.
FN void meet_sky_both_ways(IN(WorldRecord) world, IN(Ways) before, Mask missed, INOUT(Subpath) sub) {
    Spectrum sky = sky_radiance(world, sub.path.direction, sub.path.nanometres, missed);
    Float density = sky_density(world, sub.path.direction, missed);
    Float asked = emitter_chance(world, sub.path.origin, sub.path.facing, Int(world.environment), missed) * density;
    Float place = select(comes_through_disk(world, sub.path.origin, -sub.path.direction), scene_disk_density(world), Float(0.0f));
    Float sent = emission_chance(world, world.environment, missed) * place * density;
    Float weight = weight_of_met(before, asked, sent, Float(1.0f));
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
            weight = select(mine, weight_of_met(before, asked, sent, met.cosine), weight);
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
    Mask sky = without(met.missed, sub.straight);
    if (world.environment >= 0 && some(sky)) {
        meet_sky_both_ways(world, before, sky, sub);
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
            if (some(asking)) {
                if (world.emitter_count > 0) {
                    Vec2 choice = decide(sub.path, depth, DECISION_CHOICE);
                    Spectrum brought =
                        join_emitter(world, v, sub, choice.x, decide(sub.path, depth, DECISION_LIGHT), asking, merging, tally);
                    sub.path.radiance = sub.path.radiance + brought;
                }
                if (gathers) {
                    sub.path.radiance = sub.path.radiance + merge_photons(world, depth, v, field, merging, asking);
                }
                // As many scatterings as are allowed, these two among them.
                for (int i = 0; i < kept && i + depth + 2 <= world.max_depth; ++i) {
                    BidirVertex l = light_vertex(world, i);
                    Mask joined = both(asking, l.valid);
                    if (some(joined)) {
                        sub.path.radiance = sub.path.radiance + join_vertices(world, v, l, sub.path.nanometres, joined, merging, tally);
                    }
                }
            }
            scatter_subpath(world, depth, false, met.surface.material, met.surface.inside, v, merging, sub);
        }
    }
}

NAMESPACE_END

#endif
