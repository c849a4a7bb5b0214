// Any bytes as a file of meshes: meshes that can be traced or at least one error, and nothing else.
#include "lancer/import/mesh/mesh_file.h"

#include <cstddef>
#include <cstdint>

#include "checked_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    lancer::Diagnostics diagnostics;
    const auto meshes = lancer::read_meshes({reinterpret_cast<const char*>(data), size}, "fuzz.meshes", diagnostics);
    require(meshes.empty() || !diagnostics.has_errors());
    for (const auto& mesh : meshes) {
        require(!mesh->triangles.empty());
        for (const glm::uvec3& triangle : mesh->triangles) {
            require(triangle.x < mesh->positions.size() && triangle.y < mesh->positions.size() && triangle.z < mesh->positions.size());
        }
    }
    return 0;
}
