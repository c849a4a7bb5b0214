// Where the nodes are at a moment.
#pragma once

#include "lancer/import/gltf/accessors.h"
#include "lancer/import/gltf/nodes.h"

namespace lancer::gltf {

// Sets translations, rotations, scales and weights of the nodes to what the file's animations say at `seconds`; before the first and after the last
// key they stay. All animations run together; where two move the same thing, the first does.
void animate(Document& document, Accessors& accessors, Nodes& nodes, double seconds);

// The matrices of a skin's joints: from the mesh as it was bound to world space. Empty after an error.
std::vector<glm::mat4> joints_of(Document& document, Accessors& accessors, const Nodes& nodes, Json skin);

}  // namespace lancer::gltf
