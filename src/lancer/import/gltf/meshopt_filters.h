// What makes vectors of compressed numbers again [Kapoulkine 2021, filters], in place. False and the problem where the filter does not fit.
#pragma once

#include <string>

#include "lancer/import/gltf/meshopt.h"

namespace lancer::gltf {

bool apply_filter(const MeshoptView& view, std::string& elements, std::string& problem);

}  // namespace lancer::gltf
