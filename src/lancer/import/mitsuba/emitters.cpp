#include "lancer/import/mitsuba/emitters.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "lancer/image/image.h"
#include "lancer/import/mesh/mesh_messages.h"
#include "lancer/import/mitsuba/colors.h"
#include "lancer/import/mitsuba/sensors.h"
#include "lancer/import/mitsuba/textures.h"
#include "lancer/scene/sun_position.h"

namespace lancer::mitsuba {

namespace {

glm::dvec3 point(const glm::dmat4& m, const glm::dvec3& p) { return glm::dvec3(m * glm::dvec4(p, 1.0)); }
glm::dvec3 direction(const glm::dmat4& m, const glm::dvec3& d) { return glm::dvec3(m * glm::dvec4(d, 0.0)); }

void add_light(Builder& builder, Plugin& plugin, decltype(scene::Light::model) model, const scene::Color& power) {
    scene::Light light;
    light.name = plugin.id();
    light.model = std::move(model);
    light.position = plugin.position();
    light.power = power;
    builder.scene.lights.push_back(std::move(light));
    builder.honoured(plugin);
}

// A picture that a light throws, upright as whoever looks along the light sees it; where it is no picture, its colour in `tint`.
std::optional<scene::ImageTexture> thrown_picture(Builder& builder, Plugin& plugin, std::string_view name, scene::Color& tint) {
    const scene::Texture texture = texture_or(builder, plugin, name, Color(1.0), Role::light);
    if (const auto* image = std::get_if<scene::ImageTexture>(&texture)) {
        scene::ImageTexture upright = *image;
        upright.scale = glm::dvec2(1.0);
        upright.rotation = 0.0;
        upright.offset = glm::dvec2(0.0);
        return upright;
    }
    if (const auto* color = std::get_if<scene::Color>(&texture)) {
        tint = *color;
    } else {
        builder.context.report.approximated(fmt::format("{}: \"{}\"", plugin.title(), name), "white: no light throws such a texture",
                                            plugin.position());
    }
    return std::nullopt;
}

// One of the two at least has no spectrum.
scene::Color times(const scene::Color& a, const scene::Color& b) {
    if (a.spectrum || b.spectrum) {
        scene::Spectrum spectrum = *(a.spectrum ? a : b).spectrum;
        const scene::Rgb& other = (a.spectrum ? b : a).rgb;
        spectrum.scale *= (other.x + other.y + other.z) / 3.0;
        return spectrum;
    }
    return a.rgb * b.rgb;
}

void add_point(Builder& builder, Plugin& plugin) {
    const glm::dmat4 to_world = plugin.transform("to_world").value_or(glm::dmat4(1.0));
    const glm::dvec3 position = plugin.vector("position", point(to_world, glm::dvec3(0.0)));
    add_light(builder, plugin, scene::PointLight{position}, color_or(builder, plugin, "intensity", Color(1.0), Role::light));
}

void add_spot(Builder& builder, Plugin& plugin) {
    const glm::dmat4 to_world = plugin.transform("to_world").value_or(glm::dmat4(1.0));
    scene::SpotLight spot;
    spot.position = point(to_world, glm::dvec3(0.0));
    spot.direction = direction(to_world, glm::dvec3(0.0, 0.0, 1.0));
    spot.angle = plugin.number("cutoff_angle", 20.0, 0.01, 89.99);
    const double beam = plugin.number("beam_width", 0.75 * spot.angle, 0.0, 180.0);
    spot.falloff = std::max(spot.angle - beam, 0.0);
    spot.fade = scene::SpotFade::even;
    scene::Color tint(scene::Rgb(1.0));
    if (plugin.has("texture")) {
        spot.image = thrown_picture(builder, plugin, "texture", tint);
        // Unlike a projector's it stands on its head.
        spot.up = direction(to_world, glm::dvec3(0.0, -1.0, 0.0));
    }
    add_light(builder, plugin, spot, times(color_or(builder, plugin, "intensity", Color(1.0), Role::light), tint));
}

glm::dvec2 size_of(Builder& builder, const scene::ImageTexture& image) {
    try {
        const Image pixels = read_image(image.file);
        return {pixels.width, pixels.height};
    } catch (const std::runtime_error& problem) {
        builder.error(image.position, problem.what());
    }
    return glm::dvec2(1.0);
}

// Its irradiance at a distance of 1 comes out pi times as large as it is written.
void add_projector(Builder& builder, Plugin& plugin) {
    const glm::dmat4 to_world = plugin.transform("to_world").value_or(glm::dmat4(1.0));
    scene::ProjectorLight light;
    light.position = point(to_world, glm::dvec3(0.0));
    light.direction = direction(to_world, glm::dvec3(0.0, 0.0, 1.0));
    light.up = direction(to_world, glm::dvec3(0.0, 1.0, 0.0));
    scene::Color tint(scene::Rgb(1.0));
    light.image = thrown_picture(builder, plugin, "irradiance", tint);
    const glm::dvec2 size = light.image ? size_of(builder, *light.image) : glm::dvec2(1.0);
    const FieldOfView view = field_of_view(builder, plugin, size.x, size.y);
    light.fov = std::clamp(view.degrees, 1e-3, 179.9);
    light.fov_axis = view.by_height ? scene::ProjectorFov::height : scene::ProjectorFov::width;
    const double scale = std::max(plugin.number("scale", 1.0), 0.0) * std::numbers::pi;
    if (light.image && builder.document.major_version() < 3) {
        // Before version 3 a picture's colours were those of its light under no illuminant but one that is the same everywhere.
        add_light(builder, plugin, light, equal_energy(scale));
    } else {
        add_light(builder, plugin, light, times(tint, scene::Rgb(scale)));
    }
}

void add_directional(Builder& builder, Plugin& plugin) {
    const glm::dmat4 to_world = plugin.transform("to_world").value_or(glm::dmat4(1.0));
    const glm::dvec3 travels = plugin.vector("direction", direction(to_world, glm::dvec3(0.0, 0.0, 1.0)));
    add_light(builder, plugin, scene::DirectionalLight{travels}, color_or(builder, plugin, "irradiance", Color(1.0), Role::light));
}

void set_background(Builder& builder, const scene::Color& color) {
    scene::Background& background = builder.scene.background;
    background.zenith = background.horizon = background.nadir = color;
}

void add_constant(Builder& builder, Plugin& plugin) {
    set_background(builder, color_or(builder, plugin, "radiance", Color(1.0), Role::light));
    builder.honoured(plugin);
}

void add_environment(Builder& builder, Plugin& plugin) {
    scene::ImageTexture image;
    image.position = plugin.position();
    image.file = builder.document.resolve(plugin.text("filename", ""), plugin.position());
    builder.scene.background.strength = std::max(plugin.number("scale", 1.0), 0.0);
    plugin.ignore("mis_compensation");
    if (const auto to_world = plugin.transform("to_world")) {
        glm::dmat3 axes(*to_world);
        for (int i = 0; i < 3; ++i) {
            const double length = glm::length(axes[i]);
            axes[i] = length > 0.0 ? axes[i] / length : glm::dvec3(0.0);
        }
        constexpr double tolerance = 1e-6;
        if (std::abs(glm::dot(axes[0], axes[1])) + std::abs(glm::dot(axes[1], axes[2])) + std::abs(glm::dot(axes[2], axes[0])) >
                tolerance ||
            !(std::abs(glm::determinant(axes)) > 0.5)) {
            builder.error(plugin.find("to_world")->position, "surroundings can be turned and mirrored, not squeezed");
            return;
        }
        builder.scene.background.axes = axes;
    }
    if (!builder.context.files.image(image.file, plugin.position())) {
        set_background(builder, Color(1.0, 0.0, 1.0));
        return;
    }
    // Its first and last row lie on the poles; ours end there.
    try {
        const int rows = read_image(image.file).height;
        image.scale.y = rows > 1 ? static_cast<double>(rows - 1) / rows : 1.0;
        image.offset.y = rows > 1 ? 0.5 / rows : 0.0;
    } catch (const std::runtime_error& problem) {
        builder.error(plugin.position(), problem.what());
    }
    // Its left edge lies along -z, where the middle of ours does.
    builder.scene.background.rotation = 180.0;
    builder.scene.background.image = image;
    builder.honoured(plugin);
}

// Towards the sun, with z up, x to the east and y to the north; and how far it is.
glm::dvec3 sun_by_time(Builder& builder, Plugin& plugin, double& distance) {
    const double latitude = plugin.number("latitude", 35.689, -90.0, 90.0), longitude = plugin.number("longitude", 139.6917, -180.0, 180.0);
    const std::string day =
        fmt::format("{:04}-{:02}-{:02}T00:00:00Z", plugin.integer("year", 2010), plugin.integer("month", 7), plugin.integer("day", 10));
    const auto midnight = scene::days_since_2000(day);
    if (!midnight) {
        builder.error(plugin.position(), fmt::format("there is no date {}, or none from 1950 to 2050", day.substr(0, 10)));
        return {0.0, 0.0, 1.0};
    }
    const double hours = plugin.number("hour", 15.0) + plugin.number("minute", 0.0) / 60.0 + plugin.number("second", 0.0) / 3600.0;
    const double days = *midnight + (hours - plugin.number("timezone", plugin.number("standardMeridian", 135.0) / 15.0)) / 24.0;
    const scene::SunPosition sun = scene::sun_position(days, latitude, longitude);
    distance = sun.distance;
    const double height = glm::radians(sun.elevation), azimuth = glm::radians(sun.azimuth);
    return {std::cos(height) * std::sin(azimuth), std::cos(height) * std::cos(azimuth), std::sin(height)};
}

// Version 0.x has y up, and north along z.
void add_sky(Builder& builder, Plugin& plugin) {
    const bool y_up = builder.document.major_version() < 2;
    const glm::dmat4 to_world = plugin.transform("to_world").value_or(glm::dmat4(1.0));
    scene::ClearSky sky;
    const glm::dvec3 up = direction(to_world, y_up ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0));
    glm::dvec3 sun;
    if (plugin.has("sun_direction")) {
        sun = plugin.vector("sun_direction", glm::dvec3(0.0, 0.0, 1.0));
        sun = y_up ? direction(to_world, sun) : sun;
    } else {
        const glm::dvec3 local = sun_by_time(builder, plugin, sky.distance);
        sun = direction(to_world, y_up ? glm::dvec3(local.x, local.z, local.y) : local);
    }
    if (!(glm::length(up) > 0.0 && glm::length(sun) > 0.0)) {
        builder.error(plugin.position(), "the sky's transform is singular, or its sun nowhere");
        return;
    }
    sky.up = glm::normalize(up);
    sky.sun = glm::normalize(sun);
    sky.turbidity = plugin.number("turbidity", 3.0, 1.0, 10.0);
    const Color ground = visible(color_or(builder, plugin, "albedo", Color(y_up ? 0.2 : 0.3), Role::share), Role::share);
    sky.ground = std::clamp((ground.x + ground.y + ground.z) / 3.0, 0.0, 1.0);
    const double scale = std::max(plugin.number("sky_scale", plugin.number("scale", 1.0)), 0.0);
    const double sun_scale = plugin.number("sun_scale", 1.0);
    sky.has_sun = plugin.type() != "sky" && sun_scale > 0.0;
    for (const std::string_view name :
         {"sun_aperture", "sun_radius_scale", "stretch", "extend", "resolution", "samples_per_pixel", "complex_sun"}) {
        plugin.ignore(name);
    }
    builder.scene.background.sky = sky;
    builder.scene.background.strength = scale;
    builder.approximated(plugin, "our own model of a clear sky; the sun is as bright as it is in that");
}

struct Kind {
    std::string_view name;
    void (*add)(Builder&, Plugin&);
};

constexpr Kind kinds[] = {
    {"point", add_point},         {"spot", add_spot},         {"directional", add_directional},
    {"projector", add_projector}, {"constant", add_constant}, {"envmap", add_environment},
    {"sunsky", add_sky},          {"sky", add_sky},           {"sun", add_sky},
};

}  // namespace

std::optional<scene::Emission> emission_of(Builder& builder, const Element& element) {
    Plugin plugin = builder.plugin(element);
    scene::Emission emission;
    if (plugin.type() == "area") {
        emission.radiance = texture_or(builder, plugin, "radiance", Color(1.0), Role::light);
        builder.honoured(plugin);
    } else if (plugin.type() == "directionalarea") {
        emission.radiance = texture_or(builder, plugin, "radiance", Color(1.0), Role::light);
        builder.approximated(plugin, "light to all sides");
    } else {
        builder.error(element.position, fmt::format("{} can't belong to a shape: expected \"area\"", plugin.title()));
        return std::nullopt;
    }
    plugin.ignore("sampling_weight");
    plugin.finish();
    return emission;
}

void add_emitter(Builder& builder, const Element& element) {
    Plugin plugin = builder.plugin(element);
    plugin.ignore("sampling_weight");
    if (plugin.type() == "area" || plugin.type() == "directionalarea") {
        return;  // waits for a shape that refers to it
    }
    for (const Kind& kind : kinds) {
        if (kind.name == plugin.type()) {
            kind.add(builder, plugin);
            plugin.finish();
            return;
        }
    }
    std::vector<std::string> names = {"area"};
    for (const Kind& kind : kinds) {
        names.emplace_back(kind.name);
    }
    builder.dropped(plugin, "such light is not there");
    builder.context.diagnostics.warning(
        element.position, fmt::format("no emitter {} is known here: it is left out{}", quoted(plugin.type()), hint(plugin.type(), names)));
}

}  // namespace lancer::mitsuba
