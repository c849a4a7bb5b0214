#include "lancer/spectrum/upsample.h"

#include <algorithm>
#include <cmath>

#include "lancer/spectrum/illuminant.h"
#include "lancer/spectrum/upsample_grid.h"

namespace lancer {
namespace {

constexpr double darkest = 1e-24;  // below, a reflectance is 0

// A place on an axis with `count` entries: the entry below and how far the next one is.
struct Place {
    int entry;
    double fraction;
};

Place place_between(double place, int last) {
    const int entry = std::clamp(static_cast<int>(place), 0, last);
    return {entry, place - entry};
}

glm::dvec3 entry(int lightness, int saturation, int hue) {
    const int cell = (lightness * upsampling_saturations + saturation) * upsampling_hues + hue % upsampling_hues;
    const float* const values = upsampling_table().data() + 3 * cell;
    return {values[0], values[1], values[2]};
}

// From 0 to 6: red, yellow, green, cyan, blue, magenta, red.
double hue_of(const glm::dvec3& rgb, double high, double chroma) {
    const double hue = high == rgb.x   ? (rgb.y - rgb.z) / chroma
                       : high == rgb.y ? 2.0 + (rgb.z - rgb.x) / chroma
                                       : 4.0 + (rgb.x - rgb.y) / chroma;
    return hue < 0.0 ? hue + 6.0 : hue;
}

// Of colours whose largest and smallest component sum to at most 1.
glm::dvec3 dark_coefficients(const glm::dvec3& rgb) {
    const double high = std::max({rgb.x, rgb.y, rgb.z}), low = std::min({rgb.x, rgb.y, rgb.z});
    const double lightness = 0.5 * (high + low), chroma = high - low;
    glm::dvec3 value(0.0);
    if (chroma > 0.0) {
        const double hue = hue_of(rgb, high, chroma), sixth = std::floor(hue);
        const Place h = place_between((sixth + to_even_ends(hue - sixth)) * (upsampling_hues / 6), upsampling_hues - 1);
        const Place s =
            place_between(to_even_end(std::min(chroma / (high + low), 1.0)) * (upsampling_saturations - 1), upsampling_saturations - 2);
        const Place l =
            place_between(to_even_ends(std::min(2.0 * lightness, 1.0)) * (upsampling_lightnesses - 1), upsampling_lightnesses - 2);
        for (int corner = 0; corner < 8; ++corner) {
            const int dh = corner & 1, ds = (corner >> 1) & 1, dl = corner >> 2;
            const double weight =
                (dh ? h.fraction : 1.0 - h.fraction) * (ds ? s.fraction : 1.0 - s.fraction) * (dl ? l.fraction : 1.0 - l.fraction);
            value += weight * entry(l.entry + dl, s.entry + ds, h.entry + dh);
        }
    }
    value.z += lightness - 0.5;
    return value / upsampling_divisor(lightness);
}

double within_unit(double x) { return x > 0.0 ? std::min(x, 1.0) : 0.0; }

}  // namespace

double SmoothSpectrum::at(double nanometres) const {
    const double t = (nanometres - upsampling_middle) / upsampling_spread;
    const double p = (coefficients.x * t + coefficients.y) * t + coefficients.z;
    // 1/2 + p / (2 sqrt(1 + p^2)) without the difference of nearly equal numbers.
    const double squeezed = 1.0 / (1.0 + p * p);
    const double dark = squeezed < darkest ? 0.0 : 0.5 * squeezed / (1.0 + std::fabs(p) * std::sqrt(squeezed));
    return p < 0.0 ? dark : 1.0 - dark;
}

SmoothSpectrum smooth_reflectance(const glm::dvec3& rgb) {
    const glm::dvec3 c(within_unit(rgb.x), within_unit(rgb.y), within_unit(rgb.z));
    const bool bright = std::max({c.x, c.y, c.z}) + std::min({c.x, c.y, c.z}) > 1.0;
    return {bright ? -dark_coefficients(1.0 - c) : dark_coefficients(c)};
}

SmoothLight smooth_light(const glm::dvec3& rgb) {
    const double brightest = std::max({rgb.x, rgb.y, rgb.z, 0.0});
    if (!(brightest > 0.0)) {
        return {};
    }
    return {2.0 * brightest, smooth_reflectance(rgb / (2.0 * brightest))};
}

double SmoothLight::at(double nanometres) const { return scale * shape.at(nanometres) * unit_d65().at(nanometres); }

}  // namespace lancer
