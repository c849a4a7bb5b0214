#include "lancer/import/toml/colors.h"

#include <fmt/format.h>

#include <cmath>

#include "lancer/base/file.h"
#include "lancer/import/toml/spectra.h"

namespace lancer::notation {

namespace {

struct NamedColor {
    const char* name;
    unsigned rgb;
};

constexpr NamedColor named_colors[] = {
    {"black", 0x000000},  {"silver", 0xc0c0c0},  {"gray", 0x808080},  {"white", 0xffffff}, {"maroon", 0x800000}, {"red", 0xff0000},
    {"purple", 0x800080}, {"fuchsia", 0xff00ff}, {"green", 0x008000}, {"lime", 0x00ff00},  {"olive", 0x808000},  {"yellow", 0xffff00},
    {"orange", 0xffa500}, {"navy", 0x000080},    {"blue", 0x0000ff},  {"teal", 0x008080},  {"aqua", 0x00ffff}};

// [IEC 61966-2-1], in double; image/ has it for pixels.
double decode_srgb(unsigned byte) {
    const double v = byte / 255.0;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

scene::Rgb decode_srgb_triple(unsigned rgb) {
    return {decode_srgb(rgb >> 16 & 255u), decode_srgb(rgb >> 8 & 255u), decode_srgb(rgb & 255u)};
}

constexpr std::string_view expected_color = "a color: \"#rrggbb\", a name such as \"red\", or [r, g, b]";

scene::Checker read_checker(TableReader& reader) {
    scene::Checker texture;
    texture.first = read_rgb(reader, "first");
    texture.second = read_rgb(reader, "second");
    texture.size = reader.number("size");
    texture.solid = reader.flag("solid");
    return texture;
}

scene::ImageTexture read_image(Context& context, TableReader& reader, bool data) {
    scene::ImageTexture texture;
    texture.position = reader.position();
    const std::string file = reader.text("file");
    if (!file.empty()) {
        texture.file = path_beside(context.messages.file(), file);
        if (!context.files.image(texture, reader.position("file"))) {
            reader.spoil();
        }
    }
    texture.wrap = static_cast<scene::Wrap>(reader.choice("wrap"));
    if (reader.has("wrap_v")) {
        texture.wrap_v = static_cast<scene::Wrap>(reader.choice("wrap_v"));
    }
    const scene::Filter filters[] = {scene::Filter::mipmaps, scene::Filter::bilinear, scene::Filter::nearest};
    texture.filter = filters[reader.choice("filter")];
    texture.linear = reader.has("encoding") ? reader.choice("encoding") == 1 : data;
    texture.uv_set = reader.integer("uv_set");
    texture.scale = reader.vector2("scale");
    texture.rotation = reader.number("rotation");
    texture.offset = reader.vector2("offset");
    texture.tint = read_rgb(reader, "tint");
    texture.times_mesh_colors = reader.flag("vertex_colors");
    return texture;
}

}  // namespace

const std::vector<std::string>& color_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const NamedColor& color : named_colors) {
            all.emplace_back(color.name);
        }
        return all;
    }();
    return names;
}

std::optional<scene::Rgb> parse_color(std::string_view text) {
    for (const NamedColor& color : named_colors) {
        if (text == color.name) {
            return decode_srgb_triple(color.rgb);
        }
    }
    if ((text.size() != 4 && text.size() != 7) || text[0] != '#') {
        return std::nullopt;
    }
    unsigned rgb = 0;
    for (char c : text.substr(1)) {
        const char lower = static_cast<char>(c | 0x20);
        const bool digit = c >= '0' && c <= '9';
        if (!digit && !(lower >= 'a' && lower <= 'f')) {
            return std::nullopt;
        }
        const unsigned value = static_cast<unsigned>(digit ? c - '0' : lower - 'a' + 10);
        rgb = text.size() == 4 ? rgb << 8 | value * 17u : rgb << 4 | value;
    }
    return decode_srgb_triple(rgb);
}

std::optional<scene::Rgb> read_rgb(Messages& messages, const toml::node& node, const Key& key) {
    if (const auto* string = node.as_string()) {
        if (const auto color = parse_color(string->get())) {
            return color;
        }
        const bool hexadecimal = string->get().starts_with('#');
        std::string hint = hexadecimal ? ": a # needs three or six hexadecimal digits" : did_you_mean(string->get(), color_names());
        hint = !hexadecimal && !hint.empty() ? ";" + hint : hint;
        messages.error(messages.at(node), fmt::format("\"{}\" must be {}, not \"{}\"{}", key.name, expected_color, string->get(), hint));
        return std::nullopt;
    }
    scene::Rgb color(0.0);
    if (!node.is_array()) {
        messages.error(messages.at(node), fmt::format("\"{}\" must be {}, not {}", key.name, expected_color, what_it_is(node)));
    } else if (read_numbers(messages, node, key, 3, "[r, g, b]", &color.x)) {
        return color;
    }
    return std::nullopt;
}

scene::Rgb read_rgb(TableReader& reader, std::string_view name) {
    const Key& key = reader.described(name, Kind::rgb);
    const glm::dvec3* preset = std::get_if<glm::dvec3>(&key.preset);
    const toml::node* node = reader.value(name, Kind::rgb);
    const auto color = node ? read_rgb(reader.messages(), *node, key) : std::nullopt;
    if (node && !color) {
        reader.spoil();
    }
    return color.value_or(preset ? *preset : scene::Rgb(0.0));
}

std::optional<scene::Color> read_color(Context& context, const toml::node& node, const Key& key) {
    if (const toml::table* table = node.as_table(); table && is_spectrum(*table)) {
        const auto spectrum = read_spectrum(context, *table, key);
        return spectrum ? std::optional(scene::Color(*spectrum)) : std::nullopt;
    }
    const auto rgb = read_rgb(context.messages, node, key);
    return rgb ? std::optional(scene::Color(*rgb)) : std::nullopt;
}

std::optional<scene::Color> read_color_if_written(Context& context, TableReader& reader, std::string_view key) {
    const toml::node* node = reader.value(key, Kind::color);
    if (!node) {
        return std::nullopt;
    }
    const auto color = read_color(context, *node, reader.described(key, Kind::color));
    if (!color) {
        reader.spoil();
    }
    return color;
}

scene::Color read_color(Context& context, TableReader& reader, std::string_view key) {
    const glm::dvec3* preset = std::get_if<glm::dvec3>(&reader.described(key, Kind::color).preset);
    return read_color_if_written(context, reader, key).value_or(preset ? *preset : scene::Rgb(0.0));
}

scene::Texture read_texture(Context& context, TableReader& reader, std::string_view name, bool data) {
    const Key& key = reader.described(name, Kind::texture);
    const toml::node* node = reader.value(name, Kind::texture);
    if (!node) {
        return scene::Color(std::get<glm::dvec3>(key.preset));
    }
    const toml::table* table = node->as_table();
    if (!table || is_spectrum(*table)) {
        const auto color = read_color(context, *node, key);
        if (!color) {
            reader.spoil();
        }
        return color.value_or(scene::Color());
    }
    const auto type = table->get_as<std::string>("type");
    if (type && type->get() == "checker") {
        TableReader checker_reader(context.messages, *table, checker());
        return read_checker(checker_reader);
    }
    if (type && type->get() == "image") {
        TableReader image_reader(context.messages, *table, image());
        return read_image(context, image_reader, data);
    }
    for (const bool of_faces : {false, true}) {
        const Table& colors = of_faces ? face_color() : vertex_color();
        if (type && type->get() == colors.name) {
            TableReader colors_reader(context.messages, *table, colors);
            return scene::MeshColors{of_faces, read_rgb(colors_reader, "tint")};
        }
    }
    const toml::node* written = table->get("type");
    reader.error(context.messages.at(written ? *written : *node),
                 fmt::format("a texture needs \"type\": \"checker\", \"image\", \"vertex_color\" or \"face_color\"{}",
                             type ? fmt::format(", not \"{}\"", type->get()) : ""));
    return scene::Color();
}

}  // namespace lancer::notation
