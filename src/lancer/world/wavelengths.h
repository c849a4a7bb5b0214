// Which wavelengths a scene's paths carry.
#pragma once

#include <vector>

#include "lancer/world/world.h"

namespace lancer {

// Fills world.wavelength_places and wavelength_densities of a spectral world from its emitters: wavelengths are drawn where the scene's light
// is and the eye sees it [after Radziszewski et al. 2009], so that four of them, a quarter of the random number apart, leave little colour noise.
void compile_wavelengths(World& world);

// Of the linear RGB of `light`, given at each nanometre, as four wavelengths of the world's density estimate it: the variances of red, green and
// blue together.
double wavelength_variance(const World& world, const std::vector<double>& light);

}  // namespace lancer
