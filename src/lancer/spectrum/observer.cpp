#include "lancer/spectrum/observer.h"

#include "lancer/spectrum/cie_1931.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace lancer {
namespace {

glm::dvec3 table_at(int i) {
    const auto& row = cie_1931_table[static_cast<std::size_t>(i)];
    return {row[0], row[1], row[2]};
}

// XYZ of a chromaticity at luminance 1.
glm::dvec3 xyz_of(double x, double y) { return {x / y, 1.0, (1.0 - x - y) / y}; }

glm::dvec3 standard_white() { return xyz_of(0.3127, 0.3290); }  // D65

// Where the table's wavelengths count as visible: beyond them, luminance is below a thousandth of the peak.
constexpr double visible_from = 380.0;  // nm
constexpr double visible_to = 730.0;    // nm

// What the observer sees of an equal-energy spectrum between two wavelengths.
struct Seen {
    glm::dvec3 xyz{0.0};
    double moment = 0.0;  // of x + y + z about 0 nm
};

// Exact: the curves are straight between tabulated values, so that Simpson's rule on each piece integrates even their first moment.
Seen integrate(double from, double to) {
    Seen seen;
    double a = from;
    while (a < to) {
        const double knot = (std::floor((a - cie_1931_first) / cie_1931_step) + 1.0) * cie_1931_step + cie_1931_first;
        const double b = std::fmin(knot, to);
        const double middle = 0.5 * (a + b);
        const glm::dvec3 at_a = cie_1931(a), at_middle = cie_1931(middle), at_b = cie_1931(b);
        const auto sum = [](const glm::dvec3& v) { return v.x + v.y + v.z; };
        seen.xyz += (b - a) / 6.0 * (at_a + 4.0 * at_middle + at_b);
        seen.moment += (b - a) / 6.0 * (a * sum(at_a) + 4.0 * middle * sum(at_middle) + b * sum(at_b));
        a = b;
    }
    return seen;
}

// Divides by the total, in whole multiples of 2^-50: such numbers add without rounding, so that the weights sum to exactly 1 in any order.
// What rounding leaves over goes to the strongest band.
void normalise(std::vector<WavelengthBand>& bands, int channel) {
    constexpr double grain = 0x1p-50;
    double total = 0.0;
    for (const WavelengthBand& band : bands) {
        total += band.weight[channel];
    }
    WavelengthBand* strongest = &bands.front();
    double sum = 0.0;
    for (WavelengthBand& band : bands) {
        double& weight = band.weight[channel];
        weight = std::nearbyint(weight / total / grain) * grain;
        sum += weight;
        if (weight > strongest->weight[channel]) {
            strongest = &band;
        }
    }
    strongest->weight[channel] += 1.0 - sum;
}

}  // namespace

glm::dvec3 cie_1931(double wavelength_nm) {
    const double place = (wavelength_nm - cie_1931_first) / cie_1931_step;
    if (!(place >= 0.0 && place <= cie_1931_count - 1)) {
        return glm::dvec3(0.0);
    }
    const int i = std::min(static_cast<int>(place), cie_1931_count - 2);
    const double t = place - i;
    return table_at(i) * (1.0 - t) + table_at(i + 1) * t;
}

double cie_1931_area() {
    double sum = 0.0;
    for (int i = 0; i < cie_1931_count; ++i) {
        sum += table_at(i).y * (i == 0 || i + 1 == cie_1931_count ? 0.5 : 1.0);
    }
    return sum * cie_1931_step;
}

// The columns are the primaries' XYZ, scaled so that (1, 1, 1) is the white. From the chromaticities, not from the four-digit matrix that
// the standard prints, so that both directions are inverse to each other to the last digits.
glm::dmat3 rgb_to_xyz_matrix(const glm::dvec3& white) {
    const glm::dmat3 primaries(xyz_of(0.64, 0.33), xyz_of(0.30, 0.60), xyz_of(0.15, 0.06));
    const glm::dvec3 scale = glm::inverse(primaries) * white;
    return {primaries[0] * scale.x, primaries[1] * scale.y, primaries[2] * scale.z};
}

glm::dvec3 xyz_to_rgb(const glm::dvec3& xyz) {
    static const glm::dmat3 matrix = glm::inverse(rgb_to_xyz_matrix(standard_white()));
    return matrix * xyz;
}

glm::dvec3 rgb_to_xyz(const glm::dvec3& rgb) {
    static const glm::dmat3 matrix = rgb_to_xyz_matrix(standard_white());
    return matrix * rgb;
}

std::vector<WavelengthBand> wavelength_bands(int count) {
    assert(count >= 1);
    std::vector<WavelengthBand> bands;
    const double width = (visible_to - visible_from) / count;
    for (int i = 0; i < count; ++i) {
        const Seen seen = integrate(visible_from + i * width, i + 1 == count ? visible_to : visible_from + (i + 1) * width);
        bands.push_back({seen.moment / (seen.xyz.x + seen.xyz.y + seen.xyz.z), xyz_to_rgb(seen.xyz)});
    }
    for (int channel = 0; channel < 3 && !bands.empty(); ++channel) {
        normalise(bands, channel);
    }
    return bands;
}

}  // namespace lancer
