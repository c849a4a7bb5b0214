// The tabulated CIE 1931 2-degree observer.
#pragma once

#include <array>

namespace lancer {

inline constexpr int cie_1931_first = 360;  // nm
inline constexpr int cie_1931_step = 5;     // nm
inline constexpr int cie_1931_count = 95;   // to 830 nm

// x, y, z at each wavelength, absolute: y is 1 at 555 nm.
extern const std::array<std::array<double, 3>, cie_1931_count> cie_1931_table;

}  // namespace lancer
