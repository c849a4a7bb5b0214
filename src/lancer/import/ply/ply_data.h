// The data of a PLY file, before they become a mesh.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "lancer/import/mesh/mesh_messages.h"
#include "lancer/import/ply/ply_header.h"
#include "lancer/scene/shapes.h"

namespace lancer::ply {

// What lancer takes from a vertex; a column is one of these for all vertices.
enum Role { x, y, z, nx, ny, nz, u, v, red, green, blue, alpha, role_count };

// For each role the number of the property that holds it, -1 for none.
using Columns = std::array<int, role_count>;

struct Data {
    scene::TriangleMesh mesh;            // vertices, and the faces that are triangles
    std::vector<std::uint32_t> corners;  // of larger faces, one face after the other
    std::vector<std::size_t> face_ends;  // into corners
    std::size_t small_faces = 0;         // with less than three corners, left out

    void add_face(const std::uint32_t* numbers, std::size_t count);
    void add_large_face(const std::uint32_t* numbers, std::size_t count);  // or one with less than three corners
    // Three vertices in a row make a triangle, every second one turned round; -1 begins a new strip.
    void add_strip(const std::uint32_t* numbers, std::size_t count);
};

// An element and what its lists mean to us.
enum class Meaning { vertices, faces, strips, nothing };
Meaning meaning_of(const Element& element);
Columns vertex_columns(const Element& vertices);
// The property with the corners of a face; -1 when there is none.
int corner_list(const Element& faces);

// Where the columns go in the mesh: allocates what the columns need.
struct Destination {
    float* first = nullptr;
    std::size_t stride = 0;  // floats from one vertex to the next
};
std::array<Destination, role_count> make_room(scene::TriangleMesh& mesh, std::size_t count, const Columns& columns);

// Both read all elements after the header. Counts are checked against the bytes that are left before anything is allocated.
void read_ascii(std::string_view body, const Header& header, Data& data, MeshMessages& messages);
void read_binary(std::string_view body, const Header& header, Data& data, MeshMessages& messages);

}  // namespace lancer::ply
