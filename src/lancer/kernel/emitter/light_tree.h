// A tree over the emitters that are near: a path goes down it, at each node to one of the two children, by about how much light they can send
// [Conty Estevez and Kulla 2018]. One random number is used all the way: what is left of it after a choice is stretched for the next one.
//
// It starts at one of the nodes of a cut (light_cut.h), which hold all emitters together.
#ifndef LANCER_KERNEL_EMITTER_LIGHT_TREE_H
#define LANCER_KERNEL_EMITTER_LIGHT_TREE_H

#include "lancer/kernel/emitter/light_cut.h"

NAMESPACE_BEGIN

struct EmitterChoice {
    Int emitter;  // -1: none can be seen
    Float chance;
};

FN Float tree_weight(IN(WorldRecord) world, Vec3 from, Vec3 facing) { return node_weight(same_node(world, 0), from, facing); }

// `chance`: of coming here.
FN EmitterChoice choose_in_tree(IN(WorldRecord) world, Vec3 from, Vec3 facing, Float u, Float chance, Mask mask) {
    EmitterChoice choice;
    choice.emitter = Int(-1);
    choice.chance = chance;
    Int node = Int(0);
    Float rest = u;
    TreeCut cut = cut_tree(world, from, facing, Int(-1), mask);
    Float goal = u * cut.sum;
    Float so_far = Float(0.0f);
    for (int i = 0; i < cut.count; ++i) {
        Float weight = cut.weight[i];
        Mask here = both(goal >= so_far, weight > Float(0.0f));  // the last one that qualifies
        node = select(here, cut.node[i], node);
        rest = select(here, (goal - so_far) / max(weight, Float(SMALLEST)), rest);
        choice.chance = select(here, chance * (weight / cut.sum), choice.chance);
        so_far = so_far + weight;
    }
    rest = min(max(rest, Float(0.0f)), Float(0.99999994f));
    Mask going = both(mask, cut.sum > Float(0.0f));
    while (some(going)) {
        Int child = child_of(world, node, going);
        Mask inner = both(going, is_above(child, Int(-1)));
        choice.emitter = select(without(going, inner), Int(-1) - child, choice.emitter);
        going = inner;
        if (some(going)) {
            Vec2 weights = child_weights(world, child, from, facing, going);
            Float sum = weights.x + weights.y;
            going = both(going, sum > Float(0.0f));  // else nothing of it can be seen
            Float share = weights.x / max(sum, Float(SMALLEST));
            Mask is_first = rest < share;
            Float own = select(is_first, share, weights.y / max(sum, Float(SMALLEST)));
            Float left = select(is_first, rest, rest - share) / max(own, Float(SMALLEST));
            rest = select(going, min(max(left, Float(0.0f)), Float(0.99999994f)), rest);
            choice.chance = select(going, choice.chance * own, choice.chance);
            node = select(going, select(is_first, child, child + Int(1)), node);
        }
    }
    choice.chance = select(is_above(choice.emitter, Int(-1)), choice.chance, Float(0.0f));
    return choice;
}

FN Float chance_in_tree(IN(WorldRecord) world, Vec3 from, Vec3 facing, Int emitter, Float chance, Mask mask) {
    Int way = gather_int(world.light_ways, emitter, mask);
    Mask going = both(mask, is_above(way, Int(-1)));
    Float result = Float(0.0f);
    Int node = Int(0);
    TreeCut cut = cut_tree(world, from, facing, way, going);
    for (int i = 0; i < cut.count; ++i) {
        Mask here = both(going, is_above(cut.way[i], Int(-1)));
        node = select(here, cut.node[i], node);
        way = select(here, cut.way[i], way);
        result = select(here, chance * (cut.weight[i] / max(cut.sum, Float(SMALLEST))), result);
    }
    going = both(going, result > Float(0.0f));
    while (some(going)) {
        Int child = child_of(world, node, going);
        going = both(going, is_above(child, Int(-1)));
        if (some(going)) {
            Vec2 weights = child_weights(world, child, from, facing, going);
            Float sum = max(weights.x + weights.y, Float(SMALLEST));
            Mask is_first = is_equal(way & Int(1), Int(0));
            result = select(going, result * (select(is_first, weights.x, weights.y) / sum), result);
            node = select(going, select(is_first, child, child + Int(1)), node);
            way = way >> 1;
            going = both(going, result > Float(0.0f));
        }
    }
    return result;
}

NAMESPACE_END

#endif
