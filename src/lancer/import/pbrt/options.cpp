#include "lancer/import/pbrt/options.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "lancer/import/pbrt/cameras.h"
#include "lancer/import/pbrt/transforms.h"

namespace lancer::pbrt {

void Options::set(Keyword keyword, Recipe recipe, const glm::dmat4& from_world) {
    if (keyword == Keyword::camera) {
        from_world_ = from_world;
    }
    recipes_.insert_or_assign(keyword, std::move(recipe));
}

const Recipe* Options::find(Keyword keyword) const {
    const auto found = recipes_.find(keyword);
    return found == recipes_.end() ? nullptr : &found->second;
}

bool Options::is_left_handed() const {
    // Its own x points right, y up and z forward: that is the left hand, unless the transform mirrors. Spherical cameras see it the other way.
    const Recipe* camera = find(Keyword::camera);
    const bool spherical = camera != nullptr && (camera->type == "spherical" || camera->type == "environment");
    return (glm::determinant(glm::dmat3(from_world_.value_or(glm::dmat4(1.0)))) > 0.0) != spherical;
}

double Options::finish(scene::Scene& scene) {
    scene::RenderSettings& settings = scene.settings;
    settings.integrator = "path";
    const double sensitivity = set_film(settings);
    set_filter(settings);
    set_sampler(settings);
    set_integrator(settings);
    const Recipe* camera = find(Keyword::camera);
    scene.cameras.push_back(build_camera(context_, camera, find(Keyword::film),
                                         from_world_.value_or(glm::dmat4(1.0)) * handedness(is_left_handed()), settings));
    double open = 1.0;
    if (camera != nullptr) {
        open = camera->parameters.number("shutterclose", 1.0) - camera->parameters.number("shutteropen", 0.0);
        camera->parameters.warn_of_unused();
    }
    if (const Recipe* option = find(Keyword::option)) {
        context_.report.dropped("Option", "it is for pbrt itself", option->parameters.position(), false);
    }
    return version3_ || !(open > 0.0) ? sensitivity : sensitivity * open;
}

double Options::set_film(scene::RenderSettings& settings) {
    const Recipe* film = find(Keyword::film);
    if (film == nullptr) {
        return 1.0;
    }
    const Parameters& parameters = film->parameters;
    const int width = parameters.integer("xresolution", version3_ ? 640 : 1280);
    const int height = parameters.integer("yresolution", version3_ ? 480 : 720);
    if (width < 1 || height < 1 || width > 1'000'000 || height > 1'000'000) {
        context_.diagnostics.error(parameters.position(), fmt::format("a picture of {} x {} pixels can't be made", width, height));
    } else {
        settings.width = width;
        settings.height = height;
    }
    const std::string sensor = parameters.string("sensor", "cie1931");
    if (sensor != "cie1931") {
        context_.report.approximated(fmt::format("sensor \"{}\"", sensor), "the eye's observer of 1931", parameters.position());
    }
    if (parameters.number("whitebalance", 0.0) != 0.0) {
        context_.report.dropped("\"whitebalance\"", "white stays as it is", parameters.position());
    }
    if (parameters.has("maxcomponentvalue") || parameters.has("maxsampleluminance")) {
        context_.report.dropped("\"maxcomponentvalue\"", "bright samples are not cut off", parameters.position());
    }
    parameters.pass_over({"cropwindow", "pixelbounds", "filename", "savefp16", "diagonal", "displayfile", "coordinatesystem", "nbuckets",
                          "lambdamin", "lambdamax"});
    if (film->type == "rgb" || film->type == "gbuffer" || (version3_ && film->type == "image")) {
        context_.report.honoured(parameters.owner(), parameters.position());
    } else {
        context_.report.approximated(parameters.owner(), "a film of red, green and blue", parameters.position());
    }
    const double sensitivity = parameters.number("iso", 100.0) / 100.0 * (version3_ ? parameters.number("scale", 1.0) : 1.0);
    parameters.warn_of_unused();
    return sensitivity > 0.0 ? sensitivity : 1.0;
}

void Options::set_filter(scene::RenderSettings& settings) {
    const Recipe* filter = find(Keyword::pixel_filter);
    settings.filter = version3_ && filter == nullptr ? scene::PixelFilter::box : scene::PixelFilter::gaussian;
    settings.filter_radius = settings.filter == scene::PixelFilter::box ? 0.5 : 1.5;
    if (filter == nullptr) {
        return;
    }
    const Parameters& parameters = filter->parameters;
    ImportReport& report = context_.report;
    double usual = 1.5;
    bool exact = true;
    if (filter->type == "box") {
        settings.filter = scene::PixelFilter::box;
        usual = 0.5;
    } else if (filter->type == "triangle") {
        settings.filter = scene::PixelFilter::tent;
        usual = 2.0;
    } else if (filter->type == "mitchell") {
        settings.filter = scene::PixelFilter::mitchell;
        usual = 2.0;
        const double b = parameters.number("B", 1.0 / 3.0), c = parameters.number("C", 1.0 / 3.0);
        exact = std::abs(b - 1.0 / 3.0) < 1e-3 && std::abs(c - 1.0 / 3.0) < 1e-3;
    } else if (filter->type != "gaussian") {
        settings.filter = scene::PixelFilter::mitchell;
        usual = 4.0;
        exact = false;
        parameters.pass_over({"tau"});
    }
    usual = version3_ && filter->type == "gaussian" ? 2.0 : usual;
    const double x = parameters.number("xradius", usual), y = parameters.number("yradius", usual);
    double radius = std::clamp(std::sqrt(std::max(x * y, 0.0)), 0.01, 16.0);
    exact = exact && x == y;
    if (filter->type == "gaussian") {
        // Ours ends at three standard deviations.
        const double sigma = version3_ ? std::sqrt(0.5 / std::max(parameters.number("alpha", 2.0), 1e-6)) : parameters.number("sigma", 0.5);
        exact = exact && std::abs(3.0 * sigma - radius) < 1e-3 * radius;
        radius = std::clamp(std::min(3.0 * sigma, radius), 0.01, 16.0);
    } else if (settings.filter == scene::PixelFilter::mitchell && filter->type != "mitchell") {
        radius = std::min(radius, 2.0);
    }
    settings.filter_radius = radius;
    if (exact) {
        report.honoured(parameters.owner(), parameters.position());
    } else {
        report.approximated(parameters.owner(), "a filter near to it", parameters.position());
    }
    parameters.warn_of_unused();
}

void Options::set_sampler(scene::RenderSettings& settings) {
    settings.spp = 16;
    const Recipe* sampler = find(Keyword::sampler);
    if (sampler == nullptr) {
        return;
    }
    const Parameters& parameters = sampler->parameters;
    const double samples = sampler->type == "stratified"
                               ? static_cast<double>(parameters.integer("xsamples", 4)) * parameters.integer("ysamples", 4)
                               : parameters.integer("pixelsamples", 16);
    settings.spp = static_cast<int>(std::clamp(samples, 1.0, 1e6));
    settings.seed = parameters.integer("seed", 0);
    parameters.pass_over({"randomization", "jitter", "dimensions", "samplepixelcenter"});
    context_.report.honoured("Sampler: samples a pixel", parameters.position());
    parameters.warn_of_unused();
}

// Both count the surfaces that light is scattered from between a lamp and the eye.
void Options::set_integrator(scene::RenderSettings& settings) {
    settings.bounces = 5;
    const Recipe* integrator = find(Keyword::integrator);
    if (integrator == nullptr) {
        return;
    }
    const Parameters& parameters = integrator->parameters;
    settings.bounces = std::clamp(parameters.integer("maxdepth", 5), 0, 1024);
    if (integrator->type == "path" || integrator->type == "volpath") {
        context_.report.honoured(parameters.owner(), parameters.position());
    } else if (integrator->type == "ambientocclusion" || integrator->type == "function") {
        context_.report.dropped(parameters.owner(), "paths are traced instead", parameters.position());
    } else {
        context_.report.approximated(parameters.owner(), "paths of the same length", parameters.position());
    }
    if (parameters.boolean("regularize", false)) {
        context_.report.dropped("\"regularize\"", "no surface is made rougher than it is", parameters.position());
    }
}

}  // namespace lancer::pbrt
