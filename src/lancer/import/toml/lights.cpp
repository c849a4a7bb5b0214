#include "lancer/import/toml/lights.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

#include "lancer/import/toml/colors.h"
#include "lancer/import/toml/contents.h"

namespace lancer::notation {

namespace {

// From "direction" or "look_at", of which there must be one.
glm::dvec3 read_direction(TableReader& reader, const glm::dvec3& position) {
    glm::dvec3 result(0.0, -1.0, 0.0);
    if (reader.has("direction") == reader.has("look_at")) {
        const std::string_view what = reader.description().what;
        reader.error(reader.position(), reader.has("direction") ? fmt::format("{} has either \"direction\" or \"look_at\"", what)
                                                                : fmt::format("{} needs \"direction\" or \"look_at\"", what));
    } else if (reader.has("direction")) {
        result = reader.direction("direction");
    } else if (const glm::dvec3 target = reader.vector3("look_at"); reader.good()) {
        if (const auto direction = unit_vector(target - position)) {
            result = *direction;
        } else {
            reader.error("look_at", "\"look_at\" must differ from \"position\"");
        }
    }
    return result;
}

scene::ImageTexture read_picture(Context& context, TableReader& reader) {
    scene::ImageTexture image;
    image.position = reader.position("image");
    if (const std::string file = reader.text("image"); !file.empty()) {
        image.file = path_beside(context.messages.file(), file);
        if (!context.files.image(image.file, image.position)) {
            reader.spoil();
        }
    }
    image.linear = reader.choice("encoding") == 1;
    image.tint = read_rgb(reader, "tint");
    image.wrap = scene::Wrap::clamp;
    return image;
}

// That a picture's second direction does not lie along its first.
void check_across(TableReader& reader, const glm::dvec3& direction, const glm::dvec3& second, std::string message) {
    if (reader.good() && !unit_vector(glm::cross(direction, second))) {
        reader.error(reader.position(), std::move(message));
    }
}

scene::SpotLight read_spot(Context& context, TableReader& reader) {
    scene::SpotLight spot;
    spot.position = reader.vector3("position");
    spot.direction = read_direction(reader, spot.position);
    spot.angle = reader.number("angle");
    spot.falloff = reader.number("falloff");
    spot.fade = static_cast<scene::SpotFade>(reader.choice("fade"));
    if (!reader.has("falloff")) {
        spot.falloff = std::min(spot.falloff, spot.angle);
    } else if (reader.good() && spot.falloff > spot.angle) {
        reader.error("falloff", fmt::format("\"falloff\" must be at most \"angle\", {} degrees, not {}", spot.angle, spot.falloff));
    }
    if (reader.has("image")) {
        spot.image = read_picture(context, reader);
        spot.image->wrap = static_cast<scene::Wrap>(reader.choice("wrap"));
    }
    spot.up = reader.direction("up");
    if (spot.image) {
        check_across(reader, spot.direction, spot.up, "\"up\" must not point where the light shines");
    }
    return spot;
}

scene::ProjectorLight read_projector(Context& context, TableReader& reader) {
    scene::ProjectorLight light;
    light.position = reader.vector3("position");
    light.direction = read_direction(reader, light.position);
    light.up = reader.direction("up");
    light.fov = reader.number("fov");
    light.fov_axis = static_cast<scene::ProjectorFov>(reader.choice("fov_axis"));
    if (reader.has("image")) {
        light.image = read_picture(context, reader);
        light.image->wrap = static_cast<scene::Wrap>(reader.choice("wrap"));
    }
    light.even = reader.flag("even");
    check_across(reader, light.direction, light.up, "\"up\" must not point where the projector shines");
    return light;
}

scene::GoniometricLight read_goniometric(Context& context, TableReader& reader) {
    scene::GoniometricLight light;
    light.position = reader.vector3("position");
    light.direction = reader.direction("direction");
    light.up = reader.direction("up");
    light.image = read_picture(context, reader);
    check_across(reader, light.direction, light.up, "\"up\" must not point along \"direction\"");
    return light;
}

scene::IesLight read_ies_light(Context& context, TableReader& reader) {
    scene::IesLight light;
    light.position = reader.vector3("position");
    light.direction = reader.direction("direction");
    light.forward = reader.direction("forward");
    if (const std::string file = reader.text("file"); !file.empty()) {
        light.photometry = context.files.photometry(path_beside(context.messages.file(), file), reader.position("file"));
    }
    if (!light.photometry) {
        reader.spoil();
    }
    check_across(reader, light.direction, light.forward, "\"forward\" must not point along \"direction\"");
    return light;
}

struct ReadLight {
    scene::Light light;
    bool has_intensity = false;
};

std::optional<ReadLight> read_light(Context& context, const toml::table& table) {
    Messages& messages = context.messages;
    std::vector<std::string> types;
    for (const Table* kind : lights()) {
        types.emplace_back(kind->name);
    }
    const toml::node* node = table.get("type");
    const auto* type = node ? node->as_string() : nullptr;
    const auto found = type ? std::find(types.begin(), types.end(), type->get()) : types.end();
    if (found == types.end()) {
        std::string hint = type ? did_you_mean(type->get(), types) : "";
        hint = hint.empty() ? hint : ";" + hint;
        const std::string not_this = type   ? fmt::format(", not \"{}\"", type->get())
                                     : node ? fmt::format(", not {}", what_it_is(*node))
                                            : "";
        messages.error(messages.at(node ? *node : table),
                       fmt::format("a light needs \"type\": {}{}{}", alternatives({types.begin(), types.end()}), not_this, hint));
        return std::nullopt;
    }
    const std::size_t kind = static_cast<std::size_t>(found - types.begin());
    TableReader reader(messages, table, *lights()[kind]);
    ReadLight result;
    scene::Light& light = result.light;
    light.name = reader.text("name");
    light.position = reader.position();
    switch (kind) {
        case 0:
            light.model = scene::PointLight{reader.vector3("position")};
            break;
        case 1:
            light.model = read_spot(context, reader);
            break;
        case 2:
            light.model = scene::DirectionalLight{reader.direction("direction")};
            break;
        case 3:
            light.model = read_projector(context, reader);
            break;
        case 4:
            light.model = read_goniometric(context, reader);
            break;
        default:
            light.model = read_ies_light(context, reader);
            break;
    }
    light.power = read_color_if_written(context, reader, "power");
    if (!reader.good() && kind > 2) {
        return std::nullopt;
    }
    if (kind > 2) {
        result.has_intensity = true;
        light.intensity = 0.0;
        light.power = light.power.value_or(scene::Color());
        return result;
    }
    light.color = read_color(context, reader, "color");
    const auto intensity = reader.number_if_written("intensity");
    result.has_intensity = reader.has("intensity") || light.power;
    light.intensity = intensity.value_or(0.0);
    return result;
}

// Physical lights have no shares; where there are only such, there is nothing to share out.
void share_out(Messages& messages, std::vector<ReadLight>& all) {
    if (std::all_of(all.begin(), all.end(), [](const ReadLight& read) { return read.light.power.has_value(); })) {
        return;
    }
    double written = 0.0;
    std::size_t without = 0;
    for (const ReadLight& read : all) {
        written += read.light.intensity;
        without += read.has_intensity ? 0 : 1;
    }
    if (without > 0) {
        const double left = 1.0 - written;
        const double part = left > 0.0 ? left / static_cast<double>(without) : written / static_cast<double>(all.size() - without);
        for (ReadLight& read : all) {
            read.light.intensity = read.has_intensity ? read.light.intensity : part;
        }
    }
    const double sum =
        std::accumulate(all.begin(), all.end(), 0.0, [](double s, const ReadLight& read) { return s + read.light.intensity; });
    if (all.empty() || messages.diagnostics().has_errors()) {
        return;
    }
    if (sum == 0.0) {
        messages.warning(all.front().light.position, "the intensities of all lights are 0");
    } else if (std::abs(sum - 1.0) > 1e-6) {
        messages.note(all.front().light.position,
                      fmt::format("the intensities of the lights are shares that should sum to 1, not {:.6g}; they are scaled", sum));
        for (ReadLight& read : all) {
            read.light.intensity /= sum;
        }
    }
}

}  // namespace

void read_lights(Context& context, const std::vector<Included>& included, const toml::table& root) {
    std::vector<ReadLight> all;
    for (const Included& part : included) {
        for (const scene::Light& light : part.lights) {
            all.push_back({light, true});
        }
    }
    const std::size_t others = all.size();
    for (const toml::table* table : tables_of(context.messages, root, "light")) {
        auto read = read_light(context, *table);
        if (!read) {
            continue;
        }
        const auto end = all.begin() + static_cast<std::ptrdiff_t>(others);
        const auto same = read->light.name.empty() ? end : std::find_if(all.begin(), end, [&](const ReadLight& other) {
            return other.light.name == read->light.name;
        });
        if (same != end) {
            *same = std::move(*read);
        } else {
            all.push_back(std::move(*read));
        }
    }
    share_out(context.messages, all);
    for (ReadLight& read : all) {
        context.scene.lights.push_back(std::move(read.light));
    }
}

}  // namespace lancer::notation
