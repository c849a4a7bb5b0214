// Textures by name, and parameters that are a value or name one.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lancer/import/pbrt/graphics_state.h"
#include "lancer/import/pbrt/spectra.h"
#include "lancer/scene/scene.h"

namespace lancer::pbrt {

// A texture as pbrt describes it; evaluated when a material asks for it.
struct TextureRecipe {
    Recipe recipe;
    bool is_color = true;  // else a number
};

class Textures {
public:
    explicit Textures(ImportContext& context) : context_(context) {}

    void define(const std::string& name, TextureRecipe texture) { by_name_[name].push_back(std::move(texture)); }

    // A share of light that a parameter gives; nothing when it is not there, or after an error.
    std::optional<scene::Texture> color(const Recipe& owner, std::string_view name) const;
    scene::Texture color(const Recipe& owner, std::string_view name, const scene::Rgb& otherwise) const;

    // A number. Textures that are not the same everywhere are reported, and their mean is used.
    std::optional<double> number(const Recipe& owner, std::string_view name) const;
    double number(const Recipe& owner, std::string_view name, double otherwise) const;

private:
    using Path = std::vector<const TextureRecipe*>;  // of those that are being evaluated: none may need itself

    const TextureRecipe* find(const Recipe& owner, const Parameter& parameter) const;
    std::optional<scene::Texture> color_of(const TextureRecipe& texture, Path& path) const;
    std::optional<scene::Texture> color_of(const Recipe& owner, std::string_view name, Path& path) const;
    std::optional<double> number_of(const TextureRecipe& texture, Path& path) const;
    std::optional<double> number_of(const Recipe& owner, std::string_view name, Path& path) const;
    std::optional<scene::Texture> image(const TextureRecipe& texture) const;

    ImportContext& context_;
    std::map<std::string, std::vector<TextureRecipe>, std::less<>> by_name_;  // in the order of their definitions
};

}  // namespace lancer::pbrt
