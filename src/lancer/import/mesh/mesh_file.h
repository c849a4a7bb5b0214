// Many meshes in one binary file, as `lancer convert` writes them: nothing of a mesh is lost, and reading is little more than copying.
//
// "lancer meshes 1\n", the number of meshes, and for each of them how long its eight arrays are and the arrays themselves: positions (3 floats),
// normals (3), uvs (2), second uvs (2), tangents (4), colours (4), colours of faces (4), triangles (3 unsigned integers of 32 bits). All is
// little-endian, counts have 64 bits.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "lancer/base/diagnostic.h"
#include "lancer/scene/shapes.h"

namespace lancer {

std::string write_meshes(const std::vector<std::shared_ptr<const scene::TriangleMesh>>& meshes);

// Nothing when there are errors: bytes of another kind, counts that the bytes don't explain, numbers that are not finite or beyond 1e15 m,
// triangles that name vertices that are not there.
std::vector<std::shared_ptr<const scene::TriangleMesh>> read_meshes(std::string_view bytes, const std::string& file,
                                                                    Diagnostics& diagnostics);

}  // namespace lancer
