// The sun's light outside the air.
#pragma once

#include "lancer/spectrum/curve.h"

namespace lancer {

// Half of the angle that the sun's disk spans at its mean distance, in radians: its nominal radius over the astronomical unit [IAU 2015 B3].
inline constexpr double sun_radius = 6.957e8 / 1.495978707e11;

// Irradiance at right angles at the mean distance of the earth, W/(m^2 nm), 300 to 840 nm [Bird and Riordan 1984, table 2-1].
const SpectralCurve& sun_outside_air();

// What a column of one atm-cm of ozone absorbs, to base e [Bird and Riordan 1984, table 2-1].
const SpectralCurve& ozone_absorption();

}  // namespace lancer
