#include "lancer/import/mitsuba/colors.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "lancer/import/mesh/mesh_messages.h"
#include "lancer/import/mitsuba/values.h"
#include "lancer/spectrum/curve_file.h"
#include "lancer/spectrum/illuminant.h"
#include "lancer/spectrum/observer.h"
#include "lancer/spectrum/sensor.h"

namespace lancer::mitsuba {

scene::Color equal_energy(double value) {
    const double last = coarse_grid.first + coarse_grid.step * (coarse_grid.count - 1);
    return scene::Spectrum{scene::MeasuredSpectrum{{coarse_grid.first, last}, {1.0, 1.0}}, value, std::nullopt, scene::Rgb(1.0)};
}

namespace {

double decode_srgb(double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); }

// "#8040ff"
std::optional<Color> hexadecimal(std::string_view text) {
    if (text.size() != 7 || text[0] != '#') {
        return std::nullopt;
    }
    Color color(0.0);
    for (int i = 0; i < 3; ++i) {
        int byte = 0;
        for (int k = 0; k < 2; ++k) {
            const char c = text[static_cast<std::size_t>(1 + 2 * i + k)];
            const int digit = c >= '0' && c <= '9'   ? c - '0'
                              : c >= 'a' && c <= 'f' ? c - 'a' + 10
                              : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                                     : -1;
            if (digit < 0) {
                return std::nullopt;
            }
            byte = byte * 16 + digit;
        }
        color[i] = byte / 255.0;
    }
    return color;
}

Color rgb_of(Builder& builder, const Element& element, Role role) {
    const std::string& value = element.attribute("value");
    auto color = hexadecimal(value);
    color = color ? color : parse_three(value);
    if (!color) {
        builder.error(element.position, fmt::format("expected one or three numbers or #rrggbb, found {}", quoted(value)));
        return Color(0.0);
    }
    if (element.tag == "srgb") {
        *color = {decode_srgb(color->x), decode_srgb(color->y), decode_srgb(color->z)};
    }
    if (role == Role::share && (std::max({color->x, color->y, color->z}) > 1.0 || std::min({color->x, color->y, color->z}) < 0.0)) {
        builder.context.diagnostics.warning(element.position, fmt::format("{}: a share is from 0 to 1; it is moved there", quoted(value)));
        *color = glm::clamp(*color, 0.0, 1.0);
    }
    return glm::max(*color, 0.0);
}

scene::Color spectrum(std::vector<double> nanometres, std::vector<double> values) {
    return scene::Spectrum{scene::MeasuredSpectrum{std::move(nanometres), std::move(values)}, 1.0, std::nullopt};
}

// A spectrum is nothing beyond the wavelengths that are written, whatever it is of.
scene::Color measured(const WavelengthValues& written, Role role) {
    WavelengthValues curve = written;
    curve.nanometres.insert(curve.nanometres.begin(), curve.nanometres.front() - 1e-3);
    curve.values.insert(curve.values.begin(), 0.0);
    curve.nanometres.push_back(curve.nanometres.back() + 1e-3);
    curve.values.push_back(0.0);
    for (double& value : curve.values) {
        value = role == Role::share ? std::clamp(value, 0.0, 1.0) : std::max(value, 0.0);
    }
    return spectrum(std::move(curve.nanometres), std::move(curve.values));
}

// Before version 3 light of that kind was white.
scene::Color uniform(const Builder& builder, double value, Role role) {
    if (role == Role::light && builder.document.major_version() >= 3) {
        return equal_energy(value);
    }
    return Color(role == Role::share ? std::clamp(value, 0.0, 1.0) : value);
}

scene::Color from_file(Builder& builder, const std::string& name, const SourcePosition& position, Role role) {
    const std::string path = builder.document.resolve(name, position);
    const auto bytes = builder.context.files.open(path, position);
    const auto curves =
        bytes ? parse_curves(bytes->view(), path, 1, SpectralCurve::Beyond::constant, builder.context.diagnostics) : std::nullopt;
    return curves ? measured({curves->front().nanometres(), curves->front().values()}, role) : scene::Color();
}

scene::Color spectrum_of(Builder& builder, const Element& element, Role role) {
    if (element.find("filename")) {
        return from_file(builder, element.attribute("filename"), element.position, role);
    }
    const std::string& value = element.attribute("value");
    if (const auto number = parse_number(value)) {
        return uniform(builder, *number, role);
    }
    if (const auto curve = parse_wavelengths(value)) {
        return measured(*curve, role);
    }
    // Three numbers are RGB, as version 0.x has it.
    if (const auto three = parse_three(value)) {
        return glm::max(*three, 0.0);
    }
    builder.error(element.position,
                  fmt::format("expected a number or wavelengths that rise, as \"400:0.1, 700:0.9\", found {}", quoted(value)));
    return Color(0.0);
}

scene::Color black_body(double kelvin, double scale) {
    if (!(kelvin > 0.0 && scale > 0.0)) {
        return {};
    }
    // W/(m2 sr nm): as bright as such light is under the eye's curve.
    return scene::Spectrum{scene::BlackbodySpectrum{kelvin}, 1.0, to_xyz(blackbody(kelvin)).y * scale};
}

scene::Color illuminant(Builder& builder, Plugin& plugin) {
    const double scale = plugin.number("scale", 1.0);
    const Element* color = plugin.find({"color", "value"});
    return visible(color ? color_of(builder, *color, Role::light).value_or(Color(1.0)) : Color(1.0), Role::light) * scale;
}

// A texture or spectrum plugin that is the same everywhere.
std::optional<scene::Color> plugin_color(Builder& builder, const Element& element, Role role) {
    Plugin plugin = builder.plugin(element);
    std::optional<scene::Color> color;
    if (plugin.type() == "d65") {
        color = illuminant(builder, plugin);
    } else if (plugin.type() == "srgb") {
        color = color_or(builder, plugin, "color", Color(1.0), role);
    } else if (plugin.type() == "rawconstant") {
        color = plugin.vector("value", glm::dvec3(0.0));
    } else if (plugin.type() == "uniform") {
        color = uniform(builder, plugin.number("value", 1.0), role);
        plugin.ignore("wavelength_min");
        plugin.ignore("wavelength_max");
    } else if (plugin.type() == "blackbody") {
        color = black_body(plugin.number("temperature", 5000.0, 1.0, 1e6), plugin.number("scale", 1.0));
        plugin.ignore("wavelength_min");
        plugin.ignore("wavelength_max");
    } else if (plugin.type() == "regular" || plugin.type() == "irregular") {
        const auto values = parse_numbers(plugin.text("values", ""));
        auto nanometres = parse_numbers(plugin.text("wavelengths", ""));
        const double low = plugin.number("wavelength_min", 360.0), high = plugin.number("wavelength_max", 830.0);
        if (values && plugin.type() == "regular") {
            nanometres.emplace();
            for (std::size_t i = 0; i < values->size(); ++i) {
                const auto last = static_cast<double>(std::max<std::size_t>(values->size() - 1, 1));
                nanometres->push_back(low + (high - low) * static_cast<double>(i) / last);
            }
        }
        if (!values || !nanometres || values->empty() || values->size() != nanometres->size() ||
            std::adjacent_find(nanometres->begin(), nanometres->end(), std::greater_equal<>()) != nanometres->end()) {
            builder.error(plugin.position(), "expected wavelengths that rise and as many values");
            return scene::Color();
        }
        color = measured({*nanometres, *values}, role);
    } else {
        return std::nullopt;
    }
    plugin.finish();
    builder.honoured(plugin);
    return color;
}

}  // namespace

std::optional<scene::Color> color_of(Builder& builder, const Element& element, Role role) {
    if (element.tag == "rgb" || element.tag == "srgb" || element.tag == "color") {
        return scene::Color(rgb_of(builder, element, role));
    }
    if ((element.tag == "spectrum" || element.tag == "texture") && element.find("type")) {
        return plugin_color(builder, element, role);
    }
    if (element.tag == "spectrum") {
        return spectrum_of(builder, element, role);
    }
    if (element.tag == "blackbody") {
        const auto kelvin =
            parse_number(element.attribute("temperature").substr(0, element.attribute("temperature").find_last_of("0123456789.") + 1));
        const double scale = parse_number(element.attribute("scale")).value_or(1.0);
        if (!kelvin) {
            builder.error(element.position, "<blackbody> needs a \"temperature\" in kelvin");
        }
        return black_body(kelvin.value_or(0.0), scale);
    }
    if (element.tag == "float" || element.tag == "integer") {
        const auto number = parse_number(element.attribute("value"));
        if (!number) {
            builder.error(element.position, fmt::format("expected a number, found {}", quoted(element.attribute("value"))));
        }
        return uniform(builder, number.value_or(0.0), role);
    }
    if (element.tag == "vector" || element.tag == "point") {
        return scene::Color(vector_of(element, 0.0, builder.context.diagnostics));
    }
    return std::nullopt;
}

scene::Color color_or(Builder& builder, Plugin& plugin, std::string_view name, const Color& preset, Role role) {
    const Element* element = plugin.find(name);
    if (!element) {
        return preset;
    }
    const auto color = color_of(builder, *element, role);
    if (!color) {
        builder.context.report.dropped(
            fmt::format("{}: \"{}\" by a {} {}", plugin.title(), name, element->tag, quoted(element->attribute("type"))),
            "only colours that are the same everywhere are read here", element->position);
    }
    return color.value_or(preset);
}

Color visible(const scene::Color& color, Role role) {
    if (!color.spectrum) {
        return color.rgb;
    }
    const scene::Spectrum& spectrum = *color.spectrum;
    if (spectrum.as_rgb) {
        return *spectrum.as_rgb * spectrum.scale;
    }
    if (const auto* measured_values = std::get_if<scene::MeasuredSpectrum>(&spectrum.shape)) {
        const SpectralCurve curve(measured_values->nanometres, measured_values->values,
                                  role == Role::light ? SpectralCurve::Beyond::zero : SpectralCurve::Beyond::constant);
        return glm::max(role == Role::light ? to_rgb(curve) : reflected_rgb(curve), 0.0) * spectrum.scale;
    }
    const auto* black = std::get_if<scene::BlackbodySpectrum>(&spectrum.shape);
    return black ? glm::max(to_rgb(with_unit_luminance(blackbody(black->kelvin))), 0.0) * spectrum.luminance.value_or(1.0) : Color(1.0);
}

std::optional<scene::Index> index_curve_or_nothing(Builder& builder, Plugin& plugin, std::string_view name, double outside) {
    if (!plugin.has(name)) {
        return std::nullopt;
    }
    const scene::Color color = color_or(builder, plugin, name, Color(1.0), Role::index);
    if (!color.spectrum) {
        return color.rgb / outside;
    }
    const auto* values = std::get_if<scene::MeasuredSpectrum>(&color.spectrum->shape);
    if (!values) {
        return visible(color, Role::index) / outside;
    }
    scene::MeasuredSpectrum curve = *values;
    for (double& value : curve.values) {
        value /= outside;
    }
    return curve;
}

}  // namespace lancer::mitsuba
