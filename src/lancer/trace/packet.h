// Rays in arrays, between code compiled for different instruction sets: how many lanes the caller has does not matter here.
#pragma once

#include "lancer/kernel/records.h"

namespace lancer {

struct TracePacket {
    alignas(64) float origin_x[16];
    alignas(64) float origin_y[16];
    alignas(64) float origin_z[16];
    alignas(64) float direction_x[16];
    alignas(64) float direction_y[16];
    alignas(64) float direction_z[16];
    alignas(64) float reach[16];
    unsigned alive;  // one bit a lane
    int lanes;       // 4, 8 or 16
    // Answers. trace_closest: as kernel Hit. trace_occluded: object 1 where something is in the way, else 0.
    alignas(64) float t[16];
    alignas(64) int object[16];
    alignas(64) int part[16];
    alignas(64) float u[16];
    alignas(64) float v[16];
};

// world.tree is a Tree (tree.h) of this very world.
void trace_closest(const kernel::WorldRecord& world, TracePacket& packet);
void trace_occluded(const kernel::WorldRecord& world, TracePacket& packet);

}  // namespace lancer
