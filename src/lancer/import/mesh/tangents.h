// Tangents for normal maps, where a file brings none.
#pragma once

#include "lancer/scene/shapes.h"

namespace lancer {

// Fills `tangents` the way that normal maps are baked for: MikkTSpace [Mikkelsen 2008]. Vertices where tangents of neighbouring triangles do not belong
// together are split, so all lists of vertices may grow. Needs normals and uvs; without them nothing is done.
void add_tangents(scene::TriangleMesh& mesh);

}  // namespace lancer
