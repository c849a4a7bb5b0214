// Letters made of strokes, for labels in painted drawings: no font file is needed.
#pragma once

#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

namespace lancer::app {

// Lines through points: x to the right from the start of the text, y upwards from the base line; capital letters are 1 high. A letter that is
// not known is drawn as a box.
std::vector<std::vector<glm::dvec2>> text_strokes(std::string_view text);

double text_width(std::string_view text);

}  // namespace lancer::app
