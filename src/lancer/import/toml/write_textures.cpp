// Colours, textures, and numbers that come from them.
#include <fmt/format.h>

#include "lancer/image/signature.h"
#include "lancer/import/toml/write_context.h"

namespace lancer::notation {

namespace {

const char* word(scene::Filter filter) {
    switch (filter) {
        case scene::Filter::nearest:
            return "nearest";
        case scene::Filter::bilinear:
            return "bilinear";
        case scene::Filter::mipmaps:
            return "mipmaps";
    }
    return "";
}

const char* word(scene::Channel channel) {
    switch (channel) {
        case scene::Channel::red:
            return "red";
        case scene::Channel::green:
            return "green";
        case scene::Channel::blue:
            return "blue";
        case scene::Channel::alpha:
            return "alpha";
    }
    return "";
}

void add_curve(Fields& fields, const scene::MeasuredSpectrum& curve) {
    const auto& [nanometres, values] = curve;
    fields.raw("wavelengths", list_text(nanometres));
    fields.raw("values", list_text(values));
}

std::string write_spectrum(const scene::Spectrum& spectrum) {
    const auto& [shape, scale, luminance, as_rgb] = spectrum;
    Fields fields;
    std::visit(Overloaded{[&](const scene::MeasuredSpectrum& curve) { add_curve(fields, curve); },
                          [&](const scene::IlluminantSpectrum& light) {
                              const auto& [name] = light;
                              fields.text("illuminant", name);
                          },
                          [&](const scene::BlackbodySpectrum& body) {
                              const auto& [kelvin] = body;
                              fields.number("blackbody", kelvin);
                          },
                          [&](const scene::DaylightSpectrum& day) {
                              const auto& [kelvin] = day;
                              fields.number("daylight", kelvin);
                          },
                          [&](const scene::MetalSpectrum& metal) {
                              const auto& [name] = metal;
                              fields.text("metal", name);
                          },
                          [&](const scene::TintedSpectrum& tinted) {
                              const auto& [rgb, illuminant] = tinted;
                              fields.vector("rgb", rgb);
                              fields.text("illuminant", illuminant, "");
                          }},
               shape);
    fields.number("scale", scale, 1.0);
    if (as_rgb) {
        fields.vector("as_rgb", *as_rgb);
    }
    if (luminance) {
        fields.number("luminance", *luminance);
    }
    return fields.braces();
}

// The file that an embedded picture becomes, by what its first bytes say it is.
std::string ending_of(const std::string& bytes) {
    const std::string format = image_format(bytes, "");
    return format.empty() ? ".picture" : format == "jpeg" ? ".jpg" : format == "openexr" ? ".exr" : "." + format;
}

std::string write_image(WriteContext& context, const scene::ImageTexture& image) {
    const auto& [file, bytes, wrap, wrap_v, filter, linear, scale, rotation, offset, uv_set, tint, times_mesh_colors, position] = image;
    static_cast<void>(file), static_cast<void>(bytes), static_cast<void>(position);
    const scene::ImageTexture preset{};
    Fields fields;
    fields.text("type", "image");
    fields.text("file", write_picture(context, image));
    fields.text("wrap", wrap_word(wrap), wrap_word(preset.wrap));
    if (wrap_v) {
        fields.text("wrap_v", wrap_word(*wrap_v));
    }
    fields.text("filter", word(filter), word(preset.filter));
    fields.text("encoding", linear ? "linear" : "srgb");
    fields.number("uv_set", uv_set, preset.uv_set);
    fields.vector("scale", scale, preset.scale);
    fields.number("rotation", rotation, preset.rotation);
    fields.vector("offset", offset, preset.offset);
    fields.vector("tint", tint, preset.tint);
    fields.flag("vertex_colors", times_mesh_colors, preset.times_mesh_colors);
    return fields.braces();
}

}  // namespace

const char* wrap_word(scene::Wrap wrap) {
    switch (wrap) {
        case scene::Wrap::repeat:
            return "repeat";
        case scene::Wrap::clamp:
            return "clamp";
        case scene::Wrap::mirror:
            return "mirror";
    }
    return "";
}

std::string write_curve(const scene::MeasuredSpectrum& curve) {
    Fields fields;
    add_curve(fields, curve);
    return fields.braces();
}

std::string write_color(const scene::Color& color) {
    const auto& [rgb, spectrum] = color;
    return spectrum ? write_spectrum(*spectrum) : list_text(rgb);
}

std::string write_picture(WriteContext& context, const scene::ImageTexture& image) {
    namespace fs = std::filesystem;
    if (!image.bytes) {
        std::error_code problem;
        const fs::path from = fs::absolute(context.folder, problem).lexically_normal();
        const fs::path relative = fs::absolute(image.file, problem).lexically_normal().lexically_relative(from);
        return relative.empty() ? image.file : relative.generic_string();
    }
    const auto [known, is_new] = context.pictures.try_emplace(image.bytes.get());
    if (is_new) {
        known->second = fmt::format("{}-{}{}", context.stem, context.pictures.size(), ending_of(*image.bytes));
        context.result.pictures.push_back({known->second, image.bytes});
    }
    return known->second;
}

std::string write_texture(WriteContext& context, const scene::Texture& texture) {
    return std::visit(Overloaded{[](const scene::Color& color) { return write_color(color); },
                                 [](const scene::Checker& checker) {
                                     const auto& [first, second, size, solid] = checker;
                                     const scene::Checker preset{};
                                     Fields fields;
                                     fields.text("type", "checker");
                                     fields.vector("first", first, preset.first);
                                     fields.vector("second", second, preset.second);
                                     fields.number("size", size, preset.size);
                                     fields.flag("solid", solid, preset.solid);
                                     return fields.braces();
                                 },
                                 [&](const scene::ImageTexture& image) { return write_image(context, image); },
                                 [](const scene::MeshColors& colors) {
                                     const auto& [of_faces, tint] = colors;
                                     Fields fields;
                                     fields.text("type", of_faces ? "face_color" : "vertex_color");
                                     fields.vector("tint", tint, scene::Rgb(1.0));
                                     return fields.braces();
                                 }},
                      texture);
}

std::string write_value(WriteContext& context, const scene::Value& value) {
    const auto& [number, texture, channel, scale, offset] = value;
    if (!texture) {
        return number_text(number);
    }
    Fields fields;
    fields.raw("texture", write_texture(context, *texture));
    fields.text("channel", word(channel), word(scene::Channel::red));
    fields.number("scale", scale, 1.0);
    fields.number("offset", offset, 0.0);
    return fields.braces();
}

std::string write_refraction(const scene::Refraction& refraction) {
    return std::visit(Overloaded{[](double index) { return number_text(index); },
                                 [](const scene::AbbeGlass& glass) {
                                     const auto& [index, abbe_number] = glass;
                                     Fields fields;
                                     fields.number("index", index);
                                     fields.number("abbe_number", abbe_number);
                                     return fields.braces();
                                 },
                                 [](const scene::SellmeierGlass& glass) {
                                     const auto& [b, c] = glass;
                                     Fields fields;
                                     fields.vector("b", b);
                                     fields.vector("c", c);
                                     return fields.braces();
                                 },
                                 [](const scene::NamedGlass& glass) {
                                     const auto& [name] = glass;
                                     return quoted_text(name);
                                 },
                                 [](const scene::MeasuredSpectrum& curve) { return write_curve(curve); }},
                      refraction);
}

void add_color(Fields& fields, std::string_view key, const scene::Color& color, const scene::Color& preset) {
    if (color != preset) {
        fields.raw(key, write_color(color));
    }
}

void add_texture(Fields& fields, std::string_view key, WriteContext& context, const scene::Texture& texture, const scene::Color& preset) {
    const auto* color = std::get_if<scene::Color>(&texture);
    if (color == nullptr || *color != preset) {
        fields.raw(key, write_texture(context, texture));
    }
}

void add_value(Fields& fields, std::string_view key, WriteContext& context, const scene::Value& value, double preset) {
    if (value.texture || value.number != preset) {
        fields.raw(key, write_value(context, value));
    }
}

}  // namespace lancer::notation
