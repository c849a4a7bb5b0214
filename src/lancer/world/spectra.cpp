#include "lancer/world/spectra.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "lancer/spectrum/illuminant.h"
#include "lancer/spectrum/metal.h"
#include "lancer/spectrum/sensor.h"
#include "lancer/spectrum/upsample.h"

namespace lancer {

namespace {

// A formula at each nanometre that the renderer knows.
template <class Formula>
SpectralCurve tabulated(SpectralCurve::Beyond beyond, const Formula& formula) {
    std::vector<double> nanometres, values;
    for (int i = 0; i < fine_grid.count; ++i) {
        nanometres.push_back(fine_grid.first + i * fine_grid.step);
        values.push_back(formula(nanometres.back()));
    }
    return {std::move(nanometres), std::move(values), beyond};
}

SpectralCurve unit_illuminant(const std::string& name) {
    const auto found = find_illuminant(name);
    assert(found);
    return with_unit_luminance(found.value());
}

struct ReflectanceOf {
    SpectralCurve operator()(const scene::MeasuredSpectrum& s) const { return index_curve(s); }
    SpectralCurve operator()(const scene::MetalSpectrum& s) const {
        const auto metal = find_metal(s.name);
        assert(metal);
        return tabulated(SpectralCurve::Beyond::constant,
                         [&](double nm) { return normal_reflectance(metal.value().n.at(nm), metal.value().k.at(nm)); });
    }
    SpectralCurve operator()(const scene::TintedSpectrum& s) const {
        return tabulated(SpectralCurve::Beyond::constant, [smooth = smooth_reflectance(s.rgb)](double nm) { return smooth.at(nm); });
    }
    // Lights are no reflectances; the importers refuse them.
    template <class Light>
    SpectralCurve operator()(const Light&) const {
        assert(false);
        return SpectralCurve(0.0);
    }
};

struct LightOf {
    SpectralCurve operator()(const scene::MeasuredSpectrum& s) const { return {s.nanometres, s.values, SpectralCurve::Beyond::zero}; }
    SpectralCurve operator()(const scene::IlluminantSpectrum& s) const { return unit_illuminant(s.name); }
    SpectralCurve operator()(const scene::BlackbodySpectrum& s) const { return with_unit_luminance(blackbody(s.kelvin)); }
    SpectralCurve operator()(const scene::DaylightSpectrum& s) const { return with_unit_luminance(daylight(s.kelvin)); }
    SpectralCurve operator()(const scene::MetalSpectrum&) const {
        assert(false);  // no light; the importers refuse it
        return SpectralCurve(0.0);
    }
    SpectralCurve operator()(const scene::TintedSpectrum& s) const {
        const SmoothLight smooth = smooth_light(s.rgb);
        const SpectralCurve lit = s.illuminant.empty() ? unit_d65() : unit_illuminant(s.illuminant);
        return tabulated(SpectralCurve::Beyond::zero, [&](double nm) { return smooth.scale * smooth.shape.at(nm) * lit.at(nm); });
    }
};

}  // namespace

SpectralCurve index_curve(const scene::MeasuredSpectrum& measured) {
    return {measured.nanometres, measured.values, SpectralCurve::Beyond::constant};
}

SpectralCurve reflectance_curve(const scene::Spectrum& spectrum) {
    return std::visit(ReflectanceOf{}, spectrum.shape).scaled(spectrum.scale);
}

SpectralCurve light_curve(const scene::Spectrum& spectrum) {
    const SpectralCurve curve = std::visit(LightOf{}, spectrum.shape);
    return spectrum.luminance ? with_unit_luminance(curve).scaled(*spectrum.luminance * spectrum.scale) : curve.scaled(spectrum.scale);
}

SpectralCurve clearness(const SpectralCurve& absorption, double depth) {
    return tabulated(SpectralCurve::Beyond::constant, [&](double nm) { return std::exp(-absorption.at(nm) * depth); });
}

scene::Rgb reflected(const scene::Color& color) {
    return color.spectrum ? glm::max(reflected_rgb(reflectance_curve(*color.spectrum)), scene::Rgb(0.0)) : color.rgb;
}

scene::Rgb emitted(const scene::Color& color) {
    if (color.spectrum && color.spectrum->as_rgb) {
        return *color.spectrum->as_rgb * color.spectrum->scale;
    }
    return color.spectrum ? glm::max(to_rgb(light_curve(*color.spectrum)), scene::Rgb(0.0)) : color.rgb;
}

double brightness(const glm::vec3& rgb) { return std::max(0.0, glm::dot(glm::dvec3(rgb), glm::dvec3(0.2126, 0.7152, 0.0722))); }

}  // namespace lancer
