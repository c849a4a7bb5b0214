// Smooth surfaces from coarse triangles.
#pragma once

#include "lancer/scene/shapes.h"

namespace lancer::pbrt {

// Each triangle becomes four, `levels` times; then the points are moved to where endless subdivision would bring them, with its normals. Borders
// become smooth curves [Loop 1987; Hoppe et al. 1994 for borders and limits]. Corners and their vertices must fit.
scene::TriangleMesh loop_subdivision(scene::TriangleMesh cage, int levels);

}  // namespace lancer::pbrt
