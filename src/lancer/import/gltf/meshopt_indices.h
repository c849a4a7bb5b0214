// Compressed indices [Kapoulkine 2021, modes 1 and 2]. `indices` holds view.count * view.stride bytes to fill; false and the problem where the bytes
// are broken.
#pragma once

#include <string>

#include "lancer/import/gltf/meshopt.h"

namespace lancer::gltf {

bool decode_triangles(const MeshoptView& view, std::string& indices, std::string& problem);
bool decode_indices(const MeshoptView& view, std::string& indices, std::string& problem);

}  // namespace lancer::gltf
