// Where the two halves of a path begin: at the camera, and at a light.
#ifndef LANCER_KERNEL_BIDIRECTIONAL_START_H
#define LANCER_KERNEL_BIDIRECTIONAL_START_H

#include "lancer/kernel/bidirectional/subpath.h"

NAMESPACE_BEGIN

// `light_paths`: how many paths of light there are for each sample of every pixel.
FN Subpath start_from_camera(IN(WorldRecord) world, Float pixel_x, Float pixel_y, UInt key, UInt sample_number, Float light_paths,
                             Mask alive) {
    Subpath sub;
    sub.path = start_path(world, pixel_x, pixel_y, key, sample_number, alive);
    sub.ways = no_ways();
    sub.ways.meet = square(light_paths / camera_density(world.camera, sub.path.direction));
    sub.thick = vec4_all(Float(1.0f));
    sub.start = Float(1.0f);
    sub.single = nowhere();
    sub.parallel = is_parallel(world.camera);
    sub.straight = all_or_none(true);
    return sub;
}

// What the first vertex needs to know of the light.
struct LightStart {
    EmissionSample emission;
    Int emitter;
    Float chance;  // with which the emitter was chosen
};

FN Sampler light_numbers(IN(WorldRecord) world, UInt number) {
    return start_sampler(scramble(scramble(UInt(uint(world.seed))) ^ UInt(0x4c494748u)), number);
}

// The path of light with that number. Alive where there is light.
FN Subpath start_from_light(IN(WorldRecord) world, UInt number, Vec4 nanometres, Mask alive, INOUT(LightStart) start) {
    Subpath sub;
    sub.path.numbers = light_numbers(world, number);
    Vec2 choice = sample_pair(sub.path.numbers, UInt(uint(DECISION_EMISSION)));
    Vec2 place = sample_pair(sub.path.numbers, UInt(uint(DECISION_EMISSION_PLACE)));
    Vec2 way = sample_pair(sub.path.numbers, UInt(uint(DECISION_EMISSION_WAY)));
    EmissionChoice chosen = choose_emission(world, choice.x, alive);
    start.emitter = chosen.emitter;
    start.chance = chosen.chance;
    start.emission.point = no_surface();
    start.emission.direction = vec3_of(Float(0.0f), Float(1.0f), Float(0.0f));
    start.emission.light = black();
    start.emission.cosine = Float(1.0f);
    start.emission.density.place = Float(1.0f);
    start.emission.density.direction = Float(1.0f);
    start.emission.discrete = nowhere();
    start.emission.far = nowhere();
    start.emission.valid = nowhere();
    Mask todo = both(alive, both(is_above(chosen.emitter, Int(-1)), chosen.chance > Float(0.0f)));
    while (some(todo)) {
        int emitter = first_of(chosen.emitter, todo);
        Mask mine = both(todo, is_equal(chosen.emitter, Int(emitter)));
        EmissionSample s = emission_sample(world, AT(world.emitters, emitter), place, way, choice.y, nanometres, mine);
        start.emission.point.position = select(mine, s.point.position, start.emission.point.position);
        start.emission.point.error = select(mine, s.point.error, start.emission.point.error);
        start.emission.point.normal = select(mine, s.point.normal, start.emission.point.normal);
        start.emission.direction = select(mine, s.direction, start.emission.direction);
        start.emission.light = select(mine, s.light, start.emission.light);
        start.emission.cosine = select(mine, s.cosine, start.emission.cosine);
        start.emission.density.place = select(mine, s.density.place, start.emission.density.place);
        start.emission.density.direction = select(mine, s.density.direction, start.emission.density.direction);
        start.emission.discrete = select_mask(mine, s.discrete, start.emission.discrete);
        start.emission.far = select_mask(mine, s.far, start.emission.far);
        start.emission.valid = select_mask(mine, s.valid, start.emission.valid);
        todo = without(todo, mine);
    }
    sub.path.origin =
        leave_surface(start.emission.point.position, start.emission.point.error, start.emission.point.normal, start.emission.direction);
    sub.path.direction = start.emission.direction;
    sub.path.throughput = start.emission.light / max(start.chance, Float(SMALLEST));
    if (world.plane_count > 0 || world.surrounding_volume >= 0) {
        // Infinite planes, or air, may have been in the way before.
        Mask far = both(start.emission.valid, start.emission.far);
        Ray back;
        back.origin = sub.path.origin;
        back.direction = -start.emission.direction;
        back.reach = Float(FAR);
        if (world.has_media != 0) {
            Spectrum share =
                passing_spectrum(world, back, no_media(), nanometres, sub.path.numbers, UInt(uint(DECISION_DIMMING_BEFORE)), far);
            sub.path.throughput = select(far, sub.path.throughput * share, sub.path.throughput);
        } else {
            Spectrum passes = passing_light(world, back, nanometres, far);
            sub.path.throughput = select(far, sub.path.throughput * passes, sub.path.throughput);
        }
    }
    sub.path.radiance = black();
    sub.path.weight = Float(1.0f);
    sub.path.nanometres = nanometres;
    sub.path.facing = vec3_all(Float(0.0f));
    sub.path.density = Float(0.0f);
    sub.path.squeeze = Float(1.0f);
    sub.path.width = Float(0.0f);
    sub.path.spread = Float(0.0f);
    sub.path.scattered = UInt(0u);
    sub.path.media = no_media();
    if (world.has_media != 0) {
        sub.path.throughput.w = sub.path.throughput.w * Float(world.spectral != 0 ? 1.0f : 0.0f);
        sub.path.media = media_around(world, sub.path.origin, sub.path.direction, both(alive, start.emission.valid));
    }
    sub.path.alive = without(both(alive, start.emission.valid), is_black(sub.path.throughput));
    sub.ways = no_ways();
    sub.thick = vec4_all(Float(1.0f));
    sub.start = largest(sub.path.throughput);
    sub.single = nowhere();
    sub.parallel = start.emission.far;
    sub.straight = all_or_none(true);
    return sub;
}

// At the first vertex of a path of light: how else its first piece could have been found, by asking the emitter from here, and by meeting it. The
// choice among emitters that are asked depends on where one asks.
FN Ways ways_of_first_light(IN(WorldRecord) world, IN(LightStart) start, IN(Meeting) met, IN(BidirVertex) v, IN(MergeWeights) merging) {
    Ways w;
    Vec3 facing = select(is_opaque(v.closure), v.normal, vec3_all(Float(0.0f)));
    Float chosen = emitter_chance(world, v.position, facing, start.emitter, met.here);
    Float asked = start.emission.density.place;
    Mask todo = both(met.here, is_above(start.emitter, Int(-1)));
    while (some(todo)) {
        int number = first_of(start.emitter, todo);
        Mask mine = both(todo, is_equal(start.emitter, Int(number)));
        EmitterRecord emitter = AT(world.emitters, number);
        if (emitter.kind == EMITTER_SPHERE || emitter.kind == EMITTER_TRIANGLE || emitter.kind == EMITTER_MESH_TRIANGLE ||
            is_pair(emitter)) {
            // What is seen large is asked by the directions that it fills.
            Float by_angle = emitter_density(world, emitter, v.position, -start.emission.direction, start.emission.point, Int(0), mine);
            asked = select(mine, by_angle * start.emission.cosine / max(met.distance * met.distance, Float(SMALLEST)), asked);
        }
        todo = without(todo, mine);
    }
    Float distance_2 = met.distance * met.distance;
    Float near =
        chosen * asked * distance_2 / (start.chance * start.emission.density.place * start.emission.density.direction * met.cosine);
    Float far = chosen / (start.chance * start.emission.density.place * met.cosine);
    w.meet = square(min(select(start.emission.far, far, near), Float(1.0e9f)));
    Float met_by_chance =
        start.emission.cosine / (start.chance * start.emission.density.place * start.emission.density.direction * met.cosine);
    w.join = select(start.emission.discrete, Float(0.0f), square(min(met_by_chance, Float(1.0e9f))));
    w.merge = w.join * merging.join;
    return limited_ways(w);
}

NAMESPACE_END

#endif
