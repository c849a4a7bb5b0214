// Colours as the author wrote them: linear RGB, or a spectrum.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <glm/vec3.hpp>

namespace lancer::scene {

using Rgb = glm::dvec3;  // linear, sRGB (Rec. 709) primaries, D65 white

// Straight lines between values at strictly rising wavelengths in nm. Beyond them a share, an index or an absorption is as at that end, and a
// light is 0.
struct MeasuredSpectrum {
    std::vector<double> nanometres;
    std::vector<double> values;
};

struct IlluminantSpectrum {
    std::string name;  // a name that spectrum/illuminant.h knows
};

struct BlackbodySpectrum {
    double kelvin = 2700.0;
};

struct DaylightSpectrum {
    double kelvin = 6500.0;  // 4000 to 25000
};

// What a metal mirrors when looked at straight on.
struct MetalSpectrum {
    std::string name;  // a name that spectrum/metal.h knows
};

// The smooth spectrum of a colour, times an illuminant.
struct TintedSpectrum {
    Rgb rgb{1.0};
    std::string illuminant;  // empty: none
};

// Illuminants, black bodies and daylight have luminance 1: they are as bright as the colour [1, 1, 1]. Measured lights are as they were measured,
// where 1 at every wavelength has luminance 1.
struct Spectrum {
    std::variant<MeasuredSpectrum, IlluminantSpectrum, BlackbodySpectrum, DaylightSpectrum, MetalSpectrum, TintedSpectrum> shape;
    double scale = 1.0;                        // times this
    std::optional<double> luminance;           // of lights: scaled to it first
    std::optional<Rgb> as_rgb = std::nullopt;  // of lights: what, times `scale`, it is where light is red, green and blue; else its colour
};

struct Color {
    Color() = default;
    Color(const Rgb& linear) : rgb(linear) {}
    Color(double red, double green, double blue) : rgb(red, green, blue) {}
    Color(Spectrum written) : spectrum(std::make_shared<const Spectrum>(std::move(written))) {}

    bool operator==(const Color&) const = default;  // spectra: the same object

    Rgb rgb{0.0};
    std::shared_ptr<const Spectrum> spectrum;  // null: `rgb` is meant
};

}  // namespace lancer::scene
