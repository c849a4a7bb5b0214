// The kernel's integrators on the CPU, one entry for each instruction set that they were compiled for.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lancer/device/device.h"
#include "lancer/kernel/bidirectional/photon_record.h"
#include "lancer/kernel/records.h"

namespace lancer {

// Radiance at `count` points of the film, in pixels. Where world.tree is set it is a trace::Tree.
using FollowFunction = void (*)(const kernel::WorldRecord& world, const glm::vec2* points, glm::vec3* radiance, std::size_t count,
                                RayCounts& counts);

// See Device::trace_paths and Device::find_fault.
using TracePathsFunction = void (*)(const kernel::WorldRecord& world, const PathRange& range, const PathSamples& samples,
                                    RayCounts& counts);
using FindFaultFunction = PathFault (*)(const kernel::WorldRecord& world, int x, int y, int sample);

// `maps`: null where no photons are merged.
class PhotonMaps;
using TraceBothEndsFunction = void (*)(const kernel::WorldRecord& world, const PathRange& range, PhotonMaps* maps,
                                       const PathSamples& samples, RayCounts& counts);

// Photons of the paths of one sample, from `first` on; and the radius that they are gathered from.
using TracePhotonsFunction = std::vector<kernel::PhotonRecord> (*)(const kernel::WorldRecord& world, int sample, int first, int count);
using PhotonRadiusFunction = float (*)(const kernel::WorldRecord& world, int sample);

struct CpuVariant {
    const char* name;
    int lanes;
    FollowFunction whitted;
    TracePathsFunction paths;
    FindFaultFunction fault;
    TraceBothEndsFunction both_ends;  // where the world's integrator follows light from the lamps; splats must be asked for
    TracePhotonsFunction photons;
    PhotonRadiusFunction photon_radius;
};

// The best variant that this processor runs; `lanes` other than 0 asks for one with so many. Null where that one can't run here.
const CpuVariant* find_cpu_variant(int lanes = 0);

}  // namespace lancer
