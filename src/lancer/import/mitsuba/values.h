// Numbers, vectors, colours and matrices as Mitsuba writes them in attributes.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "lancer/base/diagnostic.h"
#include "lancer/import/mitsuba/element.h"

namespace lancer::mitsuba {

// The whole text as a finite number, with spaces around it; nothing else.
std::optional<double> parse_number(std::string_view text);
std::optional<int> parse_integer(std::string_view text);

// Finite numbers between commas, semicolons or spaces.
std::optional<std::vector<double>> parse_numbers(std::string_view text);

// One number for all three, or three.
std::optional<glm::dvec3> parse_three(std::string_view text);

// "400:0.1, 700:0.9": wavelengths in nanometres, which must rise, and values.
struct WavelengthValues {
    std::vector<double> nanometres;
    std::vector<double> values;
};
std::optional<WavelengthValues> parse_wavelengths(std::string_view text);

// x, y and z of an element, written as such or all together as "value"; what is left out is `preset`. What is no number is an error.
glm::dvec3 vector_of(const Element& element, double preset, Diagnostics& diagnostics);

// Of a <transform>: what is in it, applied one after the other.
glm::dmat4 transform_of(const Element& element, Diagnostics& diagnostics);

}  // namespace lancer::mitsuba
