// The attributes of a primitive's vertices, before they become a mesh.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "lancer/import/gltf/geometry.h"

namespace lancer::gltf {

// Each list is empty or as long as `positions`. v grows upwards, unlike in the file.
struct Attributes {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec4> tangents;
    std::vector<glm::vec2> uvs[2];
    std::vector<glm::vec4> colors;
    std::vector<std::uint32_t> indices;  // empty: 0, 1, 2...
};

// From accessors or from KHR_draco_mesh_compression, with morph targets and skins applied. False when there is nothing to show.
bool read_attributes(Document& document, Accessors& accessors, Json primitive, const Pose& pose, const Wishes& wishes,
                     Attributes& attributes);

// Moves positions, normals and tangents.
void apply_morphs(Document& document, Accessors& accessors, Json primitive, const std::vector<float>& weights, const Wishes& wishes,
                  Attributes& attributes);
void apply_skin(Document& document, Accessors& accessors, Json primitive, const std::vector<glm::mat4>& joints, Attributes& attributes);

}  // namespace lancer::gltf
