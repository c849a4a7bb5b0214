// The fluorescent lamps FL1 to FL12 that the CIE tabulates: 1 to 6 standard, 7 to 9 broad-band, 10 to 12 with three narrow bands.
#pragma once

#include <array>

namespace lancer {

inline constexpr int fluorescent_count = 12;
inline constexpr int fluorescent_first = 380;  // nm
inline constexpr int fluorescent_step = 5;     // nm

// Relative power of FL1, FL2, ... from 380 to 780 nm [CIE 15:2004, table T.6].
extern const std::array<std::array<double, 81>, fluorescent_count> fluorescent_table;

}  // namespace lancer
