// Which emitter is asked, seen from a point.
#ifndef LANCER_KERNEL_EMITTER_CHOICE_H
#define LANCER_KERNEL_EMITTER_CHOICE_H

#include "lancer/kernel/distribution.h"

NAMESPACE_BEGIN

// About the irradiance that the emitter can make at a point: what the choice among emitters is weighed by. Never 0 where light arrives.
FN Float emitter_weight(IN(EmitterRecord) emitter, Vec3 from) {
    Float weight = Float(emitter.strength);
    if (emitter.kind != EMITTER_DIRECTIONAL && emitter.kind != EMITTER_ENVIRONMENT) {
        Vec3 way = from - broadcast(emitter.middle);
        Float radius_2 = Float(emitter.radius * emitter.radius);
        weight = weight / max(max(dot(way, way), radius_2), Float(SMALLEST));
        if (emitter.kind == EMITTER_TRIANGLE && emitter.two_sided == 0) {
            // Nothing reaches points behind its plane; those near the plane see little of it.
            Float height = dot(way, broadcast(emitter.direction));
            Float slant = height / sqrt(max(max(dot(way, way), radius_2), Float(SMALLEST)));
            weight = select(height > Float(0.0f), weight * max(slant, Float(0.05f)), Float(0.0f));
        }
    }
    return weight;
}

struct EmitterChoice {
    Int emitter;  // -1: none can be seen
    Float chance;
};

FN EmitterChoice choose_emitter(IN(WorldRecord) world, Vec3 from, Float u, Mask mask) {
    EmitterChoice choice;
    choice.emitter = Int(-1);
    choice.chance = Float(0.0f);
    if (world.chosen_by_strength != 0) {
        choice.emitter = find_share(world, 0, world.emitter_count, u, mask);
        choice.chance = own_share(world, 0, choice.emitter, mask);
    } else if (world.emitter_count == 1) {
        Mask seen = emitter_weight(AT(world.emitters, 0), from) > Float(0.0f);
        choice.emitter = select(seen, Int(0), Int(-1));
        choice.chance = select(seen, Float(1.0f), Float(0.0f));
    } else {
        Float sum = Float(0.0f);
        for (int i = 0; i < world.emitter_count; ++i) {
            sum = sum + emitter_weight(AT(world.emitters, i), from);
        }
        Float goal = u * sum;
        Float so_far = Float(0.0f);
        for (int i = 0; i < world.emitter_count; ++i) {
            Float weight = emitter_weight(AT(world.emitters, i), from);
            Mask here = both(goal >= so_far, weight > Float(0.0f));  // the last one that qualifies
            choice.emitter = select(here, Int(i), choice.emitter);
            choice.chance = select(here, weight / sum, choice.chance);
            so_far = so_far + weight;
        }
    }
    return choice;
}

FN Float emitter_chance(IN(WorldRecord) world, Vec3 from, Int emitter, Mask mask) {
    Float chance = Float(0.0f);
    if (world.chosen_by_strength != 0) {
        chance = own_share(world, 0, select(is_above(emitter, Int(-1)), emitter, Int(0)), mask);
    } else if (world.emitter_count == 1) {
        chance = select(emitter_weight(AT(world.emitters, 0), from) > Float(0.0f), Float(1.0f), Float(0.0f));
    } else {
        Float sum = Float(0.0f);
        Float own = Float(0.0f);
        for (int i = 0; i < world.emitter_count; ++i) {
            Float weight = emitter_weight(AT(world.emitters, i), from);
            sum = sum + weight;
            own = select(is_equal(emitter, Int(i)), weight, own);
        }
        chance = select(sum > Float(0.0f), own / max(sum, Float(SMALLEST)), Float(0.0f));
    }
    return chance;
}

NAMESPACE_END

#endif
