// A spectrum as a curve over wavelength, and what the CIE 1931 observer sees of it.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace lancer {

// Where spectra are tabulated for rendering: the wavelengths of the observer, in steps of 5 nm or of 1 nm.
struct SpectralGrid {
    double first = 360.0;  // nm
    double step = 5.0;     // nm
    int count = 95;        // to 830 nm
};
inline constexpr SpectralGrid coarse_grid{};
inline constexpr SpectralGrid fine_grid{360.0, 1.0, 471};

// Straight lines between values at rising wavelengths.
class SpectralCurve {
public:
    // Outside the measured wavelengths: the value at that end, as reflectances and indices are continued, or nothing, as light is.
    enum class Beyond { constant, zero };

    // The same value everywhere.
    explicit SpectralCurve(double value = 0.0);
    // At least one wavelength; as many values; wavelengths in nm, strictly rising; all finite.
    SpectralCurve(std::vector<double> nanometres, std::vector<double> values, Beyond beyond);

    double at(double nanometres) const;
    std::vector<double> on(const SpectralGrid& grid) const;
    SpectralCurve scaled(double factor) const;
    SpectralCurve with_ends(Beyond beyond) const;

    const std::vector<double>& nanometres() const { return nanometres_; }
    const std::vector<double>& values() const { return values_; }
    double highest() const;  // of the values
    double lowest() const;

private:
    std::vector<double> nanometres_;
    std::vector<double> values_;
    Beyond beyond_;
};

// XYZ of light, exactly integrated over the observer's fine table: 360 to 830 nm, 1 nm. A light of 1 at every wavelength has Y = 1.
glm::dvec3 to_xyz(const SpectralCurve& light);
// XYZ of a reflectance under a light: a perfect white has Y = 1. 0 under a light that nobody sees.
glm::dvec3 to_xyz(const SpectralCurve& reflectance, const SpectralCurve& light);

// XYZ of light by sums of the products at every 5 nm from 380 to 780 nm, the way in which the published chromaticities of illuminants were
// found [CIE 15:2004, 7.2]. Normalised as to_xyz.
glm::dvec3 to_xyz_by_sums(const SpectralCurve& light);

// x and y of XYZ; 0 for black.
glm::dvec2 chromaticity(const glm::dvec3& xyz);

// The light with luminance Y = 1; as it is when its Y is below 1e-300, as a black body's of 20 K.
SpectralCurve with_unit_luminance(const SpectralCurve& light);

}  // namespace lancer
