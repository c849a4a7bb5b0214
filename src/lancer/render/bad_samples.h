// Samples whose light was not a number, infinite or negative, and so were left out of the picture.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lancer/device/device.h"
#include "lancer/film/film_state.h"

namespace lancer {

struct BadSample {
    int x = 0;  // the pixel, from the upper left
    int y = 0;
    int sample = 0;
    PathFault fault;
};

// How many there were, and the first few by row, column and number: the same whichever thread found which.
class BadSamples {
public:
    static constexpr std::size_t kept = 8;

    BadSamples() = default;
    // What a film has left out. The first few are followed again, to see where they went wrong.
    BadSamples(const Device& device, const FilmState& state);

    std::uint64_t count() const { return count_; }
    const std::vector<BadSample>& first() const { return first_; }

private:
    void look_for(const Device& device, int x, int y, int samples);

    std::uint64_t count_ = 0;
    std::vector<BadSample> first_;
};

}  // namespace lancer
