// The kernel's integrators on the CPU, one entry for each instruction set that they were compiled for.
#pragma once

#include <cstddef>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lancer/device/device.h"
#include "lancer/kernel/records.h"

namespace lancer {

// Radiance at `count` points of the film, in pixels. Where world.tree is set it is a trace::Tree.
using FollowFunction = void (*)(const kernel::WorldRecord& world, const glm::vec2* points, glm::vec3* radiance, std::size_t count,
                                RayCounts& counts);

// See Device::trace_paths and Device::find_fault.
using TracePathsFunction = void (*)(const kernel::WorldRecord& world, const PathRange& range, const PathSamples& samples,
                                    RayCounts& counts);
using FindFaultFunction = PathFault (*)(const kernel::WorldRecord& world, int x, int y, int sample);

struct CpuVariant {
    const char* name;
    int lanes;
    FollowFunction whitted;
    TracePathsFunction paths;
    FindFaultFunction fault;
};

// The best variant that this processor runs; `lanes` other than 0 asks for one with so many. Null where that one can't run here.
const CpuVariant* find_cpu_variant(int lanes = 0);

}  // namespace lancer
