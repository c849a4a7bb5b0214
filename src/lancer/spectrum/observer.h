// The CIE 1931 2-degree observer, and what it makes of light in linear sRGB.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace lancer {

// Colour matching functions x, y, z at a wavelength in nanometres, linearly interpolated between tabulated values; 0 outside the table.
glm::dvec3 cie_1931(double wavelength_nm);

// The same, interpolated by Sprague's polynomials to each nanometre, as the CIE recommends, and linearly between: within 5e-4 of the table that
// the CIE gives for each nanometre, where straight lines over 5 nm are within 0.016 [CIE 15:2004, 7.2.1].
glm::dvec3 cie_1931_fine(double wavelength_nm);

// The integral of the fine y over the table's wavelengths, in nm.
double cie_1931_area();

// XYZ to linear sRGB, D65 white, and back [IEC 61966-2-1].
glm::dvec3 xyz_to_rgb(const glm::dvec3& xyz);
glm::dvec3 rgb_to_xyz(const glm::dvec3& rgb);

// From linear RGB with sRGB's primaries to XYZ, for any XYZ of (1, 1, 1).
glm::dmat3 rgb_to_xyz_matrix(const glm::dvec3& white);

// `count` wavelengths spread over the visible and the linear-sRGB weight of each, so that white light carried by all of them is (1, 1, 1)
// again: the weights of each channel sum to 1. A single wavelength's weight may be negative: its colour lies outside sRGB.
struct WavelengthBand {
    double nanometres = 0.0;
    glm::dvec3 weight{0.0};
};
std::vector<WavelengthBand> wavelength_bands(int count);

}  // namespace lancer
