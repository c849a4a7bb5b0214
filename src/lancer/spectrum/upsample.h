// Smooth spectra for linear sRGB [Jakob and Hanika 2019]: a parabola over wavelength, squeezed between 0 and 1.
//
// A table made at build time holds parabolas for colours all over the sRGB cube; others are interpolated. kernel/upsample.h reads the same
// table lane by lane.
// differs: the paper's cube has sides brightest component and ratios of the others; ours has hue, saturation and lightness, with what grows
// without bounds towards black, white and grey taken out of the tabulated values. So greys are exactly constant spectra, and near-whites and
// near-blacks are as good as the rest. A colour and its complement have opposite parabolas, so that only the darker half is stored.
#pragma once

#include <glm/vec3.hpp>
#include <span>

namespace lancer {

// Reflectance 1/2 + p / (2 sqrt(1 + p^2)) with p = (c.x t + c.y) t + c.z and t = (wavelength - 595 nm) / 235 nm, -1 to 1 over 360 to 830 nm.
struct SmoothSpectrum {
    glm::dvec3 coefficients{0.0};

    double at(double nanometres) const;  // in [0, 1]
};

// The reflectance that looks like `rgb` under D65 (see sensor.h), from the table. Components are moved into [0, 1]; what is no number is 0.
// How near it comes is in docs/spectra.md. Grey gives exactly that grey at every wavelength.
SmoothSpectrum smooth_reflectance(const glm::dvec3& rgb);

// Light of any strength: `scale` times a smooth spectrum times D65 with luminance 1 (illuminant.h). Negative components become 0.
struct SmoothLight {
    double scale = 0.0;  // twice the largest component
    SmoothSpectrum shape;

    double at(double nanometres) const;
};
SmoothLight smooth_light(const glm::dvec3& rgb);

// The table: x, y and z of [lightness][saturation][hue], in single precision.
inline constexpr int upsampling_hues = 192;  // 32 in each sixth of the circle of hues, which closes
inline constexpr int upsampling_saturations = 21;
inline constexpr int upsampling_lightnesses = 49;
inline constexpr int upsampling_values = upsampling_lightnesses * upsampling_saturations * upsampling_hues * 3;
std::span<const float> upsampling_table();

}  // namespace lancer
