// Colours and numbers that vary over a surface, as the author of a scene wrote them.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lancer/base/diagnostic.h"
#include "lancer/scene/color.h"

namespace lancer::scene {

// Two colours alternating in cells of `size`: metres in object space when `solid`, units of uv otherwise.
struct Checker {
    Rgb first{1.0};
    Rgb second{0.0};
    double size = 1.0;
    bool solid = true;
};

enum class Wrap { repeat, clamp, mirror };
enum class Filter { nearest, bilinear, mipmaps };

// A picture laid over the surface's uv coordinates; (0, 0) is its lower left corner. It is looked up at rotation * (scale * uv) + offset.
struct ImageTexture {
    std::string
        file;  // resolved against the scene file's folder; where there are `bytes`, what to call them: another name for each picture
    std::shared_ptr<const std::string> bytes = nullptr;  // of a file that lies within another one
    Wrap wrap = Wrap::repeat;
    std::optional<Wrap> wrap_v = std::nullopt;  // where it differs from `wrap`
    Filter filter = Filter::mipmaps;
    bool linear = false;  // false: colours are decoded from sRGB where they are integers
    glm::dvec2 scale{1.0};
    double rotation = 0.0;  // degrees, anticlockwise
    glm::dvec2 offset{0.0};
    int uv_set = 0;                  // 0 or 1, of a mesh that has two
    Rgb tint{1.0};                   // times this; alpha stays
    bool times_mesh_colors = false;  // and times the colours and alphas of the mesh's vertices
    SourcePosition position;
};

// Colours that a mesh brings along, for each of its vertices or triangles; white where it has none.
struct MeshColors {
    bool of_faces = false;
    Rgb tint{1.0};  // times this
};

using Texture = std::variant<Color, Checker, ImageTexture, MeshColors>;

enum class Channel { red, green, blue, alpha };

// A number, the same everywhere; or where there is a texture, offset + scale * one of its channels.
struct Value {
    Value(double everywhere = 0.0) : number(everywhere) {}

    double number;
    std::optional<Texture> texture = std::nullopt;
    Channel channel = Channel::red;
    double scale = 1.0;
    double offset = 0.0;

    // What it is at most, of textures from 0 to 1.
    double most() const { return texture ? offset + (scale > 0.0 ? scale : 0.0) : number; }
};

}  // namespace lancer::scene
