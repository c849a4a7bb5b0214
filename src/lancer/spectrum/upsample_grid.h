// Where the colours of the table lie (see upsample.h). kernel/upsample.h says the same in its dialect.
#pragma once

#include <algorithm>
#include <cmath>

namespace lancer {

inline constexpr double upsampling_middle = 595.0;  // nm
inline constexpr double upsampling_spread = 235.0;  // nm

// From evenly spaced places to hue and lightness: dense at both ends, where spectra change fastest. Both map [0, 1] onto itself.
inline double from_even_ends(double u) { return u < 0.5 ? 2.0 * u * u : 1.0 - 2.0 * (1.0 - u) * (1.0 - u); }
inline double to_even_ends(double v) { return v < 0.5 ? std::sqrt(0.5 * v) : 1.0 - std::sqrt(0.5 * (1.0 - v)); }

// From evenly spaced places to saturation: dense at the full one.
inline double from_even_end(double u) { return 1.0 - (1.0 - u) * (1.0 - u); }
inline double to_even_end(double v) { return 1.0 - std::sqrt(1.0 - v); }

// What the tabulated values are divided by, for a lightness up to 1/2; the third one is tabulated less `lightness - 1/2`, which gives grey.
inline double upsampling_divisor(double lightness) { return std::sqrt(std::max(lightness * (1.0 - lightness), 1e-30)); }

}  // namespace lancer
