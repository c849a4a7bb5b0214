#include "lancer/import/toml/spectra.h"

#include <fmt/format.h>

#include <algorithm>

#include "lancer/base/file.h"
#include "lancer/import/toml/colors.h"
#include "lancer/spectrum/illuminant.h"
#include "lancer/spectrum/metal.h"

namespace lancer::notation {

namespace {

// One of these says what kind of spectrum it is.
constexpr std::string_view kinds[] = {"illuminant", "blackbody", "daylight", "spectrum", "wavelengths", "metal", "rgb"};

bool is_share(const Key& key) { return key.range.most == 1.0; }
bool is_light(const Key& key) { return !is_share(key) && key.unit != "1/m"; }

std::string unknown(std::string_view what, const std::string& name, const std::vector<std::string>& known) {
    const std::string hint = did_you_mean(name, known);
    return fmt::format("there is no {} \"{}\"{}", what, name, hint.empty() ? "; known are " + some_of(known) : ";" + hint);
}

std::string illuminant_name(TableReader& reader) {
    const std::string name = reader.text("illuminant");
    if (!name.empty() && !find_illuminant(name)) {
        reader.error("illuminant", unknown("illuminant", name, illuminant_names()));
    }
    return name;
}

std::optional<scene::MeasuredSpectrum> from_file(Context& context, const toml::node& node, const std::string& file) {
    const auto curve = context.files.curve(path_beside(context.messages.file(), file), context.messages.at(node));
    return curve ? std::optional(scene::MeasuredSpectrum{curve->nanometres(), curve->values()}) : std::nullopt;
}

// The keys spectrum, wavelengths and values.
std::optional<scene::MeasuredSpectrum> measured(Context& context, TableReader& reader, const toml::table& table) {
    if (reader.has("spectrum")) {
        for (const char* key : {"wavelengths", "values"}) {
            if (reader.has(key)) {
                reader.error(key, fmt::format("a curve has either \"spectrum\", a file, or \"{}\"", key));
            }
        }
        const std::string file = reader.text("spectrum");
        return reader.good() ? from_file(context, *table.get("spectrum"), file) : std::nullopt;
    }
    scene::MeasuredSpectrum result{reader.numbers("wavelengths"), reader.numbers("values")};
    if (!reader.good()) {
        return std::nullopt;
    }
    const auto& nm = result.nanometres;
    if (const auto fall = std::adjacent_find(nm.begin(), nm.end(), [](double a, double b) { return !(a < b); }); fall != nm.end()) {
        reader.error("wavelengths", fmt::format("\"wavelengths\" must rise: {} nm comes after {} nm", fall[1], fall[0]));
    } else if (nm.empty() || nm.size() != result.values.size()) {
        reader.error("values", fmt::format("\"wavelengths\" and \"values\" belong together: as many of both, at least one, not {} and {}",
                                           nm.size(), result.values.size()));
    }
    return reader.good() ? std::optional(std::move(result)) : std::nullopt;
}

// Each value, times a factor, must keep to the key's range.
bool check_values(Context& context, const toml::node& at, const scene::MeasuredSpectrum& curve, double scale, const Key& key) {
    for (std::size_t i = 0; i < curve.values.size(); ++i) {
        if (!key.range.holds(curve.values[i] * scale)) {
            context.messages.error(context.messages.at(at), fmt::format("\"{}\" must be {}, not {:.6g} as at {:.6g} nm", key.name,
                                                                        to_words(key.range), curve.values[i] * scale, curve.nanometres[i]));
            return false;
        }
    }
    return true;
}

// What may stand for what: nothing when `kind` may stand here.
std::string objection(std::string_view kind, const TableReader& reader, const Key& key) {
    const bool light = is_light(key);
    if (!light && (kind == "illuminant" || kind == "blackbody" || kind == "daylight")) {
        return fmt::format("\"{}\" is a light; \"{}\" is {}", kind, key.name,
                           is_share(key) ? "a share of light, from 0 to 1" : "an absorption, in 1/m");
    }
    if (light && kind == "metal") {
        return fmt::format("\"metal\" is what a surface mirrors; \"{}\" is a light", key.name);
    }
    if (!light && !is_share(key) && kind != "spectrum" && kind != "wavelengths") {
        return fmt::format("\"{}\" is an absorption, in 1/m: write it as a color, or measured, with \"spectrum\" or \"wavelengths\"",
                           key.name);
    }
    for (const char* name : {"luminance", "as_rgb"}) {
        if (!light && reader.has(name)) {
            return fmt::format("\"{}\" is for lights; \"{}\" is none", name, key.name);
        }
    }
    return {};
}

std::string_view kind_of(TableReader& reader) {
    std::vector<std::string_view> written;
    for (std::string_view kind : kinds) {
        if (reader.has(kind) && !(kind == "illuminant" && reader.has("rgb")) && !(kind == "wavelengths" && reader.has("spectrum"))) {
            written.push_back(kind);
        }
    }
    if (written.empty()) {
        written.push_back("wavelengths");  // only values are there
    } else if (written.size() > 1) {
        reader.error(written[1], fmt::format("a spectrum has either \"{}\" or \"{}\"", written[0], written[1]));
    }
    return written.front();
}

}  // namespace

bool is_spectrum(const toml::table& table) {
    return !table.contains("type") && (table.contains("values") || std::any_of(std::begin(kinds), std::end(kinds),
                                                                               [&](std::string_view k) { return table.contains(k); }));
}

std::optional<scene::Spectrum> read_spectrum(Context& context, const toml::table& table, const Key& key) {
    TableReader reader(context.messages, table, spectrum());
    const std::string_view kind = kind_of(reader);
    scene::Spectrum result;
    result.scale = reader.number("scale");
    result.luminance = reader.number_if_written("luminance");
    if (reader.has("as_rgb")) {
        result.as_rgb = read_rgb(reader, "as_rgb");
    }
    if (reader.good()) {
        if (const std::string problem = objection(kind, reader, key); !problem.empty()) {
            reader.error(reader.has(kind) ? kind : "values", problem);
        }
    }
    if (!reader.good()) {
        return std::nullopt;
    }
    if (kind == "illuminant") {
        result.shape = scene::IlluminantSpectrum{illuminant_name(reader)};
    } else if (kind == "blackbody") {
        result.shape = scene::BlackbodySpectrum{reader.number("blackbody")};
    } else if (kind == "daylight") {
        result.shape = scene::DaylightSpectrum{reader.number("daylight")};
    } else if (kind == "metal") {
        const std::string name = reader.text("metal");
        if (reader.good() && !find_metal(name)) {
            reader.error("metal", unknown("metal", name, metal_names()));
        }
        result.shape = scene::MetalSpectrum{name};
        if (result.scale > 1.0) {
            reader.error("scale",
                         fmt::format("\"scale\" must be at most 1 here, not {}: no metal mirrors more light than there is", result.scale));
        }
    } else if (kind == "rgb") {
        const scene::Rgb rgb = read_rgb(reader, "rgb");
        result.shape = scene::TintedSpectrum{rgb, illuminant_name(reader)};
        if (is_share(key) && reader.has("illuminant")) {
            reader.error("illuminant", fmt::format("\"illuminant\" belongs to lights; \"{}\" is none", key.name));
        } else if (is_share(key) && std::max({rgb.x, rgb.y, rgb.z}) * std::max(result.scale, 1.0) > 1.0) {
            reader.error("rgb", fmt::format("\"{}\" must be {}", key.name, to_words(key.range)));
        }
    } else if (auto curve = measured(context, reader, table); curve && reader.good()) {
        const toml::node* at = table.get(reader.has("spectrum") ? "spectrum" : "values");
        if (!check_values(context, *at, *curve, result.scale, key)) {
            return std::nullopt;
        }
        result.shape = std::move(*curve);
    } else {
        return std::nullopt;
    }
    return reader.good() ? std::optional(std::move(result)) : std::nullopt;
}

std::optional<scene::MeasuredSpectrum> read_curve(Context& context, const toml::node& node, const Key& key) {
    std::optional<scene::MeasuredSpectrum> result;
    if (node.is_number()) {
        double number = 0.0;
        return read_number(context.messages, node, key, number) ? std::optional(scene::MeasuredSpectrum{{555.0}, {number}}) : std::nullopt;
    }
    if (const auto* file = node.as_string()) {
        result = from_file(context, node, file->get());
    } else if (const toml::table* table = node.as_table()) {
        TableReader reader(context.messages, *table, curve());
        result = reader.good() ? measured(context, reader, *table) : std::nullopt;
    } else {
        context.messages.error(context.messages.at(node),
                               fmt::format("\"{}\" must be a number, the name of a file, or {{ wavelengths, values }}, "
                                           "not {}",
                                           key.name, what_it_is(node)));
    }
    return result && check_values(context, node, *result, 1.0, key) ? result : std::nullopt;
}

}  // namespace lancer::notation
