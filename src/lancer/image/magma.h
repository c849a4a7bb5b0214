// Colours for maps of numbers.
#pragma once

#include <array>
#include <cstdint>

namespace lancer {

// "magma" [van der Walt and Smith 2015], which grows evenly in brightness: black for 0, light yellow for 1; clipped. sRGB bytes.
std::array<std::uint8_t, 3> magma(float value);

}  // namespace lancer
