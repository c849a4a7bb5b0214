// What directives leave behind for those after them.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "lancer/import/pbrt/color_space.h"
#include "lancer/import/pbrt/parameters.h"

namespace lancer::pbrt {

// What Attribute sets parameters of.
enum class Target { shape, light, material, medium, texture };
constexpr int target_count = 5;

// A material, light or other thing as written, and what stood around it.
struct Recipe {
    Parameters parameters;
    std::string type;
    ColorSpace space = ColorSpace::srgb;
    std::size_t sequence = 0;  // of the directives in the order in which they are carried out
};

// What a shape is made of; resolved when all of the file is known.
struct MaterialChoice {
    int recipe = -1;   // into the materials in place; -1: a named one
    std::string name;  // empty with recipe -1: the default
    std::size_t sequence = 0;

    auto operator<=>(const MaterialChoice&) const = default;
};

struct GraphicsState {
    glm::dmat4 at_opening{1.0};  // of the shutter: from the space of what comes to the world
    glm::dmat4 at_closing{1.0};
    bool changes_opening = true;
    bool changes_closing = true;
    bool reverse_orientation = false;
    ColorSpace space = ColorSpace::srgb;
    MaterialChoice material;
    int area_light = -1;  // into the recipes of area lights
    std::string inside;   // names of media; empty: none
    std::string outside;
    std::array<std::shared_ptr<const std::vector<Parameter>>, target_count> defaults;

    template <class Change>
    void change(const Change& map) {
        at_opening = changes_opening ? map(at_opening) : at_opening;
        at_closing = changes_closing ? map(at_closing) : at_closing;
    }
};

}  // namespace lancer::pbrt
