// Primitives as triangles.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <glm/mat4x4.hpp>

#include "lancer/import/gltf/accessors.h"
#include "lancer/scene/shapes.h"

namespace lancer::gltf {

// What becomes of a primitive besides what the file says: each node that poses its mesh in its own way needs its own triangles.
struct Pose {
    std::vector<float> weights;     // of morph targets
    std::vector<glm::mat4> joints;  // from the mesh as it was bound to where each joint has gone; empty: no skin
};

// What a primitive's material wants to know of its surface.
struct Wishes {
    std::vector<std::size_t> uv_sets;  // numbers of TEXCOORD_n, in the order of the mesh's sets; two at most
    bool tangents = false;
};

// Nothing where the primitive has no triangles that could be used; problems have been said.
std::shared_ptr<const scene::TriangleMesh> make_triangles(Document& document, Accessors& accessors, Json primitive, const Pose& pose,
                                                          const Wishes& wishes);

// Points, lines, strips and fans.
enum class Mode { points, lines, line_loop, line_strip, triangles, triangle_strip, triangle_fan };
Mode mode_of(Json primitive);

}  // namespace lancer::gltf
