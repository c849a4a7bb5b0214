#include "lancer/import/toml/lights.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lancer/import/toml/colors.h"
#include "lancer/import/toml/contents.h"

namespace lancer::notation {

namespace {

scene::SpotLight read_spot(TableReader& reader) {
    scene::SpotLight spot;
    spot.position = reader.vector3("position");
    if (reader.has("direction") == reader.has("look_at")) {
        reader.error(reader.position(), reader.has("direction") ? "a spot light has either \"direction\" or \"look_at\""
                                                                : "a spot light needs \"direction\" or \"look_at\"");
    } else if (reader.has("direction")) {
        spot.direction = reader.direction("direction");
    } else if (const glm::dvec3 target = reader.vector3("look_at"); reader.good()) {
        if (const auto direction = unit_vector(target - spot.position)) {
            spot.direction = *direction;
        } else {
            reader.error("look_at", "\"look_at\" must differ from \"position\"");
        }
    }
    spot.angle = reader.number("angle");
    spot.falloff = reader.number("falloff");
    if (!reader.has("falloff")) {
        spot.falloff = std::min(spot.falloff, spot.angle);
    } else if (reader.good() && spot.falloff > spot.angle) {
        reader.error("falloff", fmt::format("\"falloff\" must be at most \"angle\", {} degrees, not {}", spot.angle, spot.falloff));
    }
    return spot;
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
                       fmt::format("a light needs \"type\": \"point\", \"spot\" or \"directional\"{}{}", not_this, hint));
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
            light.model = read_spot(reader);
            break;
        default:
            light.model = scene::DirectionalLight{reader.direction("direction")};
            break;
    }
    light.color = read_color(context, reader, "color");
    light.power = read_color_if_written(context, reader, "power");
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
