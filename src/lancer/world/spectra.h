// What the author's spectra are: curves over wavelength, and how they look.
#pragma once

#include <glm/vec3.hpp>

#include "lancer/scene/color.h"
#include "lancer/spectrum/curve.h"

namespace lancer {

// A share, an index or an absorption: beyond what was measured as at the ends. The names in a spectrum are ones that spectrum/ knows.
SpectralCurve reflectance_curve(const scene::Spectrum& spectrum);
SpectralCurve index_curve(const scene::MeasuredSpectrum& measured);

// A light, scaled as the author says.
SpectralCurve light_curve(const scene::Spectrum& spectrum);

// What is left of light after `depth` metres, at each wavelength [Bouguer 1729].
SpectralCurve clearness(const SpectralCurve& absorption, double depth);

// Linear RGB: of a share under D65, of a light as it is. Colours outside sRGB are moved to its border.
scene::Rgb reflected(const scene::Color& color);
scene::Rgb emitted(const scene::Color& color);

// How bright linear RGB is to the eye, 0 at least [Rec. 709].
double brightness(const glm::vec3& rgb);

}  // namespace lancer
