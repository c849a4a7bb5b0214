#include "lancer/import/mitsuba/values.h"

#include <charconv>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "lancer/import/mesh/mesh_messages.h"

namespace lancer::mitsuba {

namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool is_between(char c) { return is_space(c) || c == ',' || c == ';'; }

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_space(text.front())) {
        text.remove_prefix(1);
    }
    while (!text.empty() && is_space(text.back())) {
        text.remove_suffix(1);
    }
    return text;
}

// The words between commas, semicolons and spaces.
template <class Use>
bool for_each_word(std::string_view text, Use use) {
    std::size_t i = 0;
    while (true) {
        while (i < text.size() && is_between(text[i])) {
            ++i;
        }
        if (i == text.size()) {
            return true;
        }
        const std::size_t begin = i;
        while (i < text.size() && !is_between(text[i])) {
            ++i;
        }
        if (!use(text.substr(begin, i - begin))) {
            return false;
        }
    }
}

double number_or(const Element& element, std::string_view name, double preset, Diagnostics& diagnostics) {
    const std::string* text = element.find(name);
    if (!text) {
        return preset;
    }
    const auto number = parse_number(*text);
    if (!number) {
        diagnostics.error(element.position, fmt::format("expected a number for \"{}\", found {}", name, quoted(*text)));
    }
    return number.value_or(preset);
}

glm::dvec3 three_of(const Element& element, std::string_view name, const glm::dvec3& preset, Diagnostics& diagnostics) {
    const std::string* text = element.find(name);
    const auto numbers = text ? parse_numbers(*text) : std::nullopt;
    if (!numbers || numbers->size() != 3) {
        if (text) {
            diagnostics.error(element.position, fmt::format("expected three numbers for \"{}\", found {}", name, quoted(*text)));
        }
        return preset;
    }
    return {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
}

// From a camera at the origin that looks along +z, with +y up and +x to its left.
glm::dmat4 look_at(const Element& element, Diagnostics& diagnostics) {
    const glm::dvec3 origin = three_of(element, "origin", glm::dvec3(0.0), diagnostics);
    const glm::dvec3 target = three_of(element, "target", origin + glm::dvec3(0.0, 0.0, 1.0), diagnostics);
    const glm::dvec3 view = target - origin;
    if (!(glm::length(view) > 0.0)) {
        diagnostics.error(element.position, "\"origin\" and \"target\" are the same point");
        return glm::dmat4(1.0);
    }
    const glm::dvec3 direction = glm::normalize(view);
    glm::dvec3 up = three_of(element, "up", glm::dvec3(0.0), diagnostics);
    if (!(glm::length(glm::cross(up, direction)) > 0.0)) {
        if (element.find("up")) {
            diagnostics.warning(element.position, "\"up\" points along the view: another direction is taken");
        }
        up = std::abs(direction.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
    }
    const glm::dvec3 left = glm::normalize(glm::cross(up, direction));
    const glm::dvec3 above = glm::cross(direction, left);
    return {glm::dvec4(left, 0.0), glm::dvec4(above, 0.0), glm::dvec4(direction, 0.0), glm::dvec4(origin, 1.0)};
}

glm::dmat4 matrix_of(const Element& element, Diagnostics& diagnostics) {
    const auto numbers = parse_numbers(element.attribute("value"));
    glm::dmat4 matrix(1.0);
    if (!numbers || (numbers->size() != 16 && numbers->size() != 9)) {
        diagnostics.error(element.position, "<matrix> needs a \"value\" of 16 numbers, row by row, or of 9");
        return matrix;
    }
    const int size = numbers->size() == 16 ? 4 : 3;
    for (int row = 0; row < size; ++row) {
        for (int column = 0; column < size; ++column) {
            matrix[column][row] = (*numbers)[static_cast<std::size_t>(row * size + column)];
        }
    }
    return matrix;
}

glm::dmat4 step_of(const Element& step, Diagnostics& diagnostics) {
    if (step.tag == "translate") {
        return glm::translate(glm::dmat4(1.0), vector_of(step, 0.0, diagnostics));
    }
    if (step.tag == "scale") {
        return glm::scale(glm::dmat4(1.0), vector_of(step, 1.0, diagnostics));
    }
    if (step.tag == "rotate") {
        const glm::dvec3 axis = vector_of(step, 0.0, diagnostics);
        if (!(glm::length(axis) > 0.0)) {
            diagnostics.error(step.position, "<rotate> needs an axis: x, y and z, not all 0");
            return glm::dmat4(1.0);
        }
        return glm::rotate(glm::dmat4(1.0), glm::radians(number_or(step, "angle", 0.0, diagnostics)), axis);
    }
    if (step.tag == "lookat") {
        return look_at(step, diagnostics);
    }
    if (step.tag == "matrix") {
        return matrix_of(step, diagnostics);
    }
    diagnostics.error(step.position,
                      fmt::format("a transform can't hold <{}>: expected translate, scale, rotate, lookat or matrix", step.tag));
    return glm::dmat4(1.0);
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
    text = trimmed(text);
    if (!text.empty() && text.front() == '+') {
        text.remove_prefix(1);
    }
    double number = 0.0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (problem == std::errc::result_out_of_range && end == text.data() + text.size()) {
        return std::nullopt;
    }
    return problem == std::errc() && end == text.data() + text.size() && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

std::optional<int> parse_integer(std::string_view text) {
    const auto number = parse_number(text);
    return number && std::abs(*number) <= 2147483647.0 && *number == std::floor(*number) ? std::optional(static_cast<int>(*number))
                                                                                         : std::nullopt;
}

std::optional<std::vector<double>> parse_numbers(std::string_view text) {
    std::vector<double> numbers;
    const bool good = for_each_word(text, [&](std::string_view word) {
        const auto number = parse_number(word);
        numbers.push_back(number.value_or(0.0));
        return number.has_value();
    });
    return good ? std::optional(std::move(numbers)) : std::nullopt;
}

std::optional<glm::dvec3> parse_three(std::string_view text) {
    const auto numbers = parse_numbers(text);
    if (!numbers || (numbers->size() != 1 && numbers->size() != 3)) {
        return std::nullopt;
    }
    return numbers->size() == 1 ? glm::dvec3((*numbers)[0]) : glm::dvec3((*numbers)[0], (*numbers)[1], (*numbers)[2]);
}

std::optional<WavelengthValues> parse_wavelengths(std::string_view text) {
    WavelengthValues curve;
    const bool good = for_each_word(text, [&](std::string_view word) {
        const std::size_t colon = word.find(':');
        const auto nanometres = parse_number(word.substr(0, colon));
        const auto value = colon == std::string_view::npos ? std::nullopt : parse_number(word.substr(colon + 1));
        if (!nanometres || !value || (!curve.nanometres.empty() && *nanometres <= curve.nanometres.back())) {
            return false;
        }
        curve.nanometres.push_back(*nanometres);
        curve.values.push_back(*value);
        return true;
    });
    return good && !curve.values.empty() ? std::optional(std::move(curve)) : std::nullopt;
}

glm::dvec3 vector_of(const Element& element, double preset, Diagnostics& diagnostics) {
    if (const std::string* text = element.find("value")) {
        if (const auto three = parse_three(*text)) {
            return *three;
        }
        diagnostics.error(element.position, fmt::format("expected one or three numbers, found {}", quoted(*text)));
    }
    return {number_or(element, "x", preset, diagnostics), number_or(element, "y", preset, diagnostics),
            number_or(element, "z", preset, diagnostics)};
}

glm::dmat4 transform_of(const Element& element, Diagnostics& diagnostics) {
    glm::dmat4 all(1.0);
    for (const Element& step : element.children) {
        all = step_of(step, diagnostics) * all;
    }
    for (int i = 0; i < 16; ++i) {
        if (!std::isfinite(all[i / 4][i % 4])) {
            diagnostics.error(element.position, "the transform has numbers that are not finite");
            return glm::dmat4(1.0);
        }
    }
    return all;
}

}  // namespace lancer::mitsuba
