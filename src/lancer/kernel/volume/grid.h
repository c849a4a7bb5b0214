// Quantities in space: what a grid holds at a point, and the way of a ray through its blocks, each of which says how large its values are at most.
#ifndef LANCER_KERNEL_VOLUME_GRID_H
#define LANCER_KERNEL_VOLUME_GRID_H

#include "lancer/kernel/placed.h"
#include "lancer/kernel/ray.h"
#include "lancer/kernel/tables.h"

NAMESPACE_BEGIN

// Eight neighbours and how near the point is to the upper ones.
struct GridPlace {
    Int x0, x1, y0, y1, z0, z1;
    Float x, y, z;
};

FN Int clamp_entry(Float floored, int last) { return round_to_int(min(max(floored, Float(0.0f)), Float(float(last)))); }

// `place` in the unit cube.
FN GridPlace grid_place(IN(GridRecord) grid, Vec3 place) {
    Float x = place.x * Float(float(grid.columns)) - Float(0.5f);
    Float y = place.y * Float(float(grid.rows)) - Float(0.5f);
    Float z = place.z * Float(float(grid.layers)) - Float(0.5f);
    Float x_floor = floor(x);
    Float y_floor = floor(y);
    Float z_floor = floor(z);
    GridPlace at;
    at.x0 = clamp_entry(x_floor, grid.columns - 1);
    at.y0 = clamp_entry(y_floor, grid.rows - 1);
    at.z0 = clamp_entry(z_floor, grid.layers - 1);
    at.x1 = clamp_entry(x_floor + Float(1.0f), grid.columns - 1);
    at.y1 = clamp_entry(y_floor + Float(1.0f), grid.rows - 1);
    at.z1 = clamp_entry(z_floor + Float(1.0f), grid.layers - 1);
    at.x = x - x_floor;
    at.y = y - y_floor;
    at.z = z - z_floor;
    return at;
}

FN Float lerped(Float a, Float b, Float share) { return a + (b - a) * share; }

FN Float grid_entry(IN(WorldRecord) world, IN(GridRecord) grid, Int x, Int y, Int z, int channel, Mask mask) {
    Int at = ((z * Int(grid.rows) + y) * Int(grid.columns) + x) * Int(grid.channels) + Int(grid.first + channel);
    return gather_float(world.voxels, at, mask);
}

FN Float grid_channel(IN(WorldRecord) world, IN(GridRecord) grid, IN(GridPlace) at, int channel, Mask mask) {
    Float near_low = lerped(grid_entry(world, grid, at.x0, at.y0, at.z0, channel, mask),
                            grid_entry(world, grid, at.x1, at.y0, at.z0, channel, mask), at.x);
    Float near_high = lerped(grid_entry(world, grid, at.x0, at.y1, at.z0, channel, mask),
                             grid_entry(world, grid, at.x1, at.y1, at.z0, channel, mask), at.x);
    Float far_low = lerped(grid_entry(world, grid, at.x0, at.y0, at.z1, channel, mask),
                           grid_entry(world, grid, at.x1, at.y0, at.z1, channel, mask), at.x);
    Float far_high = lerped(grid_entry(world, grid, at.x0, at.y1, at.z1, channel, mask),
                            grid_entry(world, grid, at.x1, at.y1, at.z1, channel, mask), at.x);
    return lerped(lerped(near_low, near_high, at.y), lerped(far_low, far_high, at.y), at.z);
}

FN Vec3 grid_color(IN(WorldRecord) world, IN(GridRecord) grid, IN(GridPlace) at, Mask mask) {
    return vec3_of(grid_channel(world, grid, at, 0, mask), grid_channel(world, grid, at, 1, mask), grid_channel(world, grid, at, 2, mask));
}

FN Mask is_in_grid(Vec3 place) {
    Mask low = both(both(place.x >= Float(0.0f), place.y >= Float(0.0f)), place.z >= Float(0.0f));
    return both(low, both(both(place.x <= Float(1.0f), place.y <= Float(1.0f)), place.z <= Float(1.0f)));
}

// ---- From block to block [Amanatides and Woo 1987] ---------------------------------------------------------------------------------------

const int MOST_BLOCKS = 4096;  // that a ray passes; more than any grid has along it

struct March {
    Vec3 start;  // where the ray begins, in blocks from the grid's corner
    Vec3 rate;   // blocks a metre
    Int x, y, z;
    Float t;        // metres along the ray
    Float end;      // where it leaves the grid
    Float largest;  // value in this block
    Mask inside;
};

FN Float largest_in_block(IN(WorldRecord) world, IN(GridRecord) grid, Int x, Int y, Int z, Mask mask) {
    return gather_float(world.voxels, (z * Int(grid.blocks_y) + y) * Int(grid.blocks_x) + x + Int(grid.first_block), mask);
}

FN March start_march(IN(WorldRecord) world, IN(GridRecord) grid, Vec3 origin, Vec3 direction, Float reach, Mask mask) {
    March m;
    Vec3 o = apply_affine(grid.to_grid, origin);
    Vec3 d = apply_linear(grid.to_grid, direction);
    Vec3 per_metre = slab_reciprocal(d);
    Vec3 low = -o * per_metre;
    Vec3 high = (vec3_all(Float(1.0f)) - o) * per_metre;
    Vec3 near = min(low, high);
    Vec3 far = max(low, high);
    m.t = max(max(max(near.x, near.y), near.z), Float(0.0f));
    m.end = min(min(min(far.x, far.y), far.z), reach);
    m.inside = both(mask, m.t < m.end);
    m.t = select(m.inside, m.t, Float(0.0f));
    Vec3 blocks = vec3_of(Float(float(grid.columns) / float(grid.block)), Float(float(grid.rows) / float(grid.block)),
                          Float(float(grid.layers) / float(grid.block)));
    m.start = o * blocks;
    m.rate = d * blocks;
    Vec3 at = m.start + m.rate * m.t;
    m.x = clamp_entry(floor(at.x), grid.blocks_x - 1);
    m.y = clamp_entry(floor(at.y), grid.blocks_y - 1);
    m.z = clamp_entry(floor(at.z), grid.blocks_z - 1);
    m.largest = largest_in_block(world, grid, m.x, m.y, m.z, m.inside);
    return m;
}

// Where the ray leaves its block along one axis, in metres.
FN Float block_exit(Float start, Float rate, Int entry) {
    Float border = to_float(entry) + select(rate > Float(0.0f), Float(1.0f), Float(0.0f));
    Mask moves = abs(rate) > Float(1.0e-30f);
    return select(moves, (border - start) / select(moves, rate, Float(1.0f)), Float(FAR));
}

FN Mask is_entry(Int entry, int count) { return both(is_above(entry, Int(-1)), is_above(Int(count), entry)); }

// Goes on until the blocks' largest values, times metres, have used up `left_over`; `passed` grows by what was used. Returns which rays stopped
// so, the others have left the grid.
FN Mask march_on(IN(WorldRecord) world, IN(GridRecord) grid, Mask mask, INOUT(March) m, INOUT(Float) left_over, INOUT(Float) passed) {
    Mask going = mask;
    Mask stopped = without(mask, mask);
    for (int i = 0; i < MOST_BLOCKS && some(going); ++i) {
        Float exit_x = block_exit(m.start.x, m.rate.x, m.x);
        Float exit_y = block_exit(m.start.y, m.rate.y, m.y);
        Float exit_z = block_exit(m.start.z, m.rate.z, m.z);
        Float exit = max(min(min(min(exit_x, exit_y), exit_z), m.end), m.t);
        Float room = (exit - m.t) * m.largest;
        Mask stops = both(going, left_over < room);
        passed = select(going, passed + select(stops, left_over, room), passed);
        m.t = select(going, select(stops, min(m.t + left_over / max(m.largest, Float(SMALLEST)), exit), exit), m.t);
        left_over = select(going, select(stops, Float(0.0f), left_over - room), left_over);
        stopped = either(stopped, stops);
        going = both(without(going, stops), exit < m.end);
        Mask along_x = both(going, both(exit_x <= exit_y, exit_x <= exit_z));
        Mask along_y = both(without(going, along_x), exit_y <= exit_z);
        Mask along_z = without(without(going, along_x), along_y);
        m.x = m.x + select(along_x, select(m.rate.x > Float(0.0f), Int(1), Int(-1)), Int(0));
        m.y = m.y + select(along_y, select(m.rate.y > Float(0.0f), Int(1), Int(-1)), Int(0));
        m.z = m.z + select(along_z, select(m.rate.z > Float(0.0f), Int(1), Int(-1)), Int(0));
        going = both(going, both(both(is_entry(m.x, grid.blocks_x), is_entry(m.y, grid.blocks_y)), is_entry(m.z, grid.blocks_z)));
        if (some(going)) {
            m.largest = select(going, largest_in_block(world, grid, m.x, m.y, m.z, going), m.largest);
        }
    }
    return stopped;
}

NAMESPACE_END

#endif
