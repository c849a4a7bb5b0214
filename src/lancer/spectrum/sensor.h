// From light at its wavelengths to linear sRGB, as the spectral renderer does it.
#pragma once

#include <glm/vec3.hpp>

#include "lancer/spectrum/curve.h"

namespace lancer {

// What light of 1 at one wavelength adds to linear sRGB, for each nanometre. Integrated from 360 to 830 nm, D65 with luminance Y = 1 is
// (1, 1, 1): sRGB's primaries [IEC 61966-2-1] with the white that D65 has under our integrals, x = 0.31273, y = 0.32902, instead of the rounded
// 0.3127, 0.3290, so that what is grey stays grey. Components of single wavelengths may be negative.
glm::dvec3 sensor_weight(double nanometres);

// Linear sRGB of a light; and of a reflectance lit by D65, where a perfect white is (1, 1, 1).
glm::dvec3 to_rgb(const SpectralCurve& light);
glm::dvec3 reflected_rgb(const SpectralCurve& reflectance);

}  // namespace lancer
