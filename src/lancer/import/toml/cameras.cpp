#include "lancer/import/toml/cameras.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "lancer/import/toml/table_reader.h"

namespace lancer::notation {

namespace {

constexpr double parallel = 1e-6;  // sine of the angle below which up and the view are the same line

void read_view(TableReader& reader, scene::Camera& camera) {
    camera.direction = reader.direction("direction");
    if (reader.has("look_at") && reader.has("direction")) {
        reader.error("direction", "a camera has either \"look_at\" or \"direction\"");
    } else if (reader.has("look_at")) {
        const glm::dvec3 target = reader.vector3("look_at");
        const auto direction = unit_vector(target - camera.position);
        if (direction) {
            camera.direction = *direction;
        } else if (reader.good()) {
            reader.error("look_at", "\"look_at\" must differ from \"position\"");
        }
    }
    camera.up = reader.direction("up");
    if (reader.good() && glm::length(glm::cross(camera.direction, camera.up)) < parallel) {
        if (reader.has("up")) {
            reader.error("up", "\"up\" must not point along the view: which way the picture is turned would be open");
        } else {
            camera.up = {0.0, 0.0, -1.0};  // straight down or up: as on a map, with -z at the top
        }
    }
}

scene::Camera read_camera(Messages& messages, const toml::table& table, std::string name, const Inside& inside) {
    TableReader reader(messages, table, camera(), inside);
    scene::Camera result;
    result.name = std::move(name);
    result.source = reader.position();
    result.position = reader.vector3("position");
    read_view(reader, result);
    result.fov = reader.number("fov");
    result.fov_axis = reader.choice("fov_axis") == 0 ? scene::FovAxis::width : scene::FovAxis::height;
    result.projection = static_cast<scene::Projection>(reader.choice("projection"));
    result.extent = reader.number("extent");
    result.shift = reader.vector2("shift");
    result.pixel_aspect = reader.number("pixel_aspect");
    result.aperture = reader.number("aperture");
    if (const auto focus = reader.number_if_written("focus_distance")) {
        result.focus_distance = *focus;
    } else if (reader.has("look_at") && reader.good()) {
        result.focus_distance = glm::length(reader.vector3("look_at") - result.position);
    }
    return result;
}

}  // namespace

void add_included_cameras(Context& context, const std::vector<Included>& included) {
    std::vector<scene::Camera>& cameras = context.scene.cameras;
    const bool has_own = !cameras.empty();
    for (const Included& part : included) {
        for (const scene::Camera& camera : part.cameras) {
            const bool is_taken = std::any_of(cameras.begin(), cameras.end(), [&](const auto& other) { return other.name == camera.name; });
            if (!is_taken && !(has_own && camera.name.empty())) {
                cameras.push_back(camera);
            }
        }
    }
}

void read_cameras(Context& context, const toml::table& root) {
    const toml::node* node = root.get("camera");
    if (!node) {
        return;
    }
    const toml::table* table = node->as_table();
    if (!table) {
        context.messages.error(context.messages.at(*node), fmt::format("write [camera], or [camera.NAME] for several, instead of {}",
                                                                       node->is_array() ? "[[camera]]" : what_it_is(*node)));
        return;
    }
    struct Named {
        const toml::key* key;
        const toml::table* table;
    };
    std::vector<Named> named;
    for (const auto& [key, value] : *table) {
        if (const toml::table* inner = value.as_table(); inner && !camera().find(key.str())) {
            named.push_back({&key, inner});
        }
    }
    const auto place_of = [](const Named& n) { return std::pair(n.key->source().begin.line, n.key->source().begin.column); };
    std::sort(named.begin(), named.end(), [&](const Named& a, const Named& b) { return place_of(a) < place_of(b); });
    if (named.size() < table->size() || named.empty()) {
        context.scene.cameras.push_back(read_camera(context.messages, *table, "", {{}, true}));
    }
    for (const Named& n : named) {
        context.scene.cameras.push_back(read_camera(context.messages, *n.table, std::string(n.key->str()), {}));
    }
}

}  // namespace lancer::notation
