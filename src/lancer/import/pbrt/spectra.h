// Spectra as pbrt writes them: rgb, blackbody, by name, from a file or in place.
#pragma once

#include <optional>

#include "lancer/import/pbrt/color_space.h"
#include "lancer/import/pbrt/parameters.h"
#include "lancer/scene/color.h"
#include "lancer/scene/materials.h"
#include "lancer/spectrum/curve.h"

namespace lancer::pbrt {

using Color = scene::Color;

// How a share looks, and a light.
scene::Rgb visible(const Color& share);
scene::Rgb visible_light(const Color& light);

Color operator*(const Color& color, double factor);

// A share of light, such as a reflectance; nothing after an error.
std::optional<Color> read_share(const Parameters& parameters, const Parameter& parameter, ColorSpace space);

// A light of the brightness that pbrt gives it: rgb as it is; every other spectrum is scaled to luminance 1, and only the parameters "scale" and
// "power" of the light make it brighter. Version 3 takes spectra as they are.
std::optional<Color> read_light(const Parameters& parameters, const Parameter& parameter, ColorSpace space, bool version3);

// An index or an absorption, over wavelength; of rgb a smooth curve through the three numbers.
std::optional<SpectralCurve> read_curve(const Parameters& parameters, const Parameter& parameter, ColorSpace space);

// Part of a complex index of refraction.
std::optional<scene::Index> read_index(const Parameters& parameters, const Parameter& parameter, ColorSpace space);

}  // namespace lancer::pbrt
