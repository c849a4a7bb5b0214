// The colour spaces that numbers of red, green and blue may be meant in.
#pragma once

#include <optional>
#include <string_view>

#include <glm/vec3.hpp>

namespace lancer::pbrt {

enum class ColorSpace { srgb, dci_p3, rec2020, aces };

std::optional<ColorSpace> find_color_space(std::string_view name);

// Linear RGB of that space as linear sRGB; components may come out negative. A share (1, 1, 1) is white in each; a light (1, 1, 1) has the colour
// of the space's own white.
glm::dvec3 share_to_srgb(ColorSpace space, const glm::dvec3& rgb);
glm::dvec3 light_to_srgb(ColorSpace space, const glm::dvec3& rgb);

}  // namespace lancer::pbrt
