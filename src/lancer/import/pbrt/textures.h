// Textures by name, and parameters that are a value or name one.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lancer/import/pbrt/graphics_state.h"
#include "lancer/import/pbrt/spectra.h"
#include "lancer/import/pbrt/texture_pictures.h"
#include "lancer/scene/textures.h"

namespace lancer::pbrt {

// A texture as pbrt describes it; looked at when a material asks for it.
struct TextureRecipe {
    Recipe recipe;
    bool is_color = true;  // else a number
};

class Textures {
public:
    explicit Textures(ImportContext& context) : context_(context) {}

    void define(const std::string& name, TextureRecipe texture) { by_name_[name].push_back(std::move(texture)); }

    // A share of light that a parameter gives, in place or as a texture; nothing when it is not there, or after an error.
    std::optional<scene::Texture> color(const Recipe& owner, std::string_view name) const;
    scene::Texture color(const Recipe& owner, std::string_view name, const Color& otherwise) const;

    // A number; where it is a texture, after `change`.
    using Change = std::function<double(double)>;
    scene::Value value(const Recipe& owner, std::string_view name, double otherwise, const Change& change = {}) const;

    // A number, with the mean of a texture for it, which is reported.
    double number(const Recipe& owner, std::string_view name, double otherwise) const;

private:
    using Path = std::vector<const TextureRecipe*>;  // of those that are being looked at: none may need itself

    const TextureRecipe* find(const Recipe& owner, const Parameter& parameter) const;
    std::optional<TextureNode> node(const Recipe& owner, std::string_view name, Path& path) const;
    TextureNode node(const Recipe& owner, std::string_view name, double otherwise, Path& path) const;
    std::optional<TextureNode> node(const TextureRecipe& texture, Path& path) const;
    std::optional<scene::ImageTexture> mapping(const Recipe& recipe) const;
    std::optional<TextureNode> image(const Recipe& recipe) const;
    TextureNode checkerboard(const Recipe& recipe, Path& path) const;
    TextureNode bilerp(const Recipe& recipe, Path& path) const;
    TextureNode dots(const Recipe& recipe, Path& path) const;
    scene::Texture finished(const TextureNode& node, const TextureNode::Change& change, const Recipe& owner, std::string_view name) const;

    ImportContext& context_;
    std::map<std::string, std::vector<TextureRecipe>, std::less<>> by_name_;  // in the order of their definitions
    // What was looked at already.
    mutable std::map<std::string, std::shared_ptr<const Image>> images_;
    mutable std::map<const TextureRecipe*, std::optional<TextureNode>> nodes_;
};

}  // namespace lancer::pbrt
