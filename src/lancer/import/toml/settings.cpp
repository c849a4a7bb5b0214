#include "lancer/import/toml/settings.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "lancer/base/file.h"
#include "lancer/import/toml/colors.h"
#include "lancer/import/toml/spectra.h"
#include "lancer/scene/sun_position.h"

namespace lancer::notation {

namespace {

scene::Background read_colors(Context& context, TableReader& reader) {
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
        scene::Background even;
        even.zenith = even.horizon = even.nadir = all;
        return even;
    }
    if (!horizon && zenith && nadir && (zenith->spectrum || nadir->spectrum)) {
        reader.error(reader.position(), "between two spectra \"horizon\" must be written");
    }
    const scene::Color middle = horizon           ? *horizon
                                : zenith && nadir ? scene::Color(0.5 * (zenith->rgb + nadir->rgb))
                                                  : zenith.value_or(nadir.value_or(scene::Color()));
    scene::Background gradient;
    gradient.zenith = zenith.value_or(middle);
    gradient.horizon = middle;
    gradient.nadir = nadir.value_or(middle);
    return gradient;
}

glm::dmat3 read_axes(TableReader& reader) {
    const Key& key = reader.described("axes", Kind::vectors3);
    const toml::array* list = reader.value("axes", Kind::vectors3)->as_array();
    constexpr double tolerance = 1e-4;
    glm::dmat3 result(1.0);
    bool right = list != nullptr && list->size() == 3;
    for (int i = 0; right && i < 3; ++i) {
        if (!read_numbers(reader.messages(), *list->get(static_cast<std::size_t>(i)), key, 3, "three numbers [x, y, z]", &result[i].x)) {
            reader.spoil();
            return glm::dmat3(1.0);  // said already
        }
        right = std::abs(glm::dot(result[i], result[i]) - 1.0) < tolerance;
        for (int j = 0; j < i; ++j) {
            right = right && std::abs(glm::dot(result[i], result[j])) < tolerance;
        }
    }
    if (!right) {
        reader.error("axes", "\"axes\" must be three directions of length 1, at right angles to one another");
        return glm::dmat3(1.0);
    }
    return result;
}

scene::Background read_background_table(Context& context, TableReader& reader) {
    scene::Background result = read_colors(context, reader);
    const std::string file = reader.text("image");
    if (!file.empty()) {
        for (const char* key : {"color", "zenith", "horizon", "nadir"}) {
            if (reader.has(key)) {
                reader.error(key, fmt::format("a background has either \"image\" or \"{}\"", key));
            }
        }
        scene::ImageTexture image;
        image.file = path_beside(context.messages.file(), file);
        image.position = reader.position("image");
        image.linear = reader.choice("encoding") == 1;
        image.tint = read_rgb(reader, "tint");
        image.scale.y = reader.number("stretch");
        image.offset.y = reader.number("lift");
        if (context.files.image(image, image.position)) {
            result.image = image;
        } else {
            reader.spoil();
        }
    } else {
        for (const char* key : {"rotation", "axes"}) {
            if (reader.has(key)) {
                reader.error(key, fmt::format("\"{}\" turns an \"image\"; this background has none", key));
            }
        }
        for (const char* key : {"encoding", "tint", "stretch", "lift"}) {
            if (reader.has(key)) {
                reader.error(key, fmt::format("\"{}\" is said of an \"image\"; this background has none", key));
            }
        }
    }
    if (reader.has("axes")) {
        result.axes = read_axes(reader);
    }
    result.rotation = reader.number("rotation");
    result.strength = reader.number("strength");
    result.visible = reader.flag("visible");
    return result;
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
        scene::Background& background = context.scene.background;
        background.zenith = background.horizon = background.nadir = *color;
    }
}

void read_sky(Context& context, const toml::node& node, bool has_background) {
    const toml::table* table = node.as_table();
    if (!table) {
        context.messages.error(context.messages.at(node),
                               fmt::format("write [sky] instead of {}", node.is_array() ? "[[sky]]" : what_it_is(node)));
        return;
    }
    TableReader reader(context.messages, *table, clear_sky());
    if (has_background) {
        reader.error(reader.position(), "a scene has either [background] or [sky]");
    }
    scene::ClearSky sky;
    const double heading = reader.number("heading");
    const bool by_time = reader.has("latitude") || reader.has("longitude") || reader.has("time");
    const bool by_angles = reader.has("elevation") || reader.has("azimuth");
    const auto has_all = [&](std::initializer_list<const char*> keys) {
        return std::all_of(keys.begin(), keys.end(), [&](const char* key) { return reader.has(key); });
    };
    const auto latitude = reader.number_if_written("latitude"), longitude = reader.number_if_written("longitude");
    const auto elevation = reader.number_if_written("elevation"), azimuth = reader.number_if_written("azimuth");
    if (reader.has("toward_sun") && !by_time && !by_angles) {
        sky.sun = reader.direction("toward_sun");
        sky.distance = reader.number("sun_distance");
    } else if (reader.has("toward_sun") || reader.has("sun_distance") || by_time == by_angles ||
               (by_time && !has_all({"latitude", "longitude", "time"})) || (by_angles && !has_all({"elevation", "azimuth"}))) {
        reader.error(reader.position(),
                     "[sky] needs either \"latitude\", \"longitude\" and \"time\", or \"elevation\" and \"azimuth\", or \"toward_sun\"");
    } else if (by_time) {
        const auto days = scene::days_since_2000(reader.text("time"));
        if (!days) {
            reader.error("time", "expected a date and time from 1950 to 2050, such as \"2026-06-21T14:00:00+02:00\"");
        } else if (latitude && longitude) {
            const scene::SunPosition sun = scene::sun_position(*days, *latitude, *longitude);
            sky.sun = scene::sun_direction(sun.elevation, sun.azimuth, heading);
            sky.distance = sun.distance;
            if (sun.elevation < -18.0) {
                reader.error(
                    "time", fmt::format("the sun is {:.1f} degrees below the horizon: there is no light of it in the air", -sun.elevation));
            } else if (sun.elevation < 0.0) {
                context.messages.note(reader.position("time"), fmt::format("the sun is {:.1f} degrees below the horizon", -sun.elevation));
            }
        }
    } else if (elevation && azimuth) {
        sky.sun = scene::sun_direction(*elevation, *azimuth, heading);
    }
    sky.up = reader.direction("up");
    if (!reader.has("toward_sun")) {
        sky.sun = scene::upright(sky.up) * sky.sun;
    }
    sky.turbidity = reader.number("turbidity");
    sky.ozone = reader.number("ozone");
    sky.ground = reader.number("ground");
    sky.has_sun = reader.flag("sun");
    context.scene.background.strength = reader.number("strength");
    context.scene.background.visible = reader.flag("visible");
    context.scene.background.sky = sky;
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
    // What is not written stays: it may come from an included scene.
    const auto flag = [&](const char* key, bool& setting) { setting = reader.has(key) ? reader.flag(key) : setting; };
    const auto integer = [&](const char* key, int& setting) { setting = reader.has(key) ? reader.integer(key) : setting; };
    const auto number = [&](const char* key, double& setting) { setting = reader.has(key) ? reader.number(key) : setting; };
    const auto limit = [&](const char* key, std::optional<int>& setting) {
        setting = reader.has(key) ? std::optional<int>(reader.integer(key)) : setting;
    };
    const auto word = [&](const char* key, std::string& setting) {
        setting = reader.has(key) ? std::string(render().find(key)->words[reader.choice(key)]) : setting;
    };
    if (reader.has("size")) {
        const glm::ivec2 size = reader.size("size");
        settings.width = size.x;
        settings.height = size.y;
    }
    word("integrator", settings.integrator);
    limit("bounces", settings.bounces);
    limit("diffuse_bounces", settings.diffuse_bounces);
    limit("glossy_bounces", settings.glossy_bounces);
    limit("transmission_bounces", settings.transmission_bounces);
    if (reader.has("direct_samples")) {
        settings.direct_samples = static_cast<scene::DirectSamples>(reader.choice("direct_samples"));
    }
    integer("spp", settings.spp);
    flag("rgb", settings.rgb);
    integer("seed", settings.seed);
    if (reader.has("filter")) {
        settings.filter = static_cast<scene::PixelFilter>(reader.choice("filter"));
        settings.filter_radius.reset();  // that of another filter suits this one hardly
    }
    if (reader.has("filter_radius")) {
        settings.filter_radius = reader.number_if_written("filter_radius");
    }
    integer("ssaa", settings.ssaa);
    if (reader.has("aa")) {
        settings.antialiasing = reader.choice("aa") == 0 ? scene::Antialiasing::uniform : scene::Antialiasing::adaptive;
    }
    number("adaptive_threshold", settings.adaptive_threshold);
    integer("adaptive_depth", settings.adaptive_depth);
    number("min_weight", settings.min_weight);
    integer("wavelengths", settings.wavelengths);
    number("exposure", settings.exposure);
    word("view", settings.view);
    if (reader.has("aovs")) {
        settings.aovs.clear();
    }
    for (const std::size_t each : reader.choices("aovs")) {
        settings.aovs.emplace_back(render().find("aovs")->words[each]);
    }
    integer("spectral_bins", settings.spectral_bins);
    flag("float", settings.wide);
}

}  // namespace

void read_settings(Context& context, const toml::table& root) {
    if (const toml::node* node = root.get("background")) {
        read_background(context, *node);
    }
    if (const toml::node* node = root.get("sky")) {
        read_sky(context, *node, root.contains("background"));
    }
    if (const toml::node* node = root.get("ambient")) {
        read_ambient(context, *node);
    }
    if (const toml::node* node = root.get("render")) {
        read_render(context, *node);
    }
}

}  // namespace lancer::notation
