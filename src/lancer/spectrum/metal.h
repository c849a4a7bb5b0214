// Refractive indices of metals.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lancer/spectrum/curve.h"

namespace lancer {

// The complex index n + i k over the visible wavelengths, in air.
struct Metal {
    SpectralCurve n;
    SpectralCurve k;
};

// By chemical symbol ("Ag", "Au", ...) or common name ("silver", "gold", "aluminum", "brass", ...); letter case, spaces, hyphens and
// underscores make no difference.
std::optional<Metal> find_metal(std::string_view name);
std::vector<std::string> metal_names();  // common names first, then symbols

// The share of light in air that a metal reflects at normal incidence, without polarisation [Fresnel 1823].
double normal_reflectance(double n, double k);

}  // namespace lancer
