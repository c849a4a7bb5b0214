// Cameras, surroundings, and how the picture is made.
#include <fmt/format.h>

#include "lancer/import/toml/notation.h"
#include "lancer/import/toml/write_context.h"

namespace lancer::notation {

namespace {

const char* word(scene::Projection projection) {
    switch (projection) {
        case scene::Projection::perspective:
            return "perspective";
        case scene::Projection::orthographic:
            return "orthographic";
        case scene::Projection::panorama:
            return "panorama";
    }
    return "";
}

const char* word(scene::FovAxis axis) {
    switch (axis) {
        case scene::FovAxis::width:
            return "width";
        case scene::FovAxis::height:
            return "height";
    }
    return "";
}

const char* word(scene::Antialiasing kind) {
    switch (kind) {
        case scene::Antialiasing::uniform:
            return "uniform";
        case scene::Antialiasing::adaptive:
            return "adaptive";
    }
    return "";
}

const char* word(scene::DirectSamples samples) {
    switch (samples) {
        case scene::DirectSamples::mis:
            return "mis";
        case scene::DirectSamples::emitter:
            return "emitter";
        case scene::DirectSamples::bsdf:
            return "bsdf";
    }
    return "";
}

const char* word(scene::PixelFilter filter) {
    switch (filter) {
        case scene::PixelFilter::box:
            return "box";
        case scene::PixelFilter::tent:
            return "tent";
        case scene::PixelFilter::gaussian:
            return "gaussian";
        case scene::PixelFilter::mitchell:
            return "mitchell";
        case scene::PixelFilter::blackman_harris:
            return "blackman_harris";
    }
    return "";
}

Fields camera_fields(const scene::Camera& written) {
    const auto& [name, position, direction, up, fov, fov_axis, projection, extent, aperture, focus_distance, shift, pixel_aspect, source] =
        written;
    static_cast<void>(name), static_cast<void>(source);
    const scene::Camera preset{};
    Fields fields;
    fields.vector("position", position);
    fields.vector("direction", direction);
    fields.vector("up", up);
    fields.number("fov", fov);
    fields.text("fov_axis", word(fov_axis), word(preset.fov_axis));
    fields.text("projection", word(projection), word(preset.projection));
    fields.number("extent", extent, preset.extent);
    fields.vector("shift", shift, preset.shift);
    fields.number("pixel_aspect", pixel_aspect, preset.pixel_aspect);
    fields.number("aperture", aperture, preset.aperture);
    fields.number("focus_distance", focus_distance, preset.focus_distance);
    return fields;
}

}  // namespace

// The first camera is the one that is used: an unnamed one comes first, and names keep their order.
std::string write_cameras(const std::vector<scene::Camera>& cameras) {
    std::vector<std::string> names;
    for (const scene::Camera& each : cameras) {
        names.push_back(each.name);
    }
    std::vector<std::string> keys;
    for (const Key& key : camera().keys) {
        keys.emplace_back(key.name);
    }
    names = distinct_names(names, "camera", keys);
    std::string text;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        const bool is_unnamed = i == 0 && cameras[i].name.empty();
        text += fmt::format("\n[camera{}]\n{}", is_unnamed ? "" : "." + key_text(names[i]), camera_fields(cameras[i]).lines());
    }
    return text;
}

std::string write_background(WriteContext& context, const scene::Background& background) {
    const auto& [zenith, horizon, nadir, image, rotation, axes, sky, strength, visible] = background;
    Fields fields;
    if (sky) {
        const auto& [sun, distance, turbidity, ozone, ground, has_sun, up] = *sky;
        fields.vector("toward_sun", sun);
        fields.number("sun_distance", distance, 1.0);
        fields.number("turbidity", turbidity);
        fields.number("ozone", ozone);
        fields.number("ground", ground);
        fields.flag("sun", has_sun, true);
        fields.vector("up", up, glm::dvec3(0.0, 1.0, 0.0));
    } else if (image) {
        // Of a picture all around, no more than these matter.
        fields.text("image", write_picture(context, *image));
        fields.text("encoding", image->linear ? "linear" : "srgb", "srgb");
        fields.vector("tint", image->tint, scene::Rgb(1.0));
        fields.number("stretch", image->scale.y, 1.0);
        fields.number("lift", image->offset.y, 0.0);
        fields.number("rotation", rotation, 0.0);
        if (axes != glm::dmat3(1.0)) {
            fields.raw("axes", fmt::format("[{}, {}, {}]", list_text(axes[0]), list_text(axes[1]), list_text(axes[2])));
        }
    } else if (zenith == horizon && nadir == horizon) {
        fields.raw("color", write_color(horizon));
    } else {
        fields.raw("zenith", write_color(zenith));
        fields.raw("horizon", write_color(horizon));
        fields.raw("nadir", write_color(nadir));
    }
    fields.number("strength", strength, 1.0);
    fields.flag("visible", visible, true);
    return (sky ? "\n[sky]\n" : "\n[background]\n") + fields.lines();
}

std::string write_settings(const scene::RenderSettings& settings) {
    const auto& [width, height, integrator, bounces, diffuse_bounces, glossy_bounces, transmission_bounces, direct_samples, spp, rgb, seed,
                 filter, filter_radius, ssaa, antialiasing, adaptive_threshold, adaptive_depth, min_weight, wavelengths, exposure, view,
                 aovs, spectral_bins, wide] = settings;
    const scene::RenderSettings preset{};
    Fields fields;
    const auto if_set = [&](const char* key, const std::optional<int>& value) {
        if (value) {
            fields.number(key, *value);
        }
    };
    fields.raw("size", fmt::format("[{}, {}]", width, height));
    fields.text("integrator", integrator, preset.integrator);
    if_set("bounces", bounces);
    if_set("diffuse_bounces", diffuse_bounces);
    if_set("glossy_bounces", glossy_bounces);
    if_set("transmission_bounces", transmission_bounces);
    fields.text("direct_samples", word(direct_samples), word(preset.direct_samples));
    fields.number("spp", spp, preset.spp);
    fields.flag("rgb", rgb, preset.rgb);
    fields.number("seed", seed, preset.seed);
    fields.text("filter", word(filter), word(preset.filter));
    if (filter_radius) {
        fields.number("filter_radius", *filter_radius);
    }
    fields.number("ssaa", ssaa, preset.ssaa);
    fields.text("aa", word(antialiasing), word(preset.antialiasing));
    fields.number("adaptive_threshold", adaptive_threshold, preset.adaptive_threshold);
    fields.number("adaptive_depth", adaptive_depth, preset.adaptive_depth);
    fields.number("min_weight", min_weight, preset.min_weight);
    fields.number("wavelengths", wavelengths, preset.wavelengths);
    fields.number("exposure", exposure, preset.exposure);
    fields.text("view", view, preset.view);
    if (!aovs.empty()) {
        std::string list;
        for (const std::string& aov : aovs) {
            list += (list.empty() ? "" : ", ") + quoted_text(aov);
        }
        fields.raw("aovs", "[" + list + "]");
    }
    fields.number("spectral_bins", spectral_bins, preset.spectral_bins);
    fields.flag("float", wide, preset.wide);
    return "\n[render]\n" + fields.lines();
}

}  // namespace lancer::notation
