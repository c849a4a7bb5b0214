#include "lancer/import/toml/transforms.h"

#include <fmt/format.h>

#include <cmath>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

namespace lancer::notation {

namespace {

constexpr double smallest_scale = 1e-9;

glm::dvec3 read_scale(TableReader& reader) {
    const Key& key = reader.described("scale", Kind::scale);
    const toml::node* node = reader.value("scale", Kind::scale);
    glm::dvec3 scale = std::get<glm::dvec3>(key.preset);
    if (!node) {
        return scale;
    }
    bool good = false;
    if (node->is_array()) {
        good = read_numbers(reader.messages(), *node, key, 3, "a number or three numbers [x, y, z]", &scale.x);
    } else if (node->is_number()) {
        good = read_number(reader.messages(), *node, key, scale.x);
        scale = glm::dvec3(scale.x);
    } else {
        reader.error("scale", fmt::format("\"scale\" must be a number or three numbers [x, y, z], not {}", what_it_is(*node)));
        return glm::dvec3(1.0);
    }
    if (!good) {
        reader.spoil();
        return glm::dvec3(1.0);
    }
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(scale[axis]) < smallest_scale) {
            reader.error("scale", fmt::format("\"scale\" must not be {}: nothing would be left", scale[axis]));
            return glm::dvec3(1.0);
        }
    }
    return scale;
}

// In multiples of 90 degrees the sine and cosine are exact, so that a quarter turn keeps boxes on their axes.
glm::dmat4 rotation(double degrees, const glm::dvec3& axis) {
    const double turns = std::remainder(degrees, 360.0);
    double sine = std::sin(glm::radians(turns));
    double cosine = std::cos(glm::radians(turns));
    if (std::remainder(turns, 90.0) == 0.0) {
        sine = std::round(sine);
        cosine = std::round(cosine);
    }
    const glm::dvec3 a = axis;  // of length 1 [Rodrigues 1840]
    const glm::dmat3 cross(0.0, a.z, -a.y, -a.z, 0.0, a.x, a.y, -a.x, 0.0);
    return glm::dmat4(cosine * glm::dmat3(1.0) + sine * cross + (1.0 - cosine) * glm::outerProduct(a, a));
}

glm::dmat4 read_rotation(TableReader& reader) {
    const Key& key = reader.described("rotate", Kind::rotation);
    const toml::node* node = reader.value("rotate", Kind::rotation);
    if (!node) {
        return glm::dmat4(1.0);
    }
    if (const toml::table* table = node->as_table()) {
        TableReader about_axis(reader.messages(), *table, axis_rotation());
        const double angle = about_axis.number("angle");
        return rotation(angle, about_axis.direction("axis"));
    }
    glm::dvec3 degrees(0.0);
    if (!read_numbers(reader.messages(), *node, key, 3, "three angles [x, y, z] or { axis = [x, y, z], angle = degrees }", &degrees.x)) {
        reader.spoil();
        return glm::dmat4(1.0);
    }
    return rotation(degrees.z, {0.0, 0.0, 1.0}) * rotation(degrees.y, {0.0, 1.0, 0.0}) * rotation(degrees.x, {1.0, 0.0, 0.0});
}

}  // namespace

namespace {

// What is flat has no inverse.
constexpr double flattest = 1e-9;  // volume of the image of the unit cube, over that of a box with the same edges

glm::dmat4 read_matrix(TableReader& reader) {
    const Key& key = reader.described("matrix", Kind::matrix);
    const toml::node& node = *reader.value("matrix", Kind::matrix);
    for (const char* other : {"scale", "rotate", "translate"}) {
        if (reader.has(other)) {
            reader.error(other, fmt::format("something is placed by either \"matrix\" or \"{}\"", other));
        }
    }
    double rows[12] = {};
    if (!read_numbers(reader.messages(), node, key, 12, "the upper three rows of a matrix, one after the other", rows)) {
        reader.spoil();
        return glm::dmat4(1.0);
    }
    glm::dmat4 map(1.0);
    for (int i = 0; i < 12; ++i) {
        map[i % 4][i / 4] = rows[i];
    }
    double edges = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double length = glm::length(glm::dvec3(map[axis]));
        edges *= length;
        if (length < smallest_scale) {
            reader.error("matrix", fmt::format("column {} of \"matrix\" is nearly 0: nothing would be left", axis + 1));
            return glm::dmat4(1.0);
        }
    }
    if (!(std::abs(glm::determinant(glm::dmat3(map))) > flattest * edges)) {
        reader.error("matrix", "this \"matrix\" makes everything flat");
        return glm::dmat4(1.0);
    }
    return map;
}

}  // namespace

glm::dmat4 read_transform(TableReader& reader) {
    if (reader.has("matrix")) {
        return read_matrix(reader);
    }
    const glm::dvec3 scale = read_scale(reader);
    const glm::dmat4 rotate = read_rotation(reader);
    const glm::dvec3 translate = reader.vector3("translate");
    return glm::translate(glm::dmat4(1.0), translate) * rotate * glm::scale(glm::dmat4(1.0), scale);
}

}  // namespace lancer::notation
