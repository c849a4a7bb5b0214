// Textures that are put together from others, as one picture.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include <glm/vec2.hpp>

#include "lancer/image/image.h"
#include "lancer/scene/color.h"
#include "lancer/scene/textures.h"

namespace lancer::pbrt {

// A texture that can be looked at: the colour at a place of uv, and what it is made of.
struct TextureNode {
    using Change = std::function<scene::Rgb(const scene::Rgb&)>;

    std::function<scene::Rgb(const glm::dvec2& uv)> at;
    bool constant = true;
    bool exact = true;  // false: what pbrt shows differs
    // Of the pictures in it: their mapping, and the finest of them. Without one, a square of uv from 0 to 1 is all.
    std::optional<scene::ImageTexture> image;  // the mapping, and the file where it is nothing but that
    bool plain_image = false;                  // nothing but the file
    std::function<glm::ivec2()> size;          // pixels that show all of it
    std::optional<scene::Checker> checker;     // it is nothing but that
    int cost = 1;                              // of a look: how many textures it goes through
};

TextureNode constant_node(const scene::Rgb& color);

// The file's picture times `scale`, then one minus it where `invert`. `load` is called when somebody looks.
TextureNode image_node(const scene::ImageTexture& mapping, std::function<std::shared_ptr<const Image>()> load, double scale, bool invert);

// A node from two: what `mix` makes of their colours.
TextureNode combined_node(const TextureNode& one, const TextureNode& other,
                          std::function<scene::Rgb(const scene::Rgb&, const scene::Rgb&)> mix);

// Colours by place: `side` pixels each way show all of it, from 0 to 1.
TextureNode procedural_node(std::function<scene::Rgb(const glm::dvec2&)> at, int side, bool exact);

// As a texture of the scene, each colour after `change`. What is put together from pictures is its mean, and `exact` becomes false.
scene::Texture texture_of(const TextureNode& node, const TextureNode::Change& change, const SourcePosition& position, bool& exact);

// The mean over uv from 0 to 1.
scene::Rgb mean_of(const TextureNode& node);

}  // namespace lancer::pbrt
