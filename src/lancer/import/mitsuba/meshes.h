// Triangles of shapes.
#pragma once

#include <memory>

#include "lancer/import/mitsuba/builder.h"

namespace lancer::mitsuba {

// Of "obj", "ply" and "serialized": with normals as Mitsuba finds them where the file has none, and texture coordinates turned to its way. A PLY
// file's attribute of that name, if any, becomes the mesh's colours. Null when the file can't be read; the diagnostics say why.
std::shared_ptr<const scene::TriangleMesh> mesh_from_file(Builder& builder, Plugin& plugin, const std::string& attribute);

// Of "bsplinecurve" and "linearcurve".
std::shared_ptr<const scene::TriangleMesh> curves_from_file(Builder& builder, Plugin& plugin);

// From -1 to 1 along x and y, at z = 0, with its normal along z; uv from 0 to 1.
std::shared_ptr<const scene::TriangleMesh> rectangle_mesh();
// From -1 to 1 along all three; each side has uv from 0 to 1.
std::shared_ptr<const scene::TriangleMesh> cube_mesh();

// Its inside out.
scene::TriangleMesh turned(scene::TriangleMesh mesh);

}  // namespace lancer::mitsuba
