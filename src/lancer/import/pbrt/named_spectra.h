// The spectra that pbrt knows by name: "metal-Au-eta", "glass-BK7", "stdillum-D65", ...
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lancer/spectrum/curve.h"

namespace lancer::pbrt {

// 0 beyond its ends. Nothing for a name that is none, or that of a spectrum that we do not have.
std::optional<SpectralCurve> find_named_spectrum(std::string_view name);

// The metal of "metal-Au-eta" or "metal-Au-k", as spectrum/metal.h knows it; empty for other names.
std::string metal_of(std::string_view name);

// The glass of "glass-BK7", as spectrum/glass.h knows it; empty for other names.
std::string glass_of(std::string_view name);

}  // namespace lancer::pbrt
