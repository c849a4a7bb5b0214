// What meshes in the text have in common: points with normals and uv, and corners that name them.
#pragma once

#include <cstdint>
#include <vector>

#include "lancer/import/pbrt/parameters.h"
#include "lancer/scene/shapes.h"

namespace lancer::pbrt {

// False after an error.
bool read_vertices(const Parameters& parameters, scene::TriangleMesh& mesh);

// `per_face` numbers for each face, each below `vertices`. Without "indices" there is one face of all points. False after an error.
bool read_corners(const Parameters& parameters, std::size_t vertices, std::size_t per_face, std::vector<std::uint32_t>& corners);

}  // namespace lancer::pbrt
