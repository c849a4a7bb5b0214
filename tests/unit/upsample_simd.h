// The kernel's look-up for four colours at once, for a test that has the one for single colours.
#pragma once

#include <array>

namespace lancer {

struct FourColors {
    std::array<float, 4> r{}, g{}, b{}, nanometres{};
};

// Reflectances; 0 in the lanes that are not `on`.
std::array<float, 4> four_reflectances(const FourColors& colors, const std::array<bool, 4>& on);

}  // namespace lancer
