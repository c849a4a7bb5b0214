#include "lancer/import/pbrt/conductors.h"

#include <glm/common.hpp>

#include "lancer/import/pbrt/facets.h"
#include "lancer/import/pbrt/named_spectra.h"
#include "lancer/import/pbrt/spectra.h"
#include "lancer/spectrum/metal.h"
#include "lancer/spectrum/sensor.h"

namespace lancer::pbrt {

namespace {

// The metal that both names mean, or an empty word.
std::string named_metal(const Parameters& parameters, const Parameter* eta, const Parameter* k) {
    const auto name = [&](const Parameter* parameter) {
        const bool named = parameter != nullptr && parameter->values.find('"') != std::string_view::npos;
        const std::vector<std::string> names = named ? parameters.strings_of(*parameter) : std::vector<std::string>();
        return names.size() == 1 ? metal_of(names[0]) : std::string();
    };
    const std::string one = eta != nullptr ? name(eta) : "Cu", other = k != nullptr ? name(k) : "Cu";
    return one == other ? one : std::string();
}

scene::Index index_of(const SpectralCurve& curve) { return scene::MeasuredSpectrum{curve.nanometres(), curve.values()}; }

SpectralCurve curve_of(const scene::Index& index, int channel) {
    const auto* measured = std::get_if<scene::MeasuredSpectrum>(&index);
    return measured ? SpectralCurve(measured->nanometres, measured->values, SpectralCurve::Beyond::constant)
                    : SpectralCurve(std::get<scene::Rgb>(index)[channel]);
}

// What it reflects of light that falls on it at right angles.
scene::Rgb head_on(const scene::Index& n, const scene::Index& k) {
    scene::Rgb color(0.0);
    for (int channel = 0; channel < 3; ++channel) {
        const SpectralCurve real = curve_of(n, channel), imaginary = curve_of(k, channel);
        std::vector<double> nanometres, values;
        for (int i = 0; i < coarse_grid.count; ++i) {
            nanometres.push_back(coarse_grid.first + i * coarse_grid.step);
            values.push_back(normal_reflectance(real.at(nanometres.back()), imaginary.at(nanometres.back())));
        }
        color[channel] = reflected_rgb(SpectralCurve(std::move(nanometres), std::move(values), SpectralCurve::Beyond::constant))[channel];
    }
    return glm::clamp(color, 0.0, 1.0);
}

}  // namespace

scene::ConductorMaterial read_conductor(const Recipe& recipe, const Textures& textures, const std::string& prefix, double roughness,
                                        bool version3) {
    const Parameters& parameters = recipe.parameters;
    scene::ConductorMaterial metal;
    metal.facets.once = true;
    const FacetValues facets = read_facets(recipe, textures, prefix, roughness, version3);
    metal.roughness = facets.roughness;
    metal.anisotropy = facets.anisotropy;
    if (parameters.has("reflectance")) {
        metal.color = textures.color(recipe, "reflectance", scene::Rgb(0.5));
        return metal;
    }
    const Parameter* eta = parameters.find(prefix + "eta");
    const Parameter* k = parameters.find(prefix + "k");
    metal.metal = named_metal(parameters, eta, k);
    if (!metal.metal.empty()) {
        return metal;
    }
    const Metal copper = find_metal("Cu").value();
    const auto n = eta != nullptr ? read_index(parameters, *eta, recipe.space) : index_of(copper.n);
    const auto imaginary = k != nullptr ? read_index(parameters, *k, recipe.space) : index_of(copper.k);
    metal.n = n.value_or(index_of(copper.n));
    metal.k = imaginary.value_or(index_of(copper.k));
    return metal;
}

scene::Texture head_on_color(const scene::ConductorMaterial& metal) {
    if (const auto named = find_metal(metal.metal)) {
        return scene::Color(head_on(index_of(named->n), index_of(named->k)));
    }
    return metal.n && metal.k ? scene::Texture(scene::Color(head_on(*metal.n, *metal.k))) : metal.color;
}

}  // namespace lancer::pbrt
