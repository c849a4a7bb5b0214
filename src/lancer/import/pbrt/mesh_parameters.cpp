#include "lancer/import/pbrt/mesh_parameters.h"

#include <fmt/format.h>

namespace lancer::pbrt {

namespace {

// One for each vertex, or none.
template <class Vector>
bool fits(const Parameters& parameters, std::string_view name, std::vector<Vector>& list, std::size_t vertices) {
    if (list.empty() || list.size() == vertices) {
        return true;
    }
    if (const Parameter* parameter = parameters.find(name)) {
        parameters.error(*parameter,
                         fmt::format("\"{}\" needs one value for each of the {} points, found {}", name, vertices, list.size()));
    }
    return false;
}

}  // namespace

bool read_vertices(const Parameters& parameters, scene::TriangleMesh& mesh) {
    mesh.positions = parameters.triples("P");
    if (mesh.positions.empty()) {
        parameters.context().diagnostics.error(parameters.position(), parameters.owner() + " needs points: \"point3 P\"");
        return false;
    }
    mesh.normals = parameters.triples("N");
    const std::string_view uv = parameters.has("uv") || !parameters.has("st") ? "uv" : "st";
    mesh.uvs = parameters.pairs(uv);
    parameters.pass_over({"S", "faceIndices"});
    return fits(parameters, "N", mesh.normals, mesh.positions.size()) && fits(parameters, uv, mesh.uvs, mesh.positions.size());
}

// Corners by number; `per_face` of them each.
bool read_corners(const Parameters& parameters, std::size_t vertices, std::size_t per_face, std::vector<std::uint32_t>& corners) {
    const Parameter* parameter = parameters.find("indices");
    if (parameter == nullptr) {
        if (vertices != per_face) {
            parameters.context().diagnostics.error(
                parameters.position(), fmt::format("{} of {} points needs \"integer indices\": only with {} points can they be left out",
                                                   parameters.owner(), vertices, per_face));
            return false;
        }
        for (std::uint32_t i = 0; i < per_face; ++i) {
            corners.push_back(i);
        }
        return true;
    }
    for (const int corner : parameters.integers("indices")) {
        if (corner < 0 || static_cast<std::size_t>(corner) >= vertices) {
            parameters.error(*parameter,
                             fmt::format("\"indices\" names point {}, but there are {} points, counted from 0", corner, vertices));
            return false;
        }
        corners.push_back(static_cast<std::uint32_t>(corner));
    }
    if (corners.size() % per_face != 0) {
        parameters.error(*parameter, fmt::format("\"indices\" needs {} numbers for each face, found {}", per_face, corners.size()));
        return false;
    }
    return true;
}

}  // namespace lancer::pbrt
