// Hairs and ribbons along a curve, as triangles.
#pragma once

#include "lancer/import/pbrt/meshes.h"

namespace lancer::pbrt {

// Null when there is an error, or nothing to see; both are said.
SharedMesh read_curve_mesh(const Parameters& parameters, bool reversed);

}  // namespace lancer::pbrt
