#include "lancer/import/pbrt/lights.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "lancer/image/image.h"
#include "lancer/import/made_picture.h"
#include "lancer/import/pbrt/environments.h"
#include "lancer/import/pbrt/files.h"
#include "lancer/import/pbrt/light_power.h"
#include "lancer/import/pbrt/transforms.h"

namespace lancer::pbrt {

namespace {

using std::numbers::pi;

// The mean of the channels in all of them.
Image grey(const Image& image) {
    Image result = image;
    const auto channels = static_cast<std::size_t>(image.channels);
    for (std::size_t i = 0; channels >= 3 && i < result.pixels.size(); i += channels) {
        float* p = &result.pixels[i];
        p[0] = p[1] = p[2] = (p[0] + p[1] + p[2]) / 3.0f;
    }
    return result;
}

// Right and left changed over; in three channels.
Image mirrored(const Image& image) {
    Image result{image.width, image.height, 3, {}};
    const auto width = static_cast<std::size_t>(image.width), channels = static_cast<std::size_t>(image.channels);
    result.pixels.reserve(width * static_cast<std::size_t>(image.height) * 3);
    for (std::size_t row = 0; row < static_cast<std::size_t>(image.height); ++row) {
        for (std::size_t column = width; column-- > 0;) {
            const float* p = &image.pixels[(row * width + column) * channels];
            result.pixels.insert(result.pixels.end(), {p[0], p[channels >= 3 ? 1 : 0], p[channels >= 3 ? 2 : 0]});
        }
    }
    return result;
}

// What a projector of unit scale sends out: the mean of the picture's channels times the solid angle of each pixel.
double thrown_flux(const Image& image, double fov) {
    const double half = std::tan(glm::radians(fov) / 2.0);
    const double aspect = static_cast<double>(image.width) / image.height;
    const double half_width = aspect > 1.0 ? half * aspect : half, half_height = aspect > 1.0 ? half : half / aspect;
    const double area = 4.0 * half_width * half_height / (static_cast<double>(image.width) * image.height);
    const auto channels = static_cast<std::size_t>(image.channels);
    double flux = 0.0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const double u = (2.0 * (x + 0.5) / image.width - 1.0) * half_width, v = (2.0 * (y + 0.5) / image.height - 1.0) * half_height;
            const float* p =
                &image.pixels[(static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)) *
                              channels];
            const double light = channels >= 3 ? (static_cast<double>(p[0]) + static_cast<double>(p[1]) + static_cast<double>(p[2])) / 3.0
                                               : static_cast<double>(p[0]);
            flux += light * area / std::pow(1.0 + u * u + v * v, 1.5);
        }
    }
    return flux;
}

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
    } else if (light.type == "goniometric") {
        add_goniometric(light, to_world);
    } else if (light.type == "projection") {
        add_projection(light, to_world);
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
    push(light, scene::PointLight{apply_to_point(to_world, from)}, color.color * color.scale);
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
    push(light, scene::SpotLight{apply_to_point(to_world, from), direction, angle, falloff}, color.color * color.scale);
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
    push(light, scene::DirectionalLight{direction}, color.color * color.scale);
    context_.report.honoured(parameters.owner(), parameters.position());
}

// The mean of a picture that a light throws; nothing when it can't be read.
// The picture of a light, its pixels read.
std::optional<Environment> Lights::thrown_picture(const Parameters& parameters) {
    const bool old = !parameters.has("filename") && parameters.has("mapname");
    const Parameter* parameter = parameters.find(old ? "mapname" : "filename");
    const auto name = parameters.string(old ? "mapname" : "filename");
    if (!name) {
        return std::nullopt;
    }
    Environment picture;
    picture.position = Parameters::position_of(*parameter);
    picture.file = find_file(context_, *name, *parameter->text);
    if (!context_.files.image(picture.file, picture.position)) {
        return std::nullopt;
    }
    try {
        picture.image = read_image(picture.file);
    } catch (const std::runtime_error& problem) {
        context_.diagnostics.error(picture.position, problem.what());
        return std::nullopt;
    }
    picture.square = !old && picture.image.width == picture.image.height;
    return picture;
}

void Lights::add_infinite(const Recipe& light, const glm::dmat4& to_world) {
    const Parameters& parameters = light.parameters;
    LightColor color = read_light_color(light, "L", version3_);
    if (parameters.has("portal")) {
        context_.report.dropped("\"portal\"", "it only helps to find the light", parameters.position(), false);
    }
    if (parameters.has("filename") || parameters.has("mapname")) {
        add_surroundings(light, color, to_world);
        return;
    }
    if (const auto illuminance = parameters.number("illuminance"); illuminance && *illuminance > 0.0) {
        color.scale *= *illuminance / pi;
    }
    everywhere_.push_back(color.color * color.scale);
    context_.report.honoured(parameters.owner(), parameters.position());
}

// A picture all around: of version 4 a square of equal areas, of version 3 latitudes and longitudes, tinted by "L".
void Lights::add_surroundings(const Recipe& light, const LightColor& color, const glm::dmat4& to_world) {
    const Parameters& parameters = light.parameters;
    const bool old = !parameters.has("filename");
    const Parameter* parameter = parameters.find(old ? "mapname" : "filename");
    const auto name = parameters.string(old ? "mapname" : "filename");
    if (!name) {
        return;
    }
    Environment environment;
    environment.position = Parameters::position_of(*parameter);
    environment.file = find_file(context_, *name, *parameter->text);
    if (!context_.files.image(environment.file, environment.position)) {
        return;
    }
    environment.square = !old && !version3_;
    environment.scale = (parameters.has("L") || version3_ ? visible_light(color.color) : scene::Rgb(1.0)) * color.scale;
    environment.to_light = glm::inverse(glm::dmat3(to_world));
    if (environment.square) {
        try {
            environment.image = read_image(environment.file);
        } catch (const std::runtime_error& problem) {
            context_.diagnostics.error(environment.position, problem.what());
            return;
        }
        if (environment.image.width != environment.image.height) {
            context_.diagnostics.error(environment.position,
                                       fmt::format("surroundings of pbrt-v4 are square pictures; this one is {} x {} pixels",
                                                   environment.image.width, environment.image.height));
            return;
        }
        if (const auto illuminance = parameters.number("illuminance"); illuminance && *illuminance > 0.0) {
            const double given = illuminance_of(environment.image);
            environment.scale *= given > 0.0 ? *illuminance / given : 1.0;
        }
        context_.report.approximated(parameters.owner() + ": a square of equal areas", "latitudes and longitudes as fine",
                                     parameters.position());
    } else {
        context_.report.honoured(parameters.owner(), parameters.position());
    }
    environments_.push_back(std::move(environment));
}

void Lights::place_surroundings(double brightness) {
    scene::Background& background = scene_.background;
    if (environments_.empty()) {
        Color even;
        if (everywhere_.size() == 1) {
            even = everywhere_.front() * brightness;
        } else {
            for (const Color& part : everywhere_) {
                even.rgb += visible_light(part) * brightness;
            }
        }
        background.zenith = background.horizon = background.nadir = even;
        return;
    }
    scene::Rgb rest(0.0);
    for (const Color& part : everywhere_) {
        rest += visible_light(part);
    }
    if (environments_.size() == 1 && !environments_.front().square && rest == scene::Rgb(0.0) &&
        turned_axes(environments_.front(), background.axes)) {
        scene::ImageTexture image;
        image.file = environments_.front().file;
        image.position = environments_.front().position;
        image.tint = environments_.front().scale;
        background.image = image;
        background.rotation = 180.0;
    } else {
        for (Environment& environment : environments_) {
            try {
                environment.image = environment.image.pixels.empty() ? read_image(environment.file) : std::move(environment.image);
            } catch (const std::runtime_error& problem) {
                context_.diagnostics.error(environment.position, problem.what());
                return;
            }
        }
        background.image = panorama_of(environments_, rest);
    }
    background.strength = brightness;
}

// Of version 4: a square of equal areas, looked up in the light's own space.
void Lights::add_goniometric(const Recipe& light, const glm::dmat4& to_world) {
    const Parameters& parameters = light.parameters;
    LightColor color = read_light_color(light, "I", version3_);
    const glm::dvec3 position = apply_to_point(to_world, glm::dvec3(0.0));
    const auto picture = thrown_picture(parameters);
    const scene::Rgb mean = picture ? mean_color(picture->image, picture->square) : scene::Rgb(1.0);
    if (const auto power = parameters.number("power"); power && *power > 0.0) {
        color.scale *= *power / (4.0 * pi * std::max((mean.x + mean.y + mean.z) / 3.0, 1e-6));
    }
    const scene::Rgb tint = visible_light(color.color) * color.scale;
    if (picture && picture->square && !version3_) {
        Environment environment;
        environment.position = picture->position;
        environment.image = grey(picture->image);
        // The middle of the square lies along y, unlike that of surroundings.
        const glm::dmat3 swapped(glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(0.0, 1.0, 0.0));
        environment.to_light = swapped * glm::inverse(glm::dmat3(to_world));
        push(light, scene::GoniometricLight{position, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}, panorama_of({environment}, scene::Rgb(0.0))},
             Color(tint));
        context_.report.approximated(parameters.owner() + ": a square of equal areas", "latitudes and longitudes as fine",
                                     parameters.position());
        return;
    }
    push(light, scene::PointLight{position}, Color(tint * mean));
    context_.report.approximated(parameters.owner(), "a point light of the same power", parameters.position());
}

// As intense in each direction as the picture says, which spans the field of view along its shorter side.
void Lights::add_projection(const Recipe& light, const glm::dmat4& to_world) {
    const Parameters& parameters = light.parameters;
    scene::ProjectorLight projector;
    projector.position = apply_to_point(to_world, glm::dvec3(0.0));
    projector.direction = apply_to_direction(to_world, {0.0, 0.0, 1.0});
    projector.up = apply_to_direction(to_world, {0.0, 1.0, 0.0});
    projector.fov = std::clamp(parameters.number("fov", version3_ ? 45.0 : 90.0), 1.0, 179.0);
    projector.fov_axis = scene::ProjectorFov::smaller;
    projector.even = false;
    double scale = parameters.number("scale", 1.0);
    const auto power = parameters.number("power");
    parameters.pass_over({"I"});
    if (const auto picture = thrown_picture(parameters)) {
        scene::ImageTexture image;
        image.file = picture->file;
        image.position = picture->position;
        if (glm::determinant(glm::dmat3(to_world)) > 0.0) {
            // Its right is where x grows, and that is to the left of who looks along z in a space of this hand.
            image = made_picture(mirrored(picture->image), picture->position);
        }
        image.wrap = scene::Wrap::clamp;
        projector.image = image;
        if (power && *power > 0.0) {
            const double flux = thrown_flux(picture->image, projector.fov);
            scale *= *power / std::max(flux, 1e-9);
        }
    }
    push(light, projector, Color(scene::Rgb(scale)));
    context_.report.honoured(parameters.owner(), parameters.position());
}

void Lights::push(const Recipe& light, decltype(scene::Light::model) model, const Color& power) {
    scene::Light made;
    made.model = std::move(model);
    made.position = light.parameters.position();
    scene_.lights.push_back(std::move(made));
    powers_.push_back(power);
}

void Lights::finish(double brightness) {
    for (std::size_t i = 0; i < powers_.size(); ++i) {
        scene_.lights[i].power = powers_[i] * brightness;
    }
    const bool shines =
        std::any_of(scene_.materials.begin(), scene_.materials.end(), [](const scene::Material& m) { return m.emission.has_value(); });
    const bool glows = std::any_of(scene_.media.begin(), scene_.media.end(), [](const scene::Medium& m) {
        return m.emission_strength > 0.0 && (m.emission.spectrum || m.emission.rgb != scene::Rgb(0.0));
    });
    if (!shines && !glows && scene_.lights.empty() && everywhere_.empty() && environments_.empty()) {
        everywhere_.push_back(Color(scene::Rgb(1.0 / brightness)));
        context_.diagnostics.warning({scene_.file, 0, 0}, "this scene has no light: white light comes from everywhere instead");
    }
    place_surroundings(brightness);
}

}  // namespace lancer::pbrt
