// The nodes of the tree over emitters: how much light each can send to a place.
#ifndef LANCER_KERNEL_EMITTER_LIGHT_NODE_H
#define LANCER_KERNEL_EMITTER_LIGHT_NODE_H

#include "lancer/kernel/math.h"
#include "lancer/kernel/tables.h"

NAMESPACE_BEGIN

const float NEAREST_2 = 1.0f / 6.0f;  // see node_weight
const float LEAST_SLANT = 0.05f;      // what a mirror makes of a grazing lamp is not weighed too low

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

NAMESPACE_END

#endif
