// Lights by name and by temperature.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lancer/spectrum/curve.h"

namespace lancer {

// The CIE's illuminants [CIE 15:2004], relative, 100 at 560 nm: "A", "C", "D50" (and any other "D" with hundreds of kelvin from D40 to D250),
// "E"; and "FL1" to "FL12" (or "F1" to "F12") as the CIE scales them. Letter case, spaces, hyphens and a leading "CIE" make no difference.
std::optional<SpectralCurve> find_illuminant(std::string_view name);
std::vector<std::string> illuminant_names();

// Daylight with a correlated colour temperature from 4000 to 25000 K, 100 at 560 nm [CIE 15:2004, 3.1]; temperatures outside are moved to
// the nearer end. Note that the CIE's D65 is daylight of 6504 K: the constant c2 was revised after it had been named.
SpectralCurve daylight(double kelvin);

// Radiance of a black body in W/(m2 sr nm), tabulated at each nanometre from 300 to 1100 nm [Planck 1901]. kelvin > 0.
SpectralCurve blackbody(double kelvin);
double blackbody_radiance(double kelvin, double nanometres);

// D65 with luminance Y = 1: the light under which sRGB's white is white.
const SpectralCurve& unit_d65();

}  // namespace lancer
