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

// ---- Lamps and sky that are seen at once, or in mirrors and through smooth glass alone. --------------------------------------------------------
//
// Where mirrors or glass are on the way only the camera finds them, whatever is followed from the lamps; and what they need is edges without steps. So
// each sample of a path that is joined comes with some of these, which cost little. A lamp that is seen at once is found by paths of light, too, however
// small it looks.

// Of lamps that a glance has met: how much of them is left to it.
FN Float weight_of_glance(IN(WorldRecord) world, IN(Subpath) sub, IN(Meeting) met, Mask shining) {
    Float weight = Float(1.0f);
    Float reached = met.cosine * camera_density(world.camera, sub.path.direction) * Float(float(GLANCES));
    reached = select(is_parallel(world.camera), reached, reached / max(met.distance * met.distance, Float(SMALLEST)));
    Mask todo = both(shining, is_above(met.surface.emitter, Int(-1)));
    while (some(todo)) {
        int number = first_of(met.surface.emitter, todo);
        Mask mine = both(todo, is_equal(met.surface.emitter, Int(number)));
        EmitterRecord emitter = AT(world.emitters, number);
        Float sides = Float(emitter.two_sided != 0 ? 2.0f : 1.0f);
        Float place = place_density(world, emitter, met.surface.point, met.part, mine);
        Float sent = Float(world.camera.width * world.camera.height) * emission_chance(world, number, mine) * place / sides;
        Float by_light = square_of_density(sent / max(reached, Float(SMALLEST)));
        weight = select(mine, Float(1.0f) / (Float(1.0f) + by_light), weight);
        todo = without(todo, mine);
    }
    return weight;
}

FN Subpath start_glance(IN(WorldRecord) world, Float pixel_x, Float pixel_y, UInt key, UInt number, Mask alive) {
    return start_from_camera(world, pixel_x, pixel_y, scramble(key ^ UInt(0x4c4f4f4bu)), number, Float(1.0f), alive);
}

// Glass sends back few of the rays that it meets, but the mirror image of a bright lamp may outshine all else. So of each two glances one looks only into
// the mirror of the first smooth border that they meet, and the other only through it. Which part of the material that is, 0 or nearly 1.
FN Float one_of_both_ways(bool into_mirror, Float drawn, IN(BidirVertex) v, INOUT(Subpath) sub) {
    Float part = drawn;
    Mask border = both(sub.path.alive, is_equal(v.closure.kind, Int(BSDF_DIELECTRIC)));
    border = without(border, is_rough_border(v.closure));
    if (some(border)) {
        Float chance = mean(border_share(v.closure, v.wo.z));
        border = both(border, both(chance > Float(0.0f), chance < Float(0.999f)));
        Float share = chance;
        Float end = Float(0.0f);
        if (!into_mirror) {
            share = Float(1.0f) - chance;
            end = Float(0.99999994f);
        }
        part = select(border, end, part);
        sub.path.throughput = select(border, sub.path.throughput * (share * Float(2.0f)), sub.path.throughput);
    }
    return part;
}

// `number`: of the glance.
FN_LARGE void glance_step(IN(WorldRecord) world, int depth, int number, INOUT(Subpath) sub, INOUT(RayTally) tally) {
    if (depth == 0) {
        tally.camera += lanes_in(sub.path.alive);
    } else {
        tally.secondary += lanes_in(sub.path.alive);
    }
    Meeting met;
    BidirVertex v;
    meet_vertex(world, depth, false, sub, met, v);
    Spectrum light = met.surface.emission;
    if (depth == 0 && some(met.here)) {
        Mask shining = without(met.here, is_black(light));
        if (some(shining)) {
            light = light * weight_of_glance(world, sub, met, shining);
        }
    }
    if (world.environment >= 0 && (depth > 0 || world.sky.visible != 0) && some(met.missed)) {
        light = select(met.missed, sky_radiance(world, sub.path.direction, sub.path.nanometres, met.missed), light);
    }
    sub.path.radiance =
        select(either(met.here, met.missed), sub.path.radiance + first_alone(sub.path.throughput * light, sub.single), sub.path.radiance);
    Mask matt = either(is_equal(v.closure.kind, Int(BSDF_DIFFUSE)), is_equal(v.closure.kind, Int(BSDF_ROUGH_DIFFUSE)));
    sub.path.alive = without(without(both(sub.path.alive, met.here), matt), v.floats);
    if (depth >= world.max_depth) {
        sub.path.alive = nowhere();
    }
    if (some(sub.path.alive)) {
        Vec2 choice = decide(sub.path, depth, DECISION_CHOICE);
        Float part = choice.y;
        if (depth == 0) {
            part = one_of_both_ways(number % 2 == 0, part, v, sub);
        }
        scatter_subpath(world, depth, false, part, v, no_merging(), sub);
        sub.path.alive = both(sub.path.alive, sub.straight);
    }
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

NAMESPACE_END

#endif
