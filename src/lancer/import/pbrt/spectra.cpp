#include "lancer/import/pbrt/spectra.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "lancer/import/pbrt/files.h"
#include "lancer/import/pbrt/named_spectra.h"
#include "lancer/spectrum/curve_file.h"
#include "lancer/spectrum/illuminant.h"
#include "lancer/spectrum/observer.h"
#include "lancer/spectrum/sensor.h"
#include "lancer/spectrum/upsample.h"

namespace lancer::pbrt {

namespace {

Color measured(std::vector<double> nanometres, std::vector<double> values, std::optional<double> luminance) {
    return scene::Spectrum{scene::MeasuredSpectrum{std::move(nanometres), std::move(values)}, 1.0, luminance};
}

bool is_rgb(const Parameter& parameter) { return parameter.type == "rgb" || parameter.type == "color"; }

std::optional<scene::Rgb> read_triple(const Parameters& parameters, const Parameter& parameter) {
    const std::vector<double> numbers = parameters.numbers_of(parameter);
    if (numbers.size() != 3) {
        parameters.error(parameter, fmt::format("\"{}\" needs three numbers", parameter.name));
        return std::nullopt;
    }
    return scene::Rgb(numbers[0], numbers[1], numbers[2]);
}

// Pairs of a wavelength and a value; what pbrt takes in any order rises here.
std::optional<SpectralCurve> from_pairs(const Parameters& parameters, const Parameter& parameter, const std::vector<double>& numbers) {
    std::vector<std::size_t> order(numbers.size() / 2);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return numbers[2 * a] < numbers[2 * b]; });
    std::vector<double> nanometres, values;
    for (const std::size_t i : order) {
        if (nanometres.empty() || numbers[2 * i] > nanometres.back()) {
            nanometres.push_back(numbers[2 * i]);
            values.push_back(numbers[2 * i + 1]);
        }
    }
    if (numbers.size() % 2 != 0 || nanometres.empty()) {
        parameters.error(parameter, fmt::format("\"{}\" needs pairs of a wavelength in nm and a value", parameter.name));
        return std::nullopt;
    }
    return SpectralCurve(std::move(nanometres), std::move(values), SpectralCurve::Beyond::zero);
}

std::optional<SpectralCurve> from_name(const Parameters& parameters, const Parameter& parameter) {
    const std::vector<std::string> names = parameters.strings_of(parameter);
    if (names.size() != 1) {
        parameters.error(parameter, fmt::format("\"{}\" needs the name of a spectrum or of a file with one", parameter.name));
        return std::nullopt;
    }
    if (auto known = find_named_spectrum(names[0])) {
        return known;
    }
    ImportContext& context = parameters.context();
    const SourcePosition position = Parameters::position_of(parameter);
    const std::string path = find_file(context, names[0], *parameter.text);
    const auto bytes = context.files.open(path, position);
    if (!bytes) {
        return std::nullopt;
    }
    auto curves = parse_curves(bytes->view(), path, 1, SpectralCurve::Beyond::zero, context.diagnostics);
    return curves ? std::optional(std::move(curves->front())) : std::nullopt;
}

// A curve that is 0 beyond its ends; nothing for rgb.
std::optional<SpectralCurve> read_measured(const Parameters& parameters, const Parameter& parameter) {
    if (parameter.values.find('"') != std::string_view::npos) {
        return from_name(parameters, parameter);
    }
    const std::vector<double> numbers = parameters.numbers_of(parameter);
    if (parameter.type == "blackbody") {
        if (numbers.empty() || numbers.size() > 2 || !(numbers[0] > 0.0)) {
            parameters.error(parameter, fmt::format("\"{}\" needs a temperature in kelvin", parameter.name));
            return std::nullopt;
        }
        const SpectralCurve light = with_unit_luminance(blackbody(numbers[0]));
        return numbers.size() == 2 ? light.scaled(numbers[1]) : light;  // version 3 wrote a scale after it
    }
    if (numbers.size() == 1) {
        return SpectralCurve({360.0, 830.0}, {numbers[0], numbers[0]}, SpectralCurve::Beyond::zero);
    }
    return from_pairs(parameters, parameter, numbers);
}

}  // namespace

std::optional<Color> read_share(const Parameters& parameters, const Parameter& parameter, ColorSpace space) {
    if (is_rgb(parameter)) {
        const auto rgb = read_triple(parameters, parameter);
        return rgb ? std::optional<Color>(scene::Rgb(glm::clamp(share_to_srgb(space, *rgb), 0.0, 1.0))) : std::nullopt;
    }
    if (parameter.type == "xyz") {
        const auto xyz = read_triple(parameters, parameter);
        return xyz ? std::optional<Color>(scene::Rgb(glm::clamp(xyz_to_rgb(*xyz), 0.0, 1.0))) : std::nullopt;
    }
    const auto curve = read_measured(parameters, parameter);
    if (!curve) {
        return std::nullopt;
    }
    std::vector<double> values = curve->values();
    for (double& value : values) {
        value = std::clamp(value, 0.0, 1.0);
    }
    return measured(curve->nanometres(), std::move(values), std::nullopt);
}

std::optional<Color> read_light(const Parameters& parameters, const Parameter& parameter, ColorSpace space, bool version3) {
    if (is_rgb(parameter)) {
        const auto rgb = read_triple(parameters, parameter);
        return rgb ? std::optional<Color>(scene::Rgb(glm::max(light_to_srgb(space, *rgb), 0.0))) : std::nullopt;
    }
    if (parameter.type == "xyz") {
        const auto xyz = read_triple(parameters, parameter);
        return xyz ? std::optional<Color>(scene::Rgb(glm::max(xyz_to_rgb(*xyz), 0.0))) : std::nullopt;
    }
    const auto curve = read_measured(parameters, parameter);
    if (!curve) {
        return std::nullopt;
    }
    std::vector<double> values = curve->values();
    for (double& value : values) {
        value = std::max(value, 0.0);
    }
    return measured(curve->nanometres(), std::move(values), version3 ? std::nullopt : std::optional(1.0));
}

scene::Rgb visible(const Color& share) {
    const auto* values = share.spectrum ? std::get_if<scene::MeasuredSpectrum>(&share.spectrum->shape) : nullptr;
    if (!values) {
        return share.rgb;
    }
    const SpectralCurve curve(values->nanometres, values->values, SpectralCurve::Beyond::constant);
    return glm::clamp(reflected_rgb(curve) * share.spectrum->scale, 0.0, 1.0);
}

scene::Rgb visible_light(const Color& light) {
    const auto* values = light.spectrum ? std::get_if<scene::MeasuredSpectrum>(&light.spectrum->shape) : nullptr;
    if (!values) {
        return light.rgb;
    }
    const SpectralCurve curve(values->nanometres, values->values, SpectralCurve::Beyond::zero);
    const auto luminance = light.spectrum->luminance;
    return glm::max(to_rgb(luminance ? with_unit_luminance(curve).scaled(*luminance) : curve), 0.0) * light.spectrum->scale;
}

Color operator*(const Color& color, double factor) {
    if (!color.spectrum) {
        return Color(color.rgb * factor);
    }
    scene::Spectrum scaled = *color.spectrum;
    scaled.scale *= factor;
    return scaled;
}

std::optional<SpectralCurve> read_curve(const Parameters& parameters, const Parameter& parameter, ColorSpace space) {
    if (!is_rgb(parameter)) {
        const auto curve = read_measured(parameters, parameter);
        return curve ? std::optional(curve->with_ends(SpectralCurve::Beyond::constant)) : std::nullopt;
    }
    const auto rgb = read_triple(parameters, parameter);
    if (!rgb) {
        return std::nullopt;
    }
    const scene::Rgb color = glm::max(share_to_srgb(space, *rgb), 0.0);
    const double scale = 2.0 * std::max({color.x, color.y, color.z, 1e-30});
    const SmoothSpectrum smooth = smooth_reflectance(color / scale);
    std::vector<double> nanometres, values;
    for (int i = 0; i < coarse_grid.count; ++i) {
        nanometres.push_back(coarse_grid.first + i * coarse_grid.step);
        values.push_back(scale * smooth.at(nanometres.back()));
    }
    return SpectralCurve(std::move(nanometres), std::move(values), SpectralCurve::Beyond::constant);
}

std::optional<scene::Index> read_index(const Parameters& parameters, const Parameter& parameter, ColorSpace space) {
    if (is_rgb(parameter)) {
        const auto rgb = read_triple(parameters, parameter);
        return rgb ? std::optional<scene::Index>(glm::max(share_to_srgb(space, *rgb), 0.0)) : std::nullopt;
    }
    const auto curve = read_measured(parameters, parameter);
    if (!curve) {
        return std::nullopt;
    }
    if (!(curve->lowest() >= 0.0)) {
        parameters.error(parameter, fmt::format("\"{}\" must not be negative", parameter.name));
        return std::nullopt;
    }
    return scene::MeasuredSpectrum{curve->nanometres(), curve->values()};
}

}  // namespace lancer::pbrt
