#include "lancer/import/gltf/lights.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace lancer::gltf {

namespace {

constexpr std::string_view lights_name = "KHR_lights_punctual";

std::string name_of(Json object, const Node& node) { return std::string(object["name"] ? object.text("name") : node.json.text("name")); }

glm::dvec3 unit_or(const glm::dvec3& v, const glm::dvec3& otherwise) {
    const double length = glm::length(v);
    return length > 0.0 && std::isfinite(length) ? v / length : otherwise;
}

}  // namespace

void add_camera(Document& document, const Node& node, scene::Scene& scene) {
    const Json json = document.item("cameras", node.json, "camera");
    if (!json) {
        return;
    }
    scene::Camera camera;
    camera.name = name_of(json, node);
    if (camera.name.empty()) {
        camera.name = fmt::format("camera {}", scene.cameras.size() + 1);
    }
    camera.source = document.position(json);
    camera.position = glm::dvec3(node.to_world[3]);
    camera.direction = unit_or(-glm::dvec3(node.to_world[2]), camera.direction);
    camera.up = unit_or(glm::dvec3(node.to_world[1]), camera.up);
    camera.fov_axis = scene::FovAxis::height;
    const bool is_orthographic = json.text("type") == "orthographic";
    const Json shape = is_orthographic ? json["orthographic"] : json["perspective"];
    if (!shape) {
        document.error(json, fmt::format("\"{}\" is missing", json.text("type")));
        return;
    }
    if (is_orthographic) {
        camera.projection = scene::Projection::orthographic;
        camera.extent = 2.0 * std::abs(shape.number("ymag", 1.0));
        if (!(camera.extent > 0.0)) {
            document.error(shape["ymag"], "expected a size other than 0");
            return;
        }
        if (shape.number("zfar", 1.0) <= shape.number("znear", 0.0)) {
            document.warning(shape, "zfar should be larger than znear");
        }
    } else {
        camera.fov = glm::degrees(shape.number("yfov", 1.0));
        if (!(camera.fov > 0.0 && camera.fov < 180.0)) {
            document.error(shape["yfov"], "expected an angle above 0 and below pi");
            return;
        }
        if (shape["zfar"] && shape.number("zfar", 1.0) <= shape.number("znear", 0.0)) {
            document.warning(shape, "zfar should be larger than znear");
        }
    }
    document.honoured(is_orthographic ? "orthographic camera" : "perspective camera", json);
    if (scene.cameras.empty()) {
        // The first camera says how wide the picture is.
        const double aspect =
            is_orthographic ? std::abs(shape.number("xmag", 1.0) / shape.number("ymag", 1.0)) : shape.number("aspectRatio", 0.0);
        if (aspect > 0.01 && aspect < 100.0) {
            const double pixels = static_cast<double>(scene.settings.width) * scene.settings.height;
            scene.settings.width = std::max(1, static_cast<int>(std::lround(std::sqrt(pixels * aspect))));
            scene.settings.height = std::max(1, static_cast<int>(std::lround(std::sqrt(pixels / aspect))));
        }
    }
    scene.cameras.push_back(camera);
}

// Candela and lux are taken for W/sr and W/m^2 as the eye weighs them, and a radiance of 1 for one nit, so that lamps and surfaces that glow keep
// their ratio.
void add_light(Document& document, const Node& node, scene::Scene& scene) {
    const Json reference = document.extension(node.json, lights_name);
    if (!reference) {
        return;
    }
    std::vector<Json> lights;
    for (const Json light : document.extension(document.root(), lights_name)["lights"]) {
        lights.push_back(light);
    }
    const std::size_t number = reference.natural("light").value_or(lights.size());
    if (number >= lights.size()) {
        document.error(reference["light"], fmt::format("{}: the file has {} lights", reference.number("light", 0.0), lights.size()));
        return;
    }
    const Json json = lights[number];
    scene::Light light;
    light.name = name_of(json, node);
    light.position = document.position(json);
    const std::vector<double> color = json.numbers("color");
    const glm::dvec3 rgb = color.size() == 3 ? glm::dvec3(color[0], color[1], color[2]) : glm::dvec3(1.0);
    light.power = glm::max(rgb, 0.0) * std::max(json.number("intensity", 1.0), 0.0);
    const glm::dvec3 position(node.to_world[3]);
    const glm::dvec3 direction = unit_or(-glm::dvec3(node.to_world[2]), {0.0, 0.0, -1.0});
    const std::string_view type = json.text("type");
    if (type == "directional") {
        light.model = scene::DirectionalLight{direction};
    } else if (type == "point") {
        light.model = scene::PointLight{position};
    } else if (type == "spot") {
        const Json spot = json["spot"];
        const double outer = std::clamp(spot.number("outerConeAngle", 0.7853981633974483), 1e-3, 1.5707963267948966);
        const double inner = std::clamp(spot.number("innerConeAngle", 0.0), 0.0, outer);
        scene::SpotLight cone{position, direction, glm::degrees(outer), glm::degrees(outer - inner)};
        cone.fade = scene::SpotFade::square;  // as the extension recommends
        light.model = cone;
    } else {
        document.error(json["type"], fmt::format("\"{}\": expected directional, point or spot", type.substr(0, 80)));
        return;
    }
    document.honoured(fmt::format("{}, {}", lights_name, type), json);
    if (json["range"]) {
        document.dropped(fmt::format("{}, range", lights_name), "light that follows physics reaches everywhere", json["range"], false);
    }
    scene.lights.push_back(light);
}

}  // namespace lancer::gltf
