// The CPU as a device.
#pragma once

#include <memory>

#include "lancer/device/device.h"
#include "lancer/world/world.h"

namespace lancer {

enum class Tracer {
    automatic,    // all objects in lanes when they are few, else the tree
    all_objects,  // every object against every ray
    tree          // Embree
};

struct CpuOptions {
    Tracer tracer = Tracer::automatic;
    int lanes = 0;    // 4, 8 or 16 rays together; 0: as many as the processor can. The picture is the same.
    int threads = 0;  // for building the tree; 0: all
};

// Throws MachineFailure where the processor lacks the lanes asked for or memory runs out. `all_objects` is only possible in worlds that are small
// (World::is_small): the tree is used in others.
std::unique_ptr<Device> make_cpu_device(std::shared_ptr<const World> world, const CpuOptions& options = {});

}  // namespace lancer
