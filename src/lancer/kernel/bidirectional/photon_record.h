// Photons as a device keeps them, and in which cells of space it looks for those that are near.
#ifndef LANCER_KERNEL_BIDIRECTIONAL_PHOTON_RECORD_H
#define LANCER_KERNEL_BIDIRECTIONAL_PHOTON_RECORD_H

#include "lancer/kernel/math.h"

RECORDS_BEGIN

// In world space; see merge.h.
struct PhotonRecord {
    vec3 position;
    vec3 normal;
    vec3 from;
    vec4 light;
    float meet;
    float join;
    float merge;
    uint depth_and_single;  // twice the depth, and 1 for those of one wavelength
};

#ifdef __cplusplus
static_assert(sizeof(PhotonRecord) == 68);
#endif

RECORDS_END

NAMESPACE_BEGIN

// Cells are two radii wide, so that what lies within one radius is in eight cells at most.
FN Int photon_cell(Float place, Float radius) {
    return to_int(min(max(floor(place / (Float(2.0f) * radius)), Float(-1.0e9f)), Float(1.0e9f)));
}

// The bucket of a cell, of `mask` + 1, a power of two [Teschner et al. 2003].
FN UInt photon_bucket(Int x, Int y, Int z, UInt mask) {
    return ((as_unsigned(x) * UInt(73856093u)) ^ (as_unsigned(y) * UInt(19349663u)) ^ (as_unsigned(z) * UInt(83492791u))) & mask;
}

NAMESPACE_END

#endif
