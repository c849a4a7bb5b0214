// The statements of an OBJ file, before they become a mesh.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lancer/import/mesh/mesh_messages.h"

namespace lancer::obj {

constexpr std::int32_t absent = -1;

// Numbers from 0 into positions, uvs and normals; all in range.
struct Corner {
    std::int32_t position = absent;
    std::int32_t uv = absent;
    std::int32_t normal = absent;

    bool operator==(const Corner&) const = default;
};

// Faces from this one on have this material and belong to this object or group: numbers into the lists of names, or absent.
struct Run {
    std::size_t first_face = 0;
    std::int32_t material = absent;
    std::int32_t name = absent;
};

// A mtllib: file names, or one with blanks in it.
struct Library {
    std::string names;
    int line = 0;
    int column = 0;
};

struct Statements {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> colors;  // of the positions, as the file has them; empty where there are none, white where one has none
    std::vector<glm::vec2> uvs;
    std::vector<glm::vec3> normals;
    std::vector<Corner> corners;         // of all faces, one face after the other
    std::vector<std::size_t> face_ends;  // into corners; every face has at least three
    std::vector<Run> runs;               // by their first faces; before the first of them there is neither material nor name
    std::vector<std::string> materials;  // names that usemtl says
    std::vector<std::string> names;      // that o or g say
    std::vector<Library> libraries;
    std::size_t lines_and_points = 0;  // statements that are left out
};

// Mistakes are in `messages`.
Statements parse(std::string_view bytes, MeshMessages& messages);

}  // namespace lancer::obj
