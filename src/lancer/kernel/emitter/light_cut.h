// A tree over emitters, cut: of a node that is close for its size nobody knows how much light comes, since one of its emitters may be very near. So such
// nodes are taken apart. Which are is a function of the place alone.
#ifndef LANCER_KERNEL_EMITTER_LIGHT_CUT_H
#define LANCER_KERNEL_EMITTER_LIGHT_CUT_H

#include "lancer/kernel/emitter/light_node.h"

NAMESPACE_BEGIN

const float CLOSE_2 = 1.5f;  // nodes are close whose middle is less than so many squared radii away
const int MOST_SPLITS = 16;  // so many nodes are taken apart at most
const int CUT_SIZE = 2 * MOST_SPLITS + 4;

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

NAMESPACE_END

#endif
