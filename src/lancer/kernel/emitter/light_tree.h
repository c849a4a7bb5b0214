// A tree over the emitters that are near: a path goes down it, at each node to one of the two children, by about how much light they can send
// [Conty Estevez and Kulla 2018]. One random number is used all the way: what is left of it after a choice is stretched for the next one.
//
// Of a node that is close for its size nobody knows how much light comes: one of its emitters may be very near. So those are taken apart first, and one
// is chosen among all that are left; which are taken apart is a function of the place alone, and so is the chance of each emitter.
#ifndef LANCER_KERNEL_EMITTER_LIGHT_TREE_H
#define LANCER_KERNEL_EMITTER_LIGHT_TREE_H

#include "lancer/kernel/math.h"
#include "lancer/kernel/tables.h"

NAMESPACE_BEGIN

const float NEAREST_2 = 1.0f / 6.0f;  // see node_weight
const float CLOSE_2 = 1.5f;           // nodes are close whose middle is less than so many squared radii away
const int MOST_SPLITS = 16;           // so many nodes are taken apart at most
const int CUT_SIZE = 2 * MOST_SPLITS + 4;
const float LEAST_SLANT = 0.05f;  // what a mirror makes of a grazing lamp is not weighed too low

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
    Float child;
    Vec3 half_sides;
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
    n.child = Float(AT(world.light_nodes, at + NODE_CHILD));
    n.half_sides = vec3_of(Float(AT(world.light_nodes, at + NODE_HALF)), Float(AT(world.light_nodes, at + NODE_HALF + 1)),
                           Float(AT(world.light_nodes, at + NODE_HALF + 2)));
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
    n.child = Float::load_aligned(out[NODE_CHILD]);
    n.half_sides =
        vec3_of(Float::load_aligned(out[NODE_HALF]), Float::load_aligned(out[NODE_HALF + 1]), Float::load_aligned(out[NODE_HALF + 2]));
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
    // A flat box sends little along itself, and takes little from there: the most that any of its points is off a plane, over the least distance.
    Vec3 off_box = vec3_of(max(abs(way.x) - node.half_sides.x, Float(0.0f)), max(abs(way.y) - node.half_sides.y, Float(0.0f)),
                           max(abs(way.z) - node.half_sides.z, Float(0.0f)));
    Float nearest = sqrt(max(dot(off_box, off_box), Float(SMALLEST)));
    Vec3 corner = abs(way) + node.half_sides;
    Float farthest = sqrt(max(dot(corner, corner), Float(SMALLEST)));
    Float height = dot(abs(node.axis), node.half_sides);
    Float ahead = -dot(way, node.axis);
    ahead = select(node.twofold > Float(0.5f), abs(ahead), ahead);
    Float most_ahead = ahead + height;
    Float steepest = most_ahead / select(most_ahead > Float(0.0f), nearest, farthest);
    Float turned = min(angle_left(vec2_of(slant, sine_of(slant)), half_angle).x, max(steepest, Float(-1.0f)));
    Float sent = angle_left(vec2_of(turned, sine_of(turned)), vec2_of(node.cos_spread, sine_of(node.cos_spread))).x;
    // Close to a node's emitters, or among them, some are nearer than its middle: by how much one takes them for nearer at most has been measured.
    Float weight = node.power / max(max(distance_2, radius_2 * Float(NEAREST_2)), Float(SMALLEST));
    // Between what its middle sends and the most that any of its points may: nearer the truth than either.
    Float sends = Float(0.5f) * (sent + max(slant, Float(0.0f)));
    weight = select(sent >= node.cos_reach, weight * max(sends, Float(LEAST_SLANT)), Float(0.0f));
    Float rises = dot(towards, facing);
    Float highest = (dot(way, facing) + dot(abs(facing), node.half_sides)) / nearest;
    Float taken = min(angle_left(vec2_of(rises, sine_of(rises)), half_angle).x, highest);
    Mask sided = dot(facing, facing) > Float(0.5f);
    Float takes = Float(0.5f) * (taken + max(rises, Float(0.0f)));
    Float seen = select(taken > Float(0.0f), max(takes, Float(LEAST_SLANT)), Float(0.0f));
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

// ---- What is close is taken apart. ---------------------------------------------------------------------------------------------------------

// Nodes that hold all emitters together. `way`: as light_ways from there on to the emitter that is asked about, -1 where it is not in the node.
struct TreeCut {
    Int node[CUT_SIZE];
    Int way[CUT_SIZE];
    Float weight[CUT_SIZE];
    int count;
    Float sum;
};

FN void put_in_cut(Int node, Int way, Float weight, INOUT(TreeCut) cut) {
    cut.node[cut.count] = node;
    cut.way[cut.count] = way;
    cut.weight[cut.count] = weight;
    cut.sum = cut.sum + weight;
    cut.count = cut.count + 1;
}

// A node that waits to be taken apart; -1: none.
struct WaitingNode {
    Int node;
    Int way;
    Float weight;
};

FN WaitingNode no_waiting_node() {
    WaitingNode w;
    w.node = Int(-1);
    w.way = Int(-1);
    w.weight = Float(0.0f);
    return w;
}

FN WaitingNode select_waiting(Mask mask, IN(WaitingNode) a, IN(WaitingNode) b) {
    WaitingNode w;
    w.node = select(mask, a.node, b.node);
    w.way = select(mask, a.way, b.way);
    w.weight = select(mask, a.weight, b.weight);
    return w;
}

// Squared distance to the middle over the squared radius; of leaves, which nothing takes apart, FAR.
FN Float farness(IN(LightNode) node, Vec3 from) {
    Vec3 way = node.middle - from;
    Float ratio = dot(way, way) / max(node.radius * node.radius, Float(SMALLEST));
    return select(node.child >= Float(0.0f), ratio, Float(FAR));
}

FN_LARGE TreeCut cut_tree(IN(WorldRecord) world, Vec3 from, Vec3 facing, Int emitter_way, Mask mask) {
    TreeCut cut;
    cut.count = 0;
    cut.sum = Float(0.0f);
    LightNode root = same_node(world, 0);
    WaitingNode at;
    at.node = select(mask, Int(0), Int(-1));
    at.way = emitter_way;
    at.weight = select(mask, node_weight(root, from, facing), Float(0.0f));
    WaitingNode second = no_waiting_node();
    WaitingNode third = second;
    WaitingNode fourth = second;
    Mask going = both(mask, farness(root, from) < Float(CLOSE_2));
    for (int i = 0; i < MOST_SPLITS && some(going); ++i) {
        Int child = child_of(world, at.node, going);
        LightNode a;
        LightNode b;
        int first = first_of(child, going);
        if (some(without(going, is_equal(child, Int(first))))) {
            a = gather_node(world, child, going);
            b = gather_node(world, child + Int(1), going);
        } else {
            a = same_node(world, first);
            b = same_node(world, first + 1);
        }
        Mask turns = is_equal(at.way & Int(1), Int(1));
        Mask on_way = is_above(at.way, Int(-1));
        WaitingNode left_one;
        left_one.node = child;
        left_one.way = select(without(on_way, turns), at.way >> 1, Int(-1));
        left_one.weight = select(going, node_weight(a, from, facing), Float(0.0f));
        WaitingNode right_one;
        right_one.node = child + Int(1);
        right_one.way = select(both(on_way, turns), at.way >> 1, Int(-1));
        right_one.weight = select(going, node_weight(b, from, facing), Float(0.0f));
        Float far_a = farness(a, from);
        Float far_b = farness(b, from);
        Mask close_a = both(both(going, far_a < Float(CLOSE_2)), left_one.weight > Float(0.0f));
        Mask close_b = both(both(going, far_b < Float(CLOSE_2)), right_one.weight > Float(0.0f));
        // The nearer one is next; the other waits if it is close, too, and there is room.
        Mask a_first = both(close_a, either(without(going, close_b), far_a <= far_b));
        Mask b_first = without(close_b, a_first);
        Mask room = is_equal(fourth.node, Int(-1));
        Mask a_waits = both(without(close_a, a_first), room);
        Mask b_waits = both(without(close_b, b_first), room);
        Mask waits = either(a_waits, b_waits);
        fourth = select_waiting(waits, third, fourth);
        third = select_waiting(waits, second, third);
        second = select_waiting(waits, select_waiting(a_waits, left_one, right_one), second);
        WaitingNode done_a = select_waiting(without(without(going, a_first), a_waits), left_one, no_waiting_node());
        WaitingNode done_b = select_waiting(without(without(going, b_first), b_waits), right_one, no_waiting_node());
        put_in_cut(done_a.node, done_a.way, done_a.weight, cut);
        put_in_cut(done_b.node, done_b.way, done_b.weight, cut);
        // Who has no close child takes the last one that waits.
        Mask takes = without(without(going, a_first), b_first);
        WaitingNode next = select_waiting(a_first, left_one, right_one);
        next = select_waiting(takes, second, next);
        second = select_waiting(takes, third, second);
        third = select_waiting(takes, fourth, third);
        fourth = select_waiting(takes, no_waiting_node(), fourth);
        at = select_waiting(going, next, at);
        going = both(going, is_above(at.node, Int(-1)));
    }
    put_in_cut(at.node, at.way, at.weight, cut);
    put_in_cut(second.node, second.way, second.weight, cut);
    put_in_cut(third.node, third.way, third.weight, cut);
    put_in_cut(fourth.node, fourth.way, fourth.weight, cut);
    return cut;
}

// ---- The choice ----------------------------------------------------------------------------------------------------------------------------

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
