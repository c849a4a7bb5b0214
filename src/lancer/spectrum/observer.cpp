#include "lancer/spectrum/observer.h"

#include "lancer/spectrum/cie_1931.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace lancer {
namespace {

glm::dvec3 table_at(int i) {
    const auto& row = cie_1931_table[static_cast<std::size_t>(i)];
    return {row[0], row[1], row[2]};
}

constexpr int fine_count = cie_1931_step * (cie_1931_count - 1) + 1;

// Beyond its ends, the table goes on as straight as it can without falling below 0.
glm::dvec3 continued_table_at(int i) {
    if (i < 0) {
        return i < -1 ? glm::dvec3(0.0) : glm::max(2.0 * table_at(0) - table_at(1), glm::dvec3(0.0));
    }
    if (i >= cie_1931_count) {
        const int last = cie_1931_count - 1;
        return glm::max(table_at(last) + static_cast<double>(i - last) * (table_at(last) - table_at(last - 1)), glm::dvec3(0.0));
    }
    return table_at(i);
}

// The polynomial of the fifth degree through y[2] and y[3] whose first two derivatives there are those of polynomials of the fourth degree
// through five neighbours [Sprague 1880].
glm::dvec3 sprague(const std::array<glm::dvec3, 6>& y, double t) {
    const glm::dvec3 a1 = 2.0 * y[0] - 16.0 * y[1] + 16.0 * y[3] - 2.0 * y[4];
    const glm::dvec3 a2 = -y[0] + 16.0 * y[1] - 30.0 * y[2] + 16.0 * y[3] - y[4];
    const glm::dvec3 a3 = -9.0 * y[0] + 39.0 * y[1] - 70.0 * y[2] + 66.0 * y[3] - 33.0 * y[4] + 7.0 * y[5];
    const glm::dvec3 a4 = 13.0 * y[0] - 64.0 * y[1] + 126.0 * y[2] - 124.0 * y[3] + 61.0 * y[4] - 12.0 * y[5];
    const glm::dvec3 a5 = 5.0 * (-y[0] + 5.0 * y[1] - 10.0 * y[2] + 10.0 * y[3] - 5.0 * y[4] + y[5]);
    return y[2] + t * (a1 + t * (a2 + t * (a3 + t * (a4 + t * a5)))) / 24.0;
}

std::array<glm::dvec3, fine_count> make_fine_table() {
    std::array<glm::dvec3, fine_count> table;
    for (int i = 0; i < fine_count; ++i) {
        const int before = std::min(i / cie_1931_step, cie_1931_count - 2);
        std::array<glm::dvec3, 6> neighbours;
        for (int k = 0; k < 6; ++k) {
            neighbours[static_cast<std::size_t>(k)] = continued_table_at(before - 2 + k);
        }
        const double t = static_cast<double>(i) / cie_1931_step - before;
        table[static_cast<std::size_t>(i)] = glm::max(sprague(neighbours, t), glm::dvec3(0.0));
    }
    return table;
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

glm::dvec3 cie_1931_fine(double wavelength_nm) {
    static const std::array<glm::dvec3, fine_count> table = make_fine_table();
    const double place = wavelength_nm - cie_1931_first;
    if (!(place >= 0.0 && place <= fine_count - 1)) {
        return glm::dvec3(0.0);
    }
    const auto i = static_cast<std::size_t>(std::min(place, fine_count - 2.0));
    const double t = place - static_cast<double>(i);
    return table[i] * (1.0 - t) + table[i + 1] * t;
}

double cie_1931_area() {
    static const double area = [] {
        double sum = -0.5 * (table_at(0).y + table_at(cie_1931_count - 1).y);
        for (int i = 0; i < fine_count; ++i) {
            sum += cie_1931_fine(cie_1931_first + i).y;
        }
        return sum;
    }();
    return area;
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
