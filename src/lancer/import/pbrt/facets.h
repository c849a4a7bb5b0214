// How rough pbrt means a surface to be.
#pragma once

#include <string>

#include "lancer/import/pbrt/textures.h"
#include "lancer/scene/textures.h"

namespace lancer::pbrt {

struct FacetValues {
    scene::Value roughness;
    scene::Value anisotropy;
};

// Of the parameters "roughness", "uroughness" and "vroughness" with a prefix, such as "interface.".
FacetValues read_facets(const Recipe& recipe, const Textures& textures, const std::string& prefix, double otherwise, bool version3);

// From "roughness" to that of our materials, whose square is alpha.
double our_roughness(double value, bool remapped, bool version3);

}  // namespace lancer::pbrt
