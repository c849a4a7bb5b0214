// What the triangles of a mesh enclose.
#pragma once

#include <glm/vec3.hpp>

#include "lancer/scene/shapes.h"

namespace lancer::app {

struct MeshFacts {
    glm::vec3 low{0.0f};  // of a box around it
    glm::vec3 high{0.0f};
    bool closed = false;  // each edge belongs to two triangles that run along it in opposite directions; vertices at the same place are one
    double volume = 0.0;  // of a closed mesh in its own space, cubic metres; negative where its faces point inwards
};

MeshFacts examine(const scene::TriangleMesh& mesh);

// Whether a point in the mesh's own space lies in a closed mesh: by the parity of the surfaces on the way out.
bool lies_inside(const scene::TriangleMesh& mesh, const glm::dvec3& point);

}  // namespace lancer::app
