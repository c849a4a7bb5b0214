// The TOML notation, described once: which tables there are, which keys each has, and what each key may hold. The reader takes types, ranges,
// defaults and required keys from here, and so does the JSON Schema; there is no second list.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace lancer::notation {

enum class Kind {
    number,      // 1.5
    integer,     // 3
    flag,        // true
    text,        // "red"
    choice,      // one of Key::words
    choices,     // a list of some of Key::words
    file,        // a path, seen from the scene file's folder
    vector2,     // [0, 1]
    vector3,     // [0, 1, 2]
    direction,   // [0, 1, 2], not all zero
    size,        // [1280, 720]: whole numbers
    rgb,         // "#rrggbb", a name, [r, g, b] linear
    color,       // the same, or a spectrum
    texture,     // a color, a checker, an image or the colours of a mesh
    value,       // a number, or { texture, channel, scale, offset }
    curve,       // 1.5, "file.csv", { wavelengths = [...], values = [...] }
    index,       // a curve, or [r, g, b]
    refraction,  // 1.5, "N-BK7", { index = 1.5, abbe_number = 60 }, { b = [...], c = [...] }
    material,    // a name, or a material written in place
    grid,        // { file = "smoke.vdb" }, { cells = [...], values = [...], min = [...], max = [...] }
    rotation,    // degrees about x, y, z; or { axis = [...], angle = ... }
    matrix,      // twelve numbers: the upper three rows of a 4 x 4 matrix, one row after the other
    scale,       // 2 or [1, 2, 3]
    vectors3,    // a list of [x, y, z]
    vectors2,    // a list of [u, v]
    numbers,     // a list
    texts,       // { name = "text", ... }
    triangles    // a list of [a, b, c], whole numbers from 0
};

// What each number of a value must keep to.
struct Range {
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
    bool above_least = false;  // `least` itself is excluded
    bool below_most = false;   // `most` itself is excluded

    bool holds(double value) const;
};

// In words: "more than 0 and less than 180", "at least 1", "from 0 to 1"; nothing for any number.
std::string to_words(const Range& range);

// What stands for a key that is not written; a color's is linear RGB.
using Default = std::variant<std::monostate, bool, double, std::string_view, glm::dvec2, glm::dvec3>;

struct Key {
    std::string_view name;
    Kind kind;
    Default preset;
    Range range;
    std::string_view unit;
    std::string_view help;
    bool required = false;
    std::vector<std::string_view> words = {};  // of a choice, or of choices
};

struct Table {
    std::string_view name;  // as a header or in a path: "sphere"
    std::string_view what;  // in a sentence: "a sphere"
    std::string_view help;
    std::vector<Key> keys;

    const Key* find(std::string_view key) const;
};

// ---- The tables -------------------------------------------------------------------------------------------------------------------

const Table& camera();
const Table& point_light();
const Table& spot_light();
const Table& directional_light();
const Table& projector_light();
const Table& goniometric_light();
const Table& ies_light();
const Table& whitted_material();
const Table& diffuse_material();
const Table& conductor_material();
const Table& dielectric_material();
const Table& plastic_material();
const Table& principled_material();
const Table& burley_material();
const Table& mix_material();
const Table& null_material();
const Table& medium();
const Table& grid();
const Table& checker();
const Table& image();
const Table& spectrum();
const Table& curve();
const Table& vertex_color();
const Table& face_color();
const Table& texture_value();
const Table& abbe_glass();
const Table& sellmeier_glass();
const Table& axis_rotation();
const Table& sphere();
const Table& box();
const Table& plane();
const Table& disk();
const Table& cylinder();
const Table& cone();
const Table& mesh();
const Table& place();
const Table& group();
const Table& include();
const Table& background();
const Table& clear_sky();
const Table& ambient();
const Table& render();

// All shapes, in the order of scene::Shape.
std::span<const Table* const> shapes();
// All kinds of lights, in the order of scene::Light::model; the key `type` tells them apart.
std::span<const Table* const> lights();

// All kinds of materials, in the order of scene::Material::model; the key `type` tells them apart, the first is meant where it is not written.
std::span<const Table* const> materials();

// How a table stands in the file.
enum class Form {
    single,  // [render]
    list,    // [[sphere]]
    named,   // [material.NAME]
    camera,  // [camera] and [camera.NAME]
    color    // [background] or background = color
};

struct Section {
    Form form;
    std::string_view name;
    std::vector<const Table*> tables;  // several where `type` tells them apart
};

// What may stand at the top of a file, and inside a [[group]] beside its own keys.
std::span<const Section> file_sections();
std::span<const Section> group_sections();

}  // namespace lancer::notation
