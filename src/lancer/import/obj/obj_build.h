// Faces of an OBJ file as a mesh.
#pragma once

#include <vector>

#include "lancer/import/obj/obj_parse.h"
#include "lancer/scene/shapes.h"

namespace lancer::obj {

struct FaceRange {
    std::size_t begin = 0;
    std::size_t end = 0;  // above begin
};

std::vector<FaceRange> all_faces(const Statements& statements);

// Of those faces, in that order; not checked yet.
scene::TriangleMesh build(const Statements& statements, const std::vector<FaceRange>& faces);

}  // namespace lancer::obj
