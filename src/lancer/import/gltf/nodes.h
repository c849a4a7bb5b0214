// The tree of nodes, as it stands at a moment of its animations.
#pragma once

#include <optional>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "lancer/import/gltf/document.h"

namespace lancer::gltf {

struct Node {
    Json json;
    int parent = -1;
    std::vector<int> children;
    glm::dvec3 translation{0.0};
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
    glm::dvec3 scale{1.0};
    std::optional<glm::dmat4> matrix;  // instead of the three
    std::vector<float> weights;        // of its mesh's morph targets; empty: the mesh's own
    glm::dmat4 to_world{1.0};
};

class Nodes {
public:
    // Errors: a node that is its own ancestor, or has two parents.
    explicit Nodes(Document& document);

    std::vector<Node>& list() { return nodes_; }
    const std::vector<Node>& list() const { return nodes_; }

    // Sets every `to_world`. For trees without errors.
    void place();

    // Indices of the nodes of a scene, parents first; of all nodes where there is no scene.
    std::vector<int> of_scene(Json scene) const;

private:
    void read(Document& document, Node& node);
    std::vector<int> below(std::vector<int> roots) const;
    std::vector<int> roots() const;

    std::vector<Node> nodes_;
};

}  // namespace lancer::gltf
