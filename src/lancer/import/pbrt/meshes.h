// Triangles: in the text, in a PLY file, and what was made of them so that normals tell the outside.
#pragma once

#include <memory>

#include "lancer/import/pbrt/parameters.h"
#include "lancer/scene/shapes.h"

namespace lancer::pbrt {

using SharedMesh = std::shared_ptr<const scene::TriangleMesh>;

// Null when there is an error, or nothing to see; both are said.
SharedMesh read_triangle_mesh(const Parameters& parameters, bool reversed);
SharedMesh read_bilinear_mesh(const Parameters& parameters, bool reversed);
SharedMesh read_subdivision(const Parameters& parameters, bool reversed);
SharedMesh read_ply_mesh(const Parameters& parameters, bool reversed);

// Checked, counter-clockwise seen from where the normals point, and turned inside out when `reversed`.
SharedMesh finished_mesh(scene::TriangleMesh mesh, const Parameters& parameters, bool reversed);

}  // namespace lancer::pbrt
