// Lamps and sky that are seen at once, or in mirrors and through smooth glass alone.
//
// Where mirrors or glass are on the way only the camera finds them, whatever is followed from the lamps; and what they need is edges without steps. So
// each sample of a path that is joined comes with some of these, which cost little. A lamp that is seen at once is found by paths of light, too, however
// small it looks.
#ifndef LANCER_KERNEL_BIDIRECTIONAL_GLANCE_H
#define LANCER_KERNEL_BIDIRECTIONAL_GLANCE_H

#include "lancer/kernel/bidirectional/join.h"

NAMESPACE_BEGIN

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

NAMESPACE_END

#endif
