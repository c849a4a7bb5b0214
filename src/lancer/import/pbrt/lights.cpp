#include "lancer/import/pbrt/lights.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "lancer/import/pbrt/light_power.h"
#include "lancer/import/pbrt/transforms.h"

namespace lancer::pbrt {

namespace {

using std::numbers::pi;

}  // namespace

void Lights::add(const Recipe& light, const glm::dmat4& to_world) {
    const Parameters& parameters = light.parameters;
    if (!is_usable(to_world)) {
        context_.diagnostics.warning(parameters.position(), "the transform squeezes space flat: the light is left out");
        return;
    }
    if (light.type == "point") {
        add_point(light, to_world);
    } else if (light.type == "spot") {
        add_spot(light, to_world);
    } else if (light.type == "distant") {
        add_distant(light, to_world);
    } else if (light.type == "infinite" || light.type == "exinfinite") {
        add_infinite(light, to_world);
    } else {
        context_.report.dropped(parameters.owner(), "this light is not known", parameters.position());
        return;
    }
    parameters.pass_over({"nsamples", "samples"});
    parameters.warn_of_unused();
}

void Lights::add_point(const Recipe& light, const glm::dmat4& to_world) {
    const Parameters& parameters = light.parameters;
    LightColor color = read_light_color(light, "I", version3_);
    if (const auto power = parameters.number("power"); power && *power > 0.0) {
        color.scale *= *power / (4.0 * pi);
    }
    const glm::dvec3 from = parameters.triple("from").value_or(glm::dvec3(0.0));
    scene_.lights.push_back(
        {{}, scene::PointLight{apply_to_point(to_world, from)}, color.color, 1.0, parameters.position(), color.color * color.scale});
    context_.report.honoured(parameters.owner(), parameters.position());
}

void Lights::add_spot(const Recipe& light, const glm::dmat4& to_world) {
    const Parameters& parameters = light.parameters;
    LightColor color = read_light_color(light, "I", version3_);
    const double angle = std::clamp(parameters.number("coneangle", 30.0), 0.0, 180.0);
    const double falloff = std::clamp(parameters.number("conedeltaangle", 5.0), 0.0, angle);
    if (const auto power = parameters.number("power"); power && *power > 0.0) {
        const double end = std::cos(glm::radians(angle)), begin = std::cos(glm::radians(angle - falloff));
        color.scale *= *power / (2.0 * pi * ((1.0 - begin) + (begin - end) / 2.0));
    }
    const glm::dvec3 from = parameters.triple("from").value_or(glm::dvec3(0.0));
    const glm::dvec3 to = parameters.triple("to").value_or(glm::dvec3(0.0, 0.0, 1.0));
    const glm::dvec3 direction = apply_to_direction(to_world, to - from);
    if (!(glm::length(direction) > 0.0)) {
        context_.diagnostics.error(parameters.position(), "\"from\" and \"to\" of this light are the same point");
        return;
    }
    scene_.lights.push_back({{},
                             scene::SpotLight{apply_to_point(to_world, from), direction, angle, falloff},
                             color.color,
                             1.0,
                             parameters.position(),
                             color.color * color.scale});
    context_.report.honoured(parameters.owner(), parameters.position());
}

void Lights::add_distant(const Recipe& light, const glm::dmat4& to_world) {
    const Parameters& parameters = light.parameters;
    LightColor color = read_light_color(light, "L", version3_);
    if (const auto illuminance = parameters.number("illuminance"); illuminance && *illuminance > 0.0) {
        color.scale *= *illuminance;
    }
    const glm::dvec3 from = parameters.triple("from").value_or(glm::dvec3(0.0));
    const glm::dvec3 to = parameters.triple("to").value_or(glm::dvec3(0.0, 0.0, 1.0));
    const glm::dvec3 direction = apply_to_direction(to_world, to - from);
    if (!(glm::length(direction) > 0.0)) {
        context_.diagnostics.error(parameters.position(), "\"from\" and \"to\" of this light are the same point");
        return;
    }
    scene_.lights.push_back({{}, scene::DirectionalLight{direction}, color.color, 1.0, parameters.position(), color.color * color.scale});
    context_.report.honoured(parameters.owner(), parameters.position());
}

void Lights::add_infinite(const Recipe& light, const glm::dmat4&) {
    const Parameters& parameters = light.parameters;
    LightColor color = read_light_color(light, "L", version3_);
    if (parameters.has("filename") || parameters.has("mapname")) {
        context_.report.dropped(parameters.owner() + " with a picture", "surroundings of pictures are not there yet",
                                parameters.position());
        return;
    }
    if (const auto illuminance = parameters.number("illuminance"); illuminance && *illuminance > 0.0) {
        color.scale *= *illuminance / pi;
    }
    const scene::Rgb radiance = color.color * color.scale;
    scene_.background.zenith.rgb += radiance;
    scene_.background.horizon.rgb += radiance;
    scene_.background.nadir.rgb += radiance;
    if (parameters.has("portal")) {
        context_.report.dropped("\"portal\"", "it only helps to find the light", parameters.position(), false);
    }
    context_.report.honoured(parameters.owner(), parameters.position());
}

void Lights::finish(double brightness) {
    for (scene::Light& light : scene_.lights) {
        light.power->rgb *= brightness;
    }
    scene_.background.zenith.rgb *= brightness;
    scene_.background.horizon.rgb *= brightness;
    scene_.background.nadir.rgb *= brightness;
    const bool shines =
        std::any_of(scene_.materials.begin(), scene_.materials.end(), [](const scene::Material& m) { return m.emission.has_value(); });
    if (!shines && scene_.lights.empty() && scene_.background.zenith.rgb == scene::Rgb(0.0)) {
        scene_.background = {scene::Rgb(1.0), scene::Rgb(1.0), scene::Rgb(1.0)};
        context_.diagnostics.warning({scene_.file, 0, 0}, "this scene has no light: white light comes from everywhere instead");
    }
}

}  // namespace lancer::pbrt
