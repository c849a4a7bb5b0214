// What fills space, as the author of a scene wrote it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "lancer/base/diagnostic.h"
#include "lancer/scene/color.h"

namespace lancer::scene {

// Numbers in a box: in cells of equal size, x running fastest, then y, then z. One channel, or three: linear RGB.
struct VoxelData {
    glm::ivec3 size{1};
    int channels = 1;
    std::vector<float> values;  // size.x * size.y * size.z * channels
};

// A quantity in space: what the cells hold in their middles, and straight between them. Outside the box it is 0.
struct Grid {
    std::shared_ptr<const VoxelData> data;
    glm::dmat4 to_world{1.0};  // from the unit cube, which the cells fill
    bool fades = false;        // towards 0 beyond the middles of the outermost cells; else it stays as it is there
};

// By how much it absorbs and scatters, each in 1/m.
struct AbsorbingScattering {
    Color absorption;
    Color scattering;
};

// The same by their sum in 1/m, and the share of it that is scattering.
struct ExtinctionAlbedo {
    Color extinction;
    Color albedo;
};

// Into which directions a medium scatters.
enum class Phase { henyey_greenstein, rayleigh };

// What fills space, evenly or as a grid has it: fog, smoke, milk, fire.
struct Medium {
    std::string name;
    std::variant<AbsorbingScattering, ExtinctionAlbedo> coefficients;
    double scale = 1.0;  // times these
    Phase phase = Phase::henyey_greenstein;
    double asymmetry =
        0.0;         // Henyey and Greenstein's g, the mean cosine of the angle by which light is turned: -1 to 1, 0 for all sides alike
    Color emission;  // radiance that so much of it would have that nothing shines through: it emits as much as it absorbs of this
    double emission_strength = 1.0;        // times this
    std::optional<Grid> density = {};      // times the coefficients; in colours where it has three channels
    std::optional<Grid> albedo = {};       // three channels: of extinction, instead of the albedo (ExtinctionAlbedo only)
    std::optional<Grid> temperature = {};  // kelvin, one channel: of a black body, whose light times `emission` it then emits
    SourcePosition position;
};

}  // namespace lancer::scene
