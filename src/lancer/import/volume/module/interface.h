// What the program and the module with OpenVDB in it say to each other. C linkage and plain data, as of the module that reads images.
#pragma once

#include <cstddef>
#include <cstdint>

extern "C" {

// Raised when anything below changes.
inline constexpr int lancer_volumes_version = 1;

struct LancerVoxels {
    std::int32_t size[3];  // cells along x, y and z
    std::int32_t channels;
    double to_world[16];  // from the unit cube that the cells fill, column by column
    const float* values;  // channels fastest, then x, then y, then z
};

using LancerVolumeReason = void (*)(void* receiver, const char* data, std::size_t size);
using LancerVolumeReceiver = void (*)(void* receiver, const LancerVoxels* voxels);

// The active cells of a grid, and those between them, of a file in memory; `name` may be empty: the first grid of numbers. At most `most` values.
// False and the reason when it can't be done.
using LancerReadVdb = bool (*)(const char* bytes, std::size_t size, const char* name, double most, void* receiver,
                               LancerVolumeReceiver receive, LancerVolumeReason reason);

// The one symbol that the module exports, "lancer_volumes".
struct LancerVolumes {
    int version;
    LancerReadVdb read;
};
}
