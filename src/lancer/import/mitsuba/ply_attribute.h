// Numbers that a PLY file holds for its vertices or faces besides their shape.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <glm/vec4.hpp>

namespace lancer::mitsuba {

// Of "vertex_NAME" or "face_NAME": up to three properties NAME_0, NAME_1, NAME_2 (or _r, _g, _b, or for "color" red, green, blue), one entry for each
// vertex or face; a single number stands for all three. Whole numbers are shares of 255. Empty when the file has no such thing, is not binary or ends
// early: whether it is sound has been said by who reads its shape.
std::vector<glm::vec4> read_ply_attribute(std::string_view bytes, const std::string& attribute);

}  // namespace lancer::mitsuba
