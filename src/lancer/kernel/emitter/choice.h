// Which emitter is asked, seen from a point.
#ifndef LANCER_KERNEL_EMITTER_CHOICE_H
#define LANCER_KERNEL_EMITTER_CHOICE_H

#include "lancer/kernel/distribution.h"
#include "lancer/kernel/emitter/light_tree.h"
#include "lancer/kernel/emitter/thrown.h"
#include "lancer/kernel/light.h"

NAMESPACE_BEGIN

// About the irradiance that the emitter can make at a point: what the choice among emitters is weighed by. Never 0 where light arrives. `facing` is
// the normal there, length 1, of a surface that takes no light from behind; 0: from anywhere.
FN Float emitter_weight(IN(EmitterRecord) emitter, Vec3 from, Vec3 facing) {
    Float weight = Float(emitter.strength);
    if (emitter.kind != EMITTER_ENVIRONMENT) {
        Vec3 towards = broadcast(-emitter.direction);
        Float radius = Float(0.0f);
        Float distance = Float(1.0f);
        if (emitter.kind != EMITTER_DIRECTIONAL) {
            radius = Float(emitter.radius);
            towards = broadcast(emitter.middle) - from;
            Float distance_2 = max(max(dot(towards, towards), radius * radius), Float(SMALLEST));
            distance = sqrt(distance_2);
            weight = weight / distance_2;
        }
        // From the surface's side at most this much of the emitter is seen, at most this steep; roughly, but for what is wholly behind.
        Float rises = clamp01((dot(towards, facing) + radius) / distance);
        Mask sided = dot(facing, facing) > Float(0.5f);
        Float seen = select(rises > Float(0.0f), max(rises, Float(LEAST_SLANT)), Float(0.0f));
        weight = select(sided, weight * seen, weight);
        if (emitter.kind == EMITTER_SPOT) {
            Float cosine = -dot(towards, broadcast(emitter.direction)) / distance;
            weight = weight * spot_share(cosine, emitter.cos_outer, emitter.cos_inner, emitter.fade);
        }
        if (is_thrown(emitter)) {
            Float cosine = -dot(towards, broadcast(emitter.direction)) / distance;
            weight = select(cosine < Float(emitter.cos_outer), Float(0.0f), weight);
        }
        if (emitter.planar != 0) {
            // Nothing reaches points in its plane, or behind it; those near the plane see little of it.
            Float slant = -dot(towards, broadcast(emitter.direction)) / distance;
            slant = emitter.two_sided != 0 ? abs(slant) : slant;
            weight = select(slant > Float(0.0f), weight * max(slant, Float(LEAST_SLANT)), Float(0.0f));
        }
    }
    return weight;
}

// Those that are so few that each is looked at.
FN EmitterChoice choose_among_few(IN(WorldRecord) world, Vec3 from, Vec3 facing, Float u) {
    EmitterChoice choice;
    choice.emitter = Int(-1);
    choice.chance = Float(0.0f);
    if (world.emitter_count == 1) {
        Mask seen = emitter_weight(AT(world.emitters, 0), from, facing) > Float(0.0f);
        choice.emitter = select(seen, Int(0), Int(-1));
        choice.chance = select(seen, Float(1.0f), Float(0.0f));
    } else {
        Float sum = Float(0.0f);
        for (int i = 0; i < world.emitter_count; ++i) {
            sum = sum + emitter_weight(AT(world.emitters, i), from, facing);
        }
        Float goal = u * sum;
        Float so_far = Float(0.0f);
        for (int i = 0; i < world.emitter_count; ++i) {
            Float weight = emitter_weight(AT(world.emitters, i), from, facing);
            Mask here = both(goal >= so_far, weight > Float(0.0f));  // the last one that qualifies
            choice.emitter = select(here, Int(i), choice.emitter);
            choice.chance = select(here, weight / sum, choice.chance);
            so_far = so_far + weight;
        }
    }
    return choice;
}

FN Float chance_among_few(IN(WorldRecord) world, Vec3 from, Vec3 facing, Int emitter) {
    Float chance = Float(0.0f);
    if (world.emitter_count == 1) {
        chance = select(emitter_weight(AT(world.emitters, 0), from, facing) > Float(0.0f), Float(1.0f), Float(0.0f));
    } else {
        Float sum = Float(0.0f);
        Float own = Float(0.0f);
        for (int i = 0; i < world.emitter_count; ++i) {
            Float weight = emitter_weight(AT(world.emitters, i), from, facing);
            sum = sum + weight;
            own = select(is_equal(emitter, Int(i)), weight, own);
        }
        chance = select(sum > Float(0.0f), own / max(sum, Float(SMALLEST)), Float(0.0f));
    }
    return chance;
}

FN EmitterChoice choose_emitter(IN(WorldRecord) world, Vec3 from, Vec3 facing, Float u, Mask mask) {
    EmitterChoice choice;
    if (world.has_tree == 0) {
        choice = choose_among_few(world, from, facing, u);
    } else if (world.far_count == 0) {
        choice = choose_in_tree(world, from, facing, u, Float(1.0f), mask);
    } else {
        // The far ones one by one, all near ones together; then down the tree with what is left of the number.
        Float near = tree_weight(world, from, facing);
        Float sum = near;
        for (int i = 0; i < world.far_count; ++i) {
            sum = sum + emitter_weight(AT(world.emitters, i), from, facing);
        }
        Float goal = u * sum;
        Mask descends = both(both(mask, goal < near), near > Float(0.0f));
        choice = choose_in_tree(world, from, facing, min(goal / max(near, Float(SMALLEST)), Float(0.99999994f)),
                                near / max(sum, Float(SMALLEST)), descends);
        Float so_far = near;
        Mask is_far = without(mask, descends);
        for (int i = 0; i < world.far_count; ++i) {
            Float weight = emitter_weight(AT(world.emitters, i), from, facing);
            Mask here = both(is_far, both(goal >= so_far, weight > Float(0.0f)));
            choice.emitter = select(here, Int(i), choice.emitter);
            choice.chance = select(here, weight / sum, choice.chance);
            so_far = so_far + weight;
        }
    }
    return choice;
}

FN Float emitter_chance(IN(WorldRecord) world, Vec3 from, Vec3 facing, Int emitter, Mask mask) {
    Float chance = Float(0.0f);
    if (world.has_tree == 0) {
        chance = chance_among_few(world, from, facing, emitter);
    } else {
        Float near = Float(1.0f);
        Float sum = Float(1.0f);
        if (world.far_count > 0) {
            near = tree_weight(world, from, facing);
            sum = near;
            Float own = Float(0.0f);
            for (int i = 0; i < world.far_count; ++i) {
                Float weight = emitter_weight(AT(world.emitters, i), from, facing);
                sum = sum + weight;
                own = select(is_equal(emitter, Int(i)), weight, own);
            }
            chance = own / max(sum, Float(SMALLEST));
        }
        Mask in_tree = both(mask, both(is_above(emitter, Int(world.far_count - 1)), near > Float(0.0f)));
        if (some(in_tree)) {
            chance = select(in_tree, chance_in_tree(world, from, facing, emitter, near / max(sum, Float(SMALLEST)), in_tree), chance);
        }
    }
    return chance;
}

NAMESPACE_END

#endif
