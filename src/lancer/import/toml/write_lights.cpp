// Lights without a shape, and the photometric files of some of them.
#include <fmt/format.h>

#include "lancer/import/toml/write_context.h"

namespace lancer::notation {

namespace {

const char* word(scene::SpotFade fade) {
    switch (fade) {
        case scene::SpotFade::smooth:
            return "smooth";
        case scene::SpotFade::even:
            return "even";
        case scene::SpotFade::square:
            return "square";
    }
    return "";
}

const char* word(scene::ProjectorFov axis) {
    switch (axis) {
        case scene::ProjectorFov::width:
            return "width";
        case scene::ProjectorFov::height:
            return "height";
        case scene::ProjectorFov::smaller:
            return "smaller";
    }
    return "";
}

std::string lines_of(const std::vector<double>& numbers) {
    std::string text;
    for (const double number : numbers) {
        text += number_text(number) + "\n";
    }
    return text;
}

// A file of its own (ANSI/IES LM-63), of one lamp of photometry type C without a size.
std::string write_photometry(WriteContext& context, const std::shared_ptr<const scene::Photometry>& photometry) {
    const auto& [vertical, horizontal, candela] = *photometry;
    const auto [known, is_new] = context.photometries.try_emplace(photometry.get());
    if (is_new) {
        known->second = fmt::format("{}-{}.ies", context.stem, context.photometries.size());
        auto bytes = std::make_shared<std::string>(
            fmt::format("IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 {} {} 1 2 0 0 0\n1 1 0\n", vertical.size(), horizontal.size()));
        *bytes += lines_of(vertical) + lines_of(horizontal) + lines_of(candela);
        context.result.pictures.push_back({known->second, std::move(bytes)});
    }
    return known->second;
}

void add_picture(WriteContext& context, Fields& fields, const scene::ImageTexture& image) {
    fields.text("image", write_picture(context, image));
    fields.text("encoding", image.linear ? "linear" : "srgb", "srgb");
    fields.vector("tint", image.tint, scene::Rgb(1.0));
}

void add_thrown_picture(WriteContext& context, Fields& fields, const std::optional<scene::ImageTexture>& image) {
    if (image) {
        add_picture(context, fields, *image);
        fields.text("wrap", wrap_word(image->wrap), wrap_word(scene::Wrap::clamp));
    }
}

void add_model(WriteContext& context, Fields& fields, const decltype(scene::Light::model)& model) {
    std::visit(Overloaded{[&](const scene::PointLight& point) {
                              const auto& [at] = point;
                              fields.text("type", "point");
                              fields.vector("position", at);
                          },
                          [&](const scene::SpotLight& spot) {
                              const auto& [at, direction, angle, falloff, image, up, fade] = spot;
                              fields.text("type", "spot");
                              fields.vector("position", at);
                              fields.vector("direction", direction);
                              fields.number("angle", angle);
                              fields.number("falloff", falloff);
                              fields.text("fade", word(fade), word(scene::SpotFade::smooth));
                              add_thrown_picture(context, fields, image);
                              if (image) {
                                  fields.vector("up", up);
                              }
                          },
                          [&](const scene::DirectionalLight& sun) {
                              const auto& [direction] = sun;
                              fields.text("type", "directional");
                              fields.vector("direction", direction);
                          },
                          [&](const scene::ProjectorLight& projector) {
                              const auto& [at, direction, up, fov, fov_axis, image, even] = projector;
                              fields.text("type", "projector");
                              fields.vector("position", at);
                              fields.vector("direction", direction);
                              fields.vector("up", up);
                              fields.number("fov", fov);
                              fields.text("fov_axis", word(fov_axis), word(scene::ProjectorFov::width));
                              add_thrown_picture(context, fields, image);
                              fields.flag("even", even, true);
                          },
                          [&](const scene::GoniometricLight& goniometric) {
                              const auto& [at, direction, up, image] = goniometric;
                              fields.text("type", "goniometric");
                              fields.vector("position", at);
                              fields.vector("direction", direction);
                              fields.vector("up", up);
                              add_picture(context, fields, image);
                          },
                          [&](const scene::IesLight& lamp) {
                              const auto& [at, direction, forward, photometry] = lamp;
                              fields.text("type", "ies");
                              fields.vector("position", at);
                              fields.vector("direction", direction);
                              fields.vector("forward", forward);
                              fields.text("file", write_photometry(context, photometry));
                          }},
               model);
}

// Whether it can have a share of a Whitted scene's light.
bool is_shared(const scene::Light& light) {
    return std::holds_alternative<scene::PointLight>(light.model) || std::holds_alternative<scene::SpotLight>(light.model) ||
           std::holds_alternative<scene::DirectionalLight>(light.model);
}

}  // namespace

std::string write_light(WriteContext& context, const scene::Light& light) {
    const auto& [name, model, color, intensity, position, power] = light;
    static_cast<void>(position);
    Fields fields;
    fields.text("name", name, "");
    add_model(context, fields, model);
    if (is_shared(light)) {
        add_color(fields, "color", color, scene::Rgb(1.0));
    }
    if (power) {
        fields.raw("power", write_color(*power));
    }
    if (is_shared(light)) {
        fields.number("intensity", intensity);
    }
    return "\n[[light]]\n" + fields.lines();
}

}  // namespace lancer::notation
