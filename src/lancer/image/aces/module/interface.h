// What the program and the module with OpenColorIO in it say to each other. C linkage and plain data, as of the module that reads images.
#pragma once

#include <cstddef>

extern "C" {

// Raised when anything below changes.
inline constexpr int lancer_aces_version = 1;

using LancerAcesReason = void (*)(void* receiver, const char* data, std::size_t size);

// `count` colours, interleaved, in place: from linear Rec. 709 to linear Rec. 709 of an SDR display. False and the reason when it can't be done.
using LancerDevelopAces = bool (*)(float* colors, std::size_t count, void* receiver, LancerAcesReason reason);

// The one symbol that the module exports, "lancer_aces".
struct LancerAces {
    int version;
    LancerDevelopAces develop;
};
}
