// The statements of an OBJ file, before they become a mesh.
#pragma once

#include <cstdint>
#include <limits>
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

struct Statements {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> colors;  // of the positions, as the file has them; empty where there are none, white where one has none
    std::vector<glm::vec2> uvs;
    std::vector<glm::vec3> normals;
    std::vector<Corner> corners;         // of all faces, one face after the other
    std::vector<std::size_t> face_ends;  // into corners; every face has at least three
};

// Mistakes are in `messages`.
Statements parse(std::string_view bytes, MeshMessages& messages);

}  // namespace lancer::obj
