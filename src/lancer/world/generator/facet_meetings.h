// What becomes of light that meets one facet of a rough surface: added up over the facets that are seen, with the kernel's own, in double precision.
#pragma once

#ifndef LANCER_DOUBLE
#define LANCER_DOUBLE
#endif

#include <vector>

#include "lancer/kernel/bsdf/fresnel.h"
#include "lancer/kernel/bsdf/stretched.h"

namespace lancer {

struct Meeting {
    double lost = 0.0;       // share of the light that another facet is in the way of
    double reflected = 0.0;  // share that is reflected, and leaves
};

// Instead of a relative index: facets that reflect everything.
inline constexpr double mirror_eta = 0.0;

// For each relative index of refraction, of light from `wo`, a direction away from the surface of length 1.
std::vector<Meeting> meetings(const kernel_double::Facets& f, const kernel_double::Vec3& wo, const std::vector<double>& etas);

}  // namespace lancer
