// What stands behind a Tree; for the files of this folder.
#pragma once

#include <vector>

#include <embree3/rtcore.h>

#include "lancer/trace/packet.h"
#include "lancer/trace/tree.h"

namespace lancer {

// What Embree hands through to our functions while it follows a packet of rays. A ray's id is its lane.
struct TraceContext {
    RTCIntersectContext embree;
    const kernel::WorldRecord* world;
    TracePacket* packet;  // keeps the first hit of each lane so far
};

struct Tree::Implementation {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    std::vector<RTCScene> mesh_scenes;
    kernel::WorldRecord world{};
    std::vector<int> shapes;               // object number of each shape in the shapes' geometry
    std::vector<int> objects_of_geometry;  // object number of each instance, by geometry id; -1 for the shapes
    unsigned shapes_geometry = RTC_INVALID_GEOMETRY_ID;

    Implementation() = default;
    Implementation(const Implementation&) = delete;
    Implementation& operator=(const Implementation&) = delete;
    ~Implementation();
};

}  // namespace lancer
