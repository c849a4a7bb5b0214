// What every mesh must keep to before anyone traces a ray at it.
#pragma once

#include "lancer/import/mesh/mesh_messages.h"
#include "lancer/scene/shapes.h"

namespace lancer {

// Errors: a coordinate that is not finite or beyond 1e15 m, a triangle that names a vertex that is not there, no triangle at all.
// Repaired with a warning: triangles without area are left out. Normals get length 1; where one has no direction, the mean of the faces around
// takes its place. Texture coordinates that are not finite become 0. `line` and `column` say where the mesh stands, for the messages.
bool check_mesh(scene::TriangleMesh& mesh, MeshMessages& messages, int line = 0, int column = 0);

}  // namespace lancer
