#include "lancer/import/toml/settings.h"

#include <fmt/format.h>

#include "lancer/import/toml/colors.h"
#include "lancer/import/toml/spectra.h"

namespace lancer::notation {

namespace {

scene::Background read_background_table(Context& context, TableReader& reader) {
    const auto color = read_color_if_written(context, reader, "color");
    const auto zenith = read_color_if_written(context, reader, "zenith");
    const auto horizon = read_color_if_written(context, reader, "horizon");
    const auto nadir = read_color_if_written(context, reader, "nadir");
    if (reader.has("color")) {
        for (const char* key : {"zenith", "horizon", "nadir"}) {
            if (reader.has(key)) {
                reader.error(key, fmt::format("a background has either \"color\" or \"{}\"", key));
            }
        }
        const scene::Color all = color.value_or(scene::Color());
        return {all, all, all};
    }
    if (!horizon && zenith && nadir && (zenith->spectrum || nadir->spectrum)) {
        reader.error(reader.position(), "between two spectra \"horizon\" must be written");
    }
    const scene::Color middle = horizon           ? *horizon
                                : zenith && nadir ? scene::Color(0.5 * (zenith->rgb + nadir->rgb))
                                                  : zenith.value_or(nadir.value_or(scene::Color()));
    return {zenith.value_or(middle), middle, nadir.value_or(middle)};
}

// `name = color`, where a table [name] may stand as well.
std::optional<scene::Color> read_bare_color(Context& context, const toml::node& node, const Table& table) {
    Key key = *table.find("color");
    key.name = table.name;
    return read_color(context, node, key);
}

void read_background(Context& context, const toml::node& node) {
    if (const toml::table* table = node.as_table(); table && !is_spectrum(*table)) {
        TableReader reader(context.messages, *table, background());
        context.scene.background = read_background_table(context, reader);
    } else if (const auto color = read_bare_color(context, node, background())) {
        context.scene.background = {*color, *color, *color};
    }
}

void read_ambient(Context& context, const toml::node& node) {
    if (const toml::table* table = node.as_table(); table && !is_spectrum(*table)) {
        TableReader reader(context.messages, *table, ambient());
        context.scene.ambient = read_color(context, reader, "color");
    } else if (const auto color = read_bare_color(context, node, ambient())) {
        context.scene.ambient = *color;
    }
}

void read_render(Context& context, const toml::node& node) {
    const toml::table* table = node.as_table();
    if (!table) {
        context.messages.error(context.messages.at(node),
                               fmt::format("write [render] instead of {}", node.is_array() ? "[[render]]" : what_it_is(node)));
        return;
    }
    TableReader reader(context.messages, *table, render());
    scene::RenderSettings& settings = context.scene.settings;
    const glm::ivec2 size = reader.size("size");
    settings.width = size.x;
    settings.height = size.y;
    settings.integrator = render().find("integrator")->words[reader.choice("integrator")];
    if (reader.has("bounces")) {
        settings.bounces = reader.integer("bounces");
    }
    settings.spp = reader.integer("spp");
    settings.rgb = reader.flag("rgb");
    settings.seed = reader.integer("seed");
    settings.filter = static_cast<scene::PixelFilter>(reader.choice("filter"));
    settings.filter_radius = reader.number_if_written("filter_radius");
    settings.ssaa = reader.integer("ssaa");
    settings.antialiasing = reader.choice("aa") == 0 ? scene::Antialiasing::uniform : scene::Antialiasing::adaptive;
    settings.adaptive_threshold = reader.number("adaptive_threshold");
    settings.adaptive_depth = reader.integer("adaptive_depth");
    settings.min_weight = reader.number("min_weight");
    settings.wavelengths = reader.integer("wavelengths");
    settings.exposure = reader.number("exposure");
}

}  // namespace

void read_settings(Context& context, const toml::table& root) {
    if (const toml::node* node = root.get("background")) {
        read_background(context, *node);
    }
    if (const toml::node* node = root.get("ambient")) {
        read_ambient(context, *node);
    }
    if (const toml::node* node = root.get("render")) {
        read_render(context, *node);
    }
}

}  // namespace lancer::notation
