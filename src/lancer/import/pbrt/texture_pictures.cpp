#include "lancer/import/pbrt/texture_pictures.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>

#include "lancer/import/made_picture.h"

namespace lancer::pbrt {

namespace {

int wrapped(int x, int size, scene::Wrap wrap) {
    return wrap == scene::Wrap::clamp ? std::clamp(x, 0, size - 1) : ((x % size) + size) % size;
}

scene::Rgb texel(const Image& image, int x, int y, scene::Wrap wrap) {
    const auto column = static_cast<std::size_t>(wrapped(x, image.width, wrap));
    const auto row = static_cast<std::size_t>(wrapped(y, image.height, wrap));
    const auto channels = static_cast<std::size_t>(image.channels);
    const float* p = &image.pixels[(row * static_cast<std::size_t>(image.width) + column) * channels];
    return channels >= 3 ? scene::Rgb(p[0], p[1], p[2]) : scene::Rgb(static_cast<double>(p[0]));
}

// (0, 0) is the lower left corner; between the middles of four texels.
scene::Rgb bilinear(const Image& image, const glm::dvec2& place, scene::Wrap wrap) {
    // Far out, where no place is known to a texel any more, any will do.
    const double x = std::clamp(place.x * image.width - 0.5, -1e9, 1e9), y = std::clamp((1.0 - place.y) * image.height - 0.5, -1e9, 1e9);
    const int left = static_cast<int>(std::floor(x)), top = static_cast<int>(std::floor(y));
    const double fx = x - left, fy = y - top;
    return (texel(image, left, top, wrap) * (1.0 - fx) + texel(image, left + 1, top, wrap) * fx) * (1.0 - fy) +
           (texel(image, left, top + 1, wrap) * (1.0 - fx) + texel(image, left + 1, top + 1, wrap) * fx) * fy;
}

bool same_mapping(const scene::ImageTexture& a, const scene::ImageTexture& b) {
    return a.scale == b.scale && a.offset == b.offset && a.wrap == b.wrap;
}

// All of it as a picture of its own. Of pictures that lie on the surface in the same way, in their own coordinates; else of uv from 0 to 1.
scene::Texture drawn(const TextureNode& node, const TextureNode::Change& changed, const SourcePosition& position) {
    constexpr int largest = 2048;
    constexpr double most_looks = 3e7;
    glm::ivec2 size = glm::clamp(node.size(), glm::ivec2(1), glm::ivec2(largest));
    while (static_cast<double>(size.x) * size.y * node.cost > most_looks && std::max(size.x, size.y) > 1) {
        size = glm::max(size / 2, glm::ivec2(1));
    }
    scene::ImageTexture texture = node.image.value_or(scene::ImageTexture{});
    if (!(texture.scale.x != 0.0 && texture.scale.y != 0.0)) {
        texture.scale = glm::dvec2(1.0);
    }
    Image picture{size.x, size.y, 3, {}};
    picture.pixels.reserve(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * 3);
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const glm::dvec2 st((x + 0.5) / size.x, 1.0 - (y + 0.5) / size.y);
            const scene::Rgb color = changed(node.at((st - texture.offset) / texture.scale));
            for (int i = 0; i < 3; ++i) {
                picture.pixels.push_back(static_cast<float>(color[i]));
            }
        }
    }
    const scene::ImageTexture made = made_picture(picture, position);
    texture.bytes = made.bytes;
    texture.file = made.file;
    texture.linear = true;
    texture.position = position;
    return texture;
}

}  // namespace

TextureNode constant_node(const scene::Rgb& color) {
    TextureNode node;
    node.at = [=](const glm::dvec2&) { return color; };
    node.size = [] { return glm::ivec2(1); };
    return node;
}

TextureNode image_node(const scene::ImageTexture& mapping, std::function<std::shared_ptr<const Image>()> load, double scale, bool invert) {
    TextureNode node;
    node.constant = false;
    node.image = mapping;
    node.plain_image = scale == 1.0 && !invert;
    node.size = [=] {
        const auto pixels = load();
        return glm::ivec2(pixels->width, pixels->height);
    };
    node.at = [=](const glm::dvec2& uv) {
        const scene::Rgb color = bilinear(*load(), mapping.scale * uv + mapping.offset, mapping.wrap) * scale;
        return invert ? glm::max(scene::Rgb(1.0) - color, 0.0) : color;
    };
    return node;
}

TextureNode combined_node(const TextureNode& one, const TextureNode& other,
                          std::function<scene::Rgb(const scene::Rgb&, const scene::Rgb&)> mix) {
    if (one.constant && other.constant) {
        TextureNode node = constant_node(mix(one.at({}), other.at({})));
        node.exact = one.exact && other.exact;
        return node;
    }
    TextureNode node;
    node.cost = one.cost + other.cost;
    node.at = [first = one.at, second = other.at, mix = std::move(mix)](const glm::dvec2& uv) { return mix(first(uv), second(uv)); };
    node.constant = false;
    node.exact = one.exact && other.exact;
    node.size = [a = one.size, b = other.size] { return glm::max(a(), b()); };
    node.image = one.image ? one.image : other.image;
    if (one.image && other.image && !same_mapping(*one.image, *other.image)) {
        node.image.reset();
        node.exact = false;
    }
    if (node.image) {
        node.image->file.clear();
        // What is no picture itself was drawn for uv from 0 to 1.
        const bool drawn = (!one.constant && !one.image) || (!other.constant && !other.image);
        node.exact = node.exact && !drawn;
    }
    return node;
}

TextureNode procedural_node(std::function<scene::Rgb(const glm::dvec2&)> at, int side, bool exact) {
    TextureNode node;
    node.at = std::move(at);
    node.constant = false;
    node.exact = exact;
    node.size = [=] { return glm::ivec2(side); };
    return node;
}

scene::Rgb mean_of(const TextureNode& node) {
    constexpr int probes = 16;
    scene::Rgb sum(0.0);
    for (int i = 0; i < probes * probes; ++i) {
        sum += node.at({(i % probes + 0.5) / probes, (i / probes + 0.5) / probes});
    }
    return sum / static_cast<double>(probes * probes);
}

scene::Texture texture_of(const TextureNode& node, const TextureNode::Change& change, const SourcePosition& position, bool& exact) {
    exact = true;
    const auto changed = [&](const scene::Rgb& color) { return change ? change(color) : color; };
    if (node.constant) {
        return changed(node.at(glm::dvec2(0.0)));
    }
    if (node.checker) {
        return scene::Checker{changed(node.checker->first), changed(node.checker->second), node.checker->size, node.checker->solid};
    }
    if (node.plain_image && node.image && !change) {
        scene::ImageTexture texture = *node.image;
        texture.position = position;
        return texture;
    }
    exact = node.exact && node.image.has_value();
    return drawn(node, changed, position);
}

}  // namespace lancer::pbrt
