// How bright linear RGB is to the eye.
#pragma once

#include <glm/vec3.hpp>

namespace lancer {

// Relative luminance of linear sRGB [IEC 61966-2-1]; kernel/color.h has it in single precision.
inline double luminance(const glm::dvec3& rgb) { return rgb.x * 0.2126729 + rgb.y * 0.7151522 + rgb.z * 0.0721750; }

}  // namespace lancer
