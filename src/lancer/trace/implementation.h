// What stands behind a Tree; for the files of this folder.
#pragma once

#include <vector>

#include <embree3/rtcore.h>

#include "lancer/trace/tree.h"

namespace lancer {

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
