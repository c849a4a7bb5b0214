// How bright pbrt makes a light: its colour, times "scale", times what brings a light of colour [1 1 1] to the wanted "power" or "illuminance". So
// rgb that is not white makes the light brighter or darker than that; other spectra have luminance 1 and do not.
#pragma once

#include <string_view>

#include "lancer/import/pbrt/graphics_state.h"
#include "lancer/import/pbrt/spectra.h"

namespace lancer::pbrt {

struct LightColor {
    Color color;
    double scale = 1.0;  // times this
};

// The parameter of that name, white light of luminance 1 where it is not there, and "scale".
LightColor read_light_color(const Recipe& light, std::string_view name, bool version3);

}  // namespace lancer::pbrt
