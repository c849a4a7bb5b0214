#include "lancer/import/pbrt/color_space.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "lancer/spectrum/observer.h"

namespace lancer::pbrt {

namespace {

glm::dvec3 xyz_of(double x, double y) { return {x / y, 1.0, (1.0 - x - y) / y}; }

// From chromaticities of red, green, blue and white: (1, 1, 1) is the white, of luminance 1 [SMPTE RP 177].
glm::dmat3 to_xyz(const glm::dvec3& red, const glm::dvec3& green, const glm::dvec3& blue, const glm::dvec3& white) {
    const glm::dmat3 primaries(red, green, blue);
    const glm::dvec3 weights = glm::inverse(primaries) * white;
    return glm::dmat3(red * weights.x, green * weights.y, blue * weights.z);
}

glm::dmat3 to_xyz(ColorSpace space) {
    const glm::dvec3 d65 = rgb_to_xyz(glm::dvec3(1.0));
    switch (space) {
        case ColorSpace::srgb:
            return to_xyz(xyz_of(0.64, 0.33), xyz_of(0.3, 0.6), xyz_of(0.15, 0.06), d65);
        case ColorSpace::dci_p3:  // with the white of screens
            return to_xyz(xyz_of(0.68, 0.32), xyz_of(0.265, 0.69), xyz_of(0.15, 0.06), d65);
        case ColorSpace::rec2020:
            return to_xyz(xyz_of(0.708, 0.292), xyz_of(0.17, 0.797), xyz_of(0.131, 0.046), d65);
        case ColorSpace::aces:  // SMPTE ST 2065-1; its blue lies outside of all colours
            return to_xyz(xyz_of(0.7347, 0.2653), xyz_of(0.0, 1.0), glm::dvec3(0.0001 / -0.077, 1.0, 1.0769 / -0.077),
                          xyz_of(0.32168, 0.33767));
    }
    return glm::dmat3(1.0);
}

}  // namespace

std::optional<ColorSpace> find_color_space(std::string_view name) {
    if (name == "srgb") {
        return ColorSpace::srgb;
    }
    if (name == "dci-p3") {
        return ColorSpace::dci_p3;
    }
    if (name == "rec2020") {
        return ColorSpace::rec2020;
    }
    return name == "aces2065-1" ? std::optional(ColorSpace::aces) : std::nullopt;
}

glm::dvec3 light_to_srgb(ColorSpace space, const glm::dvec3& rgb) {
    return space == ColorSpace::srgb ? rgb : xyz_to_rgb(to_xyz(space) * rgb);
}

// The white of another space is brought to ours channel by channel.
glm::dvec3 share_to_srgb(ColorSpace space, const glm::dvec3& rgb) {
    return space == ColorSpace::srgb ? rgb : light_to_srgb(space, rgb) / light_to_srgb(space, glm::dvec3(1.0));
}

}  // namespace lancer::pbrt
