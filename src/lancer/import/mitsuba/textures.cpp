#include "lancer/import/mitsuba/textures.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "lancer/image/image.h"
#include "lancer/import/made_picture.h"
#include "lancer/import/mesh/mesh_messages.h"
#include "lancer/import/mitsuba/values.h"

namespace lancer::mitsuba {

namespace {

// uv' = (x, y) u + offset, column by column.
struct UvTransform {
    glm::dvec2 x{1.0, 0.0};
    glm::dvec2 y{0.0, 1.0};
    glm::dvec2 offset{0.0};
};

double luminance(const Color& color) { return glm::dot(color, glm::dvec3(0.2126, 0.7152, 0.0722)); }

UvTransform uv_transform(Plugin& plugin) {
    UvTransform uv;
    if (const auto matrix = plugin.transform("to_uv")) {
        uv.x = {(*matrix)[0].x, (*matrix)[0].y};
        uv.y = {(*matrix)[1].x, (*matrix)[1].y};
        uv.offset = {(*matrix)[3].x, (*matrix)[3].y};
    }
    // As version 0.x writes it.
    const double both = plugin.number("uvscale", 1.0);
    const glm::dvec2 scale(plugin.number("uscale", both), plugin.number("vscale", both));
    uv.x *= scale;
    uv.y *= scale;
    uv.offset = uv.offset * scale + glm::dvec2(plugin.number("uoffset", 0.0), plugin.number("voffset", 0.0));
    return uv;
}

// Mitsuba's (0, 0) is the picture's upper left corner, ours the lower left one.
void set_transform(Builder& builder, Plugin& plugin, const UvTransform& uv, scene::ImageTexture& image) {
    const glm::dvec2 x(uv.x.x, -uv.x.y), y(uv.y.x, -uv.y.y);
    image.offset = {uv.offset.x, 1.0 - uv.offset.y};
    const double length = glm::length(x);
    if (!(length > 0.0)) {
        image.scale = {0.0, glm::length(y)};
        return;
    }
    image.rotation = glm::degrees(std::atan2(x.y, x.x));
    image.scale = {length, (x.x * y.y - x.y * y.x) / length};
    if (std::abs(glm::dot(x, y)) > 1e-9 * length * glm::length(y)) {
        builder.approximated(plugin, "\"to_uv\" without its shear");
    }
}

// Where it gives numbers Mitsuba has the two the other way round.
scene::Texture checkerboard(Builder& builder, Plugin& plugin, Role role, bool gives_numbers) {
    scene::Checker checker;
    checker.first = visible(color_or(builder, plugin, "color0", Color(0.4), role), role);
    checker.second = visible(color_or(builder, plugin, "color1", Color(0.2), role), role);
    checker.solid = false;
    if (gives_numbers) {
        std::swap(checker.first, checker.second);
    }
    const UvTransform uv = uv_transform(plugin);
    const double scale = glm::length(uv.x);
    builder.honoured(plugin);
    if (scale > 0.0 && std::abs(glm::length(uv.y) - scale) <= 1e-9 * scale && uv.x.y == 0.0 && uv.y.x == 0.0 &&
        uv.offset == glm::dvec2(0.0)) {
        checker.size = 0.5 / scale;
        return checker;
    }
    // Squares of any shape: four texels, repeated.
    Image squares{2, 2, 3, {}};
    for (const Color& color : {checker.first, checker.second, checker.second, checker.first}) {
        for (int i = 0; i < 3; ++i) {
            squares.pixels.push_back(static_cast<float>(color[i]));
        }
    }
    scene::ImageTexture picture = made_picture(squares, plugin.position());
    picture.filter = scene::Filter::nearest;
    set_transform(builder, plugin, uv, picture);
    return picture;
}

scene::Wrap wrap_mode(Builder& builder, Plugin& plugin, std::string_view name, std::string_view preset) {
    const std::string mode = plugin.text(name, preset);
    if (mode == "mirror") {
        return scene::Wrap::mirror;
    }
    if (mode != "repeat" && mode != "clamp") {
        builder.approximated(plugin, fmt::format("\"clamp\" for the {} {}", name, quoted(mode)));
    }
    return mode == "repeat" ? scene::Wrap::repeat : scene::Wrap::clamp;
}

scene::Texture bitmap(Builder& builder, Plugin& plugin) {
    scene::ImageTexture image;
    image.position = plugin.position();
    image.file = builder.document.resolve(plugin.text("filename", ""), plugin.position());
    const std::string filter = plugin.text("filter_type", "bilinear");
    image.filter = filter == "nearest" ? scene::Filter::nearest : scene::Filter::bilinear;
    const std::string both = plugin.text("wrap_mode", "repeat");
    image.wrap = wrap_mode(builder, plugin, "wrap_mode_u", both);
    const scene::Wrap along_v = wrap_mode(builder, plugin, "wrap_mode_v", both);
    if (along_v != image.wrap) {
        image.wrap_v = along_v;
    }
    image.linear = plugin.flag("raw", false) || plugin.number("gamma", 0.0) == 1.0;
    for (const std::string_view name : {"format", "accel", "max_anisotropy", "cache", "channel"}) {
        plugin.ignore(name);
    }
    set_transform(builder, plugin, uv_transform(plugin), image);
    if (!builder.context.files.image(image, plugin.position())) {
        return Color(1.0, 0.0, 1.0);
    }
    builder.honoured(plugin);
    return image;
}

scene::Texture mesh_attribute(Builder& builder, Plugin& plugin) {
    scene::MeshColors colors;
    colors.of_faces = plugin.text("name", "").rfind("face_", 0) == 0;
    const double scale = plugin.number("scale", 1.0);
    if (scale != 1.0) {
        builder.context.report.dropped(fmt::format("{}: \"scale\"", plugin.title()), "it is 1", plugin.position());
    }
    builder.honoured(plugin);
    return colors;
}

}  // namespace

scene::Texture texture_of(Builder& builder, const Element& element, Role role, bool gives_numbers) {
    const Nesting nesting(builder, element.position);
    if (nesting.too_deep()) {
        return Color(0.0);
    }
    if (const auto color = color_of(builder, element, role)) {
        return *color;
    }
    Plugin plugin = builder.plugin(element);
    scene::Texture texture = Color(0.5);
    if (plugin.type() == "bitmap") {
        texture = bitmap(builder, plugin);
    } else if (plugin.type() == "checkerboard") {
        texture = checkerboard(builder, plugin, role, gives_numbers);
    } else if (plugin.type() == "mesh_attribute") {
        texture = mesh_attribute(builder, plugin);
    } else {
        builder.approximated(plugin, "grey of one half");
        return texture;
    }
    plugin.finish();
    return texture;
}

scene::Texture texture_or(Builder& builder, Plugin& plugin, std::string_view name, const Color& preset, Role role) {
    const Element* element = plugin.find(name);
    return element ? texture_of(builder, *element, role) : scene::Texture(preset);
}

scene::Value value_of(Builder& builder, const Element& element) {
    scene::Value value;
    value.texture.emplace(texture_of(builder, element, Role::index, true));
    if (const auto* color = std::get_if<scene::Color>(&*value.texture)) {
        value.number = luminance(visible(*color, Role::index));
        value.texture.reset();
    }
    return value;
}

scene::Value value_or(Builder& builder, Plugin& plugin, std::string_view name, double preset) {
    const Element* element = plugin.find(name);
    return element ? value_of(builder, *element) : scene::Value(preset);
}

scene::Value changed_value_or(Builder& builder, Plugin& plugin, std::string_view name, double preset,
                              const std::function<double(double)>& change) {
    scene::Value value = value_or(builder, plugin, name, preset);
    if (!value.texture) {
        value.number = change(value.number);
        return value;
    }
    if (auto* checker = std::get_if<scene::Checker>(&*value.texture)) {
        checker->first = Color(change(checker->first.x));
        checker->second = Color(change(checker->second.x));
        return value;
    }
    auto* image = std::get_if<scene::ImageTexture>(&*value.texture);
    if (!image) {
        return value;
    }
    const Encoding encoding = image->linear ? Encoding::linear : Encoding::automatic;
    try {
        Image pixels = image->bytes ? read_image(*image->bytes, image->file, encoding) : read_image(image->file, encoding);
        Image changed{pixels.width, pixels.height, 3, {}};
        const auto channels = static_cast<std::size_t>(pixels.channels);
        for (std::size_t i = 0; i < pixels.pixels.size(); i += channels) {
            changed.pixels.insert(changed.pixels.end(), 3, static_cast<float>(change(static_cast<double>(pixels.pixels[i]))));
        }
        const scene::ImageTexture made = made_picture(changed, image->position);
        image->bytes = made.bytes;
        image->file = made.file;
        image->linear = true;
    } catch (const std::runtime_error& problem) {
        builder.error(image->position, problem.what());
    }
    return value;
}

double number_or(Builder& builder, Plugin& plugin, std::string_view name, double preset) {
    const Element* element = plugin.find(name);
    if (!element) {
        return preset;
    }
    const scene::Value value = value_of(builder, *element);
    if (!value.texture) {
        return value.number;
    }
    builder.context.report.approximated(fmt::format("{}: \"{}\" by a texture", plugin.title(), name), "one number everywhere",
                                        element->position);
    if (const auto* checker = std::get_if<scene::Checker>(&*value.texture)) {
        return 0.5 * (luminance(checker->first) + luminance(checker->second));
    }
    return 0.5;
}

std::string attribute_used(Builder& builder, const Element* bsdf) {
    if (!bsdf) {
        return {};
    }
    const Nesting nesting(builder, bsdf->position);
    if (nesting.too_deep()) {
        return {};
    }
    Plugin plugin = builder.plugin(*bsdf);
    if (plugin.type() == "mesh_attribute") {
        return plugin.text("name", "");
    }
    for (const auto& [name, child] : plugin.children({"bsdf", "texture"})) {
        if (std::string found = attribute_used(builder, child); !found.empty()) {
            return found;
        }
    }
    return {};
}

}  // namespace lancer::mitsuba
