// A tree over the emitters that are near: a path goes down it, at each node to one of the two children, by about how much light they can send
// [Conty Estevez and Kulla 2018]. One random number is used all the way: what is left of it after a choice is stretched for the next one.
#ifndef LANCER_KERNEL_EMITTER_LIGHT_TREE_H
#define LANCER_KERNEL_EMITTER_LIGHT_TREE_H

#include "lancer/kernel/math.h"
#include "lancer/kernel/tables.h"

NAMESPACE_BEGIN

const float NEAREST_2 = 1.0f / 6.0f;  // see node_weight
const float LEAST_SLANT = 0.05f;      // what a mirror makes of a grazing lamp is not weighed too low

struct EmitterChoice {
    Int emitter;  // -1: none can be seen
    Float chance;
};

struct LightNode {
    Vec3 middle;
    Float radius;
    Vec3 axis;
    Float cos_spread;
    Float cos_reach;
    Float power;
    Float twofold;
};

FN LightNode same_node(IN(WorldRecord) world, int node) {
    int at = node * NODE_SIZE;
    LightNode n;
    n.middle = vec3_of(Float(AT(world.light_nodes, at)), Float(AT(world.light_nodes, at + 1)), Float(AT(world.light_nodes, at + 2)));
    n.radius = Float(AT(world.light_nodes, at + NODE_RADIUS));
    n.axis = vec3_of(Float(AT(world.light_nodes, at + NODE_AXIS)), Float(AT(world.light_nodes, at + NODE_AXIS + 1)),
                     Float(AT(world.light_nodes, at + NODE_AXIS + 2)));
    n.cos_spread = Float(AT(world.light_nodes, at + NODE_SPREAD));
    n.cos_reach = Float(AT(world.light_nodes, at + NODE_REACH));
    n.power = Float(AT(world.light_nodes, at + NODE_POWER));
    n.twofold = Float(AT(world.light_nodes, at + NODE_TWOFOLD));
    return n;
}

#ifdef LANCER_ISA

FN LightNode gather_node(IN(WorldRecord) world, Int node, Mask mask) {
    alignas(64) std::int32_t at[LANES];
    alignas(64) float out[NODE_SIZE][LANES] = {};
    node.store_aligned(at);
    for (unsigned left = mask_bits(mask); left != 0; left &= left - 1) {
        const int lane = __builtin_ctz(left);
        const float* numbers = world.light_nodes + static_cast<std::ptrdiff_t>(at[lane]) * NODE_SIZE;
        for (int i = 0; i < NODE_SIZE; ++i) {
            out[i][lane] = numbers[i];
        }
    }
    LightNode n;
    n.middle = vec3_of(Float::load_aligned(out[0]), Float::load_aligned(out[1]), Float::load_aligned(out[2]));
    n.radius = Float::load_aligned(out[NODE_RADIUS]);
    n.axis = vec3_of(Float::load_aligned(out[NODE_AXIS]), Float::load_aligned(out[NODE_AXIS + 1]), Float::load_aligned(out[NODE_AXIS + 2]));
    n.cos_spread = Float::load_aligned(out[NODE_SPREAD]);
    n.cos_reach = Float::load_aligned(out[NODE_REACH]);
    n.power = Float::load_aligned(out[NODE_POWER]);
    n.twofold = Float::load_aligned(out[NODE_TWOFOLD]);
    return n;
}

#else

FN LightNode gather_node(IN(WorldRecord) world, Int node, Mask mask) {
    Int at = node;
    if (!mask) {
        at = 0;
    }
    return same_node(world, at);
}

#endif

// Cosine and sine of the angle a - b, or of 0 where that is below 0. Angles from 0 to 180 degrees by their cosines and sines: (cos, sin).
FN Vec2 angle_left(Vec2 a, Vec2 b) {
    Mask gone = a.x > b.x;
    return vec2_of(select(gone, Float(1.0f), a.x * b.x + a.y * b.y), select(gone, Float(0.0f), max(a.y * b.x - a.x * b.y, Float(0.0f))));
}

FN Float sine_of(Float cosine) { return sqrt(max(Float(1.0f) - cosine * cosine, Float(0.0f))); }

// About the irradiance that the node's emitters can make at a point, as emitter_weight has it. Never 0 where light arrives.
FN Float node_weight(IN(LightNode) node, Vec3 from, Vec3 facing) {
    Vec3 way = node.middle - from;
    Float distance_2 = dot(way, way);
    Float radius_2 = node.radius * node.radius;
    Mask inside = distance_2 <= radius_2;
    Float distance = sqrt(max(distance_2, Float(SMALLEST)));
    Vec3 towards = way / distance;
    // What the sphere covers of the directions there.
    Float sin_half = min(node.radius / distance, Float(1.0f));
    Vec2 half_angle = vec2_of(select(inside, Float(-1.0f), sine_of(sin_half)), select(inside, Float(0.0f), sin_half));
    // Away from the emitters' axes, at least.
    Float slant = -dot(towards, node.axis);
    slant = select(node.twofold > Float(0.5f), abs(slant), slant);
    Vec2 off = angle_left(vec2_of(slant, sine_of(slant)), vec2_of(node.cos_spread, sine_of(node.cos_spread)));
    Float sent = angle_left(off, half_angle).x;
    // Close to a node's emitters, or among them, some are nearer than its middle: by how much one takes them for nearer at most has been measured.
    Float weight = node.power / max(max(distance_2, radius_2 * Float(NEAREST_2)), Float(SMALLEST));
    weight = select(sent >= node.cos_reach, weight * max(sent, Float(LEAST_SLANT)), Float(0.0f));
    Float rises = dot(towards, facing);
    Float taken = angle_left(vec2_of(rises, sine_of(rises)), half_angle).x;
    Mask sided = dot(facing, facing) > Float(0.5f);
    Float seen = select(taken > Float(0.0f), max(taken, Float(LEAST_SLANT)), Float(0.0f));
    return select(sided, weight * seen, weight);
}

FN Float tree_weight(IN(WorldRecord) world, Vec3 from, Vec3 facing) { return node_weight(same_node(world, 0), from, facing); }

// The weights of a node's two children, from the first one's number.
FN Vec2 child_weights(IN(WorldRecord) world, Int child, Vec3 from, Vec3 facing, Mask mask) {
    Vec2 weights;
    int first = first_of(child, mask);
    if (some(without(mask, is_equal(child, Int(first))))) {
        weights.x = node_weight(gather_node(world, child, mask), from, facing);
        weights.y = node_weight(gather_node(world, child + Int(1), mask), from, facing);
    } else {
        weights.x = node_weight(same_node(world, first), from, facing);
        weights.y = node_weight(same_node(world, first + 1), from, facing);
    }
    return weights;
}

FN Int child_of(IN(WorldRecord) world, Int node, Mask mask) {
    return round_to_int(gather_float(world.light_nodes, node * Int(NODE_SIZE) + Int(NODE_CHILD), mask));
}

// `chance`: of coming here.
FN EmitterChoice choose_in_tree(IN(WorldRecord) world, Vec3 from, Vec3 facing, Float u, Float chance, Mask mask) {
    EmitterChoice choice;
    choice.emitter = Int(-1);
    choice.chance = chance;
    Int node = Int(0);
    Float rest = u;
    Mask going = mask;
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
    Float result = select(going, chance, Float(0.0f));
    Int node = Int(0);
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
