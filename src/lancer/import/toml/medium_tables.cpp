// The keys of media and their grids. Defaults are those of scene/media.h; a test holds them together.
#include <glm/vec3.hpp>

#include "lancer/import/toml/notation.h"

namespace lancer::notation {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Range any{};
constexpr Range not_negative{0.0, infinity};
constexpr Range share{0.0, 1.0};

const Default none{};
const glm::dvec3 origin{0.0};

}  // namespace

const Table& medium() {
    static const Table table{
        "medium",
        "a medium",
        "What fills space: fog, smoke, milk, fire. It fills the bodies whose materials name it as their interior, or all that is outside "
        "of bodies.",
        {{"absorption", Kind::color, origin, not_negative, "1/m", "How much of each colour it swallows."},
         {"scattering", Kind::color, origin, not_negative, "1/m", "How much of each colour it turns into other directions."},
         {"extinction", Kind::color, none, not_negative, "1/m", "The sum of both; with albedo, instead of absorption and scattering."},
         {"albedo", Kind::color, none, share, "", "The share of extinction that is scattering."},
         {"scale", Kind::number, 1.0, not_negative, "", "Multiplies absorption and scattering, or extinction."},
         {"phase",
          Kind::choice,
          "henyey-greenstein",
          any,
          "",
          "Into which directions it scatters; rayleigh as what is much smaller than light's wavelength.",
          false,
          {"henyey-greenstein", "rayleigh"}},
         {"asymmetry", Kind::number, 0.0, Range{-0.999, 0.999}, "",
          "Henyey and Greenstein's g: 0 scatters to all sides alike, towards 1 ever more straight on, towards -1 back."},
         {"emission", Kind::color, none, not_negative, "W/(m^2 sr)",
          "It shines by itself, as much as so thick a layer of it that nothing shines through; it needs absorption for that. With "
          "temperature a "
          "factor, 1 when not written."},
         {"emission_strength", Kind::number, 1.0, not_negative, "", "Multiplies emission."},
         {"density", Kind::grid, none, any, "", "Multiplies extinction in space; outside of the grid there is nothing."},
         {"albedo_grid", Kind::grid, none, any, "", "The albedo in space, instead of albedo."},
         {"temperature", Kind::grid, none, any, "K", "It shines as a black body of these temperatures; with density."},
         {"everywhere", Kind::flag, false, any, "", "Whether it fills all that is outside of bodies, the camera's surroundings too."}}};
    return table;
}

const Table& grid() {
    static const Table table{
        "grid",
        "a grid",
        "Numbers in the cells of a box, straight lines between the cells' middles.",
        {{"file", Kind::file, none, any, "",
          "A .vdb (OpenVDB), .vol (Mitsuba) or .raw file (32-bit floats, little-endian, x fastest, then y, then z); instead of values."},
         {"name", Kind::text, none, any, "", "Which grid of a .vdb file; the first when not written."},
         {"cells", Kind::vector3, none, Range{1.0, 65536.0}, "", "How many there are along x, y and z; of values and .raw files."},
         {"channels", Kind::integer, 1.0, Range{1.0, 3.0}, "", "1, or 3 for linear [r, g, b]; of values and .raw files."},
         {"values", Kind::numbers, none, not_negative, "", "One for each cell and channel: channels fastest, then x, then y, then z."},
         {"min", Kind::vector3, none, any, "m", "One corner of the box; the file's own when not written, else [0, 0, 0]."},
         {"max", Kind::vector3, none, any, "m", "The opposite corner; the file's own when not written, else [1, 1, 1]."},
         {"fades", Kind::flag, none, any, "",
          "Whether it falls to 0 around the middles of the outermost cells; else it stays as it is to the box's border. .vdb files do, "
          "others do not "
          "when not written."},
         *place().find("scale"),
         *place().find("rotate"),
         *place().find("translate"),
         *place().find("matrix")}};
    return table;
}

}  // namespace lancer::notation
