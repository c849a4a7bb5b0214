#include "lancer/import/gltf/nodes.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/ext/matrix_transform.hpp>

namespace lancer::gltf {

namespace {

glm::dvec3 vec3_or(Json node, std::string_view key, const glm::dvec3& otherwise) {
    const std::vector<double> v = node.numbers(key);
    return v.size() == 3 ? glm::dvec3(v[0], v[1], v[2]) : otherwise;
}

glm::dmat4 local(const Node& node) {
    if (node.matrix) {
        return *node.matrix;
    }
    const glm::dmat4 moved = glm::translate(glm::dmat4(1.0), node.translation);
    return glm::scale(moved * glm::mat4_cast(node.rotation), node.scale);
}

// Whether the last row is that of a map of space, and the columns could come from a translation, a rotation and a scale.
bool is_decomposable(const glm::dmat4& m) {
    constexpr double rounding = 1e-3;  // files hold floats, multiplied several times
    const auto skew = [&](int i, int j) {
        const glm::dvec3 a(m[i]), b(m[j]);
        return std::abs(glm::dot(a, b)) <= rounding * glm::length(a) * glm::length(b);
    };
    return m[0].w == 0.0 && m[1].w == 0.0 && m[2].w == 0.0 && m[3].w == 1.0 && skew(0, 1) && skew(0, 2) && skew(1, 2);
}

}  // namespace

Nodes::Nodes(Document& document) {
    const std::vector<Json>& items = document.items("nodes");
    nodes_.resize(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
        nodes_[i].json = items[i];
        read(document, nodes_[i]);
        for (const Json child : items[i]["children"]) {
            const auto number = static_cast<std::size_t>(child.value().number);
            if (nodes_[number].parent >= 0) {
                document.error(child, fmt::format("node {} is already the child of node {}", number, nodes_[number].parent));
                continue;
            }
            nodes_[number].parent = static_cast<int>(i);
            nodes_[i].children.push_back(static_cast<int>(number));
        }
    }
    // Each node has one parent at most, so what no root leads to goes in circles.
    if (below(roots()).size() != nodes_.size()) {
        std::vector<bool> reached(nodes_.size(), false);
        for (const int node : below(roots())) {
            reached[static_cast<std::size_t>(node)] = true;
        }
        const auto first = std::find(reached.begin(), reached.end(), false);
        document.error(items[static_cast<std::size_t>(first - reached.begin())], "the node is its own ancestor");
    }
    for (const Json scene : document.items("scenes")) {
        for (const Json root : scene["nodes"]) {
            if (nodes_[static_cast<std::size_t>(root.value().number)].parent >= 0) {
                document.warning(root, "a scene's nodes should have no parent");
            }
        }
    }
}

void Nodes::read(Document& document, Node& node) {
    if (const std::vector<double> m = node.json.numbers("matrix"); m.size() == 16) {
        glm::dmat4 matrix(1.0);
        for (int i = 0; i < 16; ++i) {
            matrix[i / 4][i % 4] = m[static_cast<std::size_t>(i)];
        }
        node.matrix = matrix;
        if (node.json["translation"] || node.json["rotation"] || node.json["scale"]) {
            document.warning(node.json, "a node has either a matrix or translation, rotation and scale; the matrix counts");
        }
        if (!is_decomposable(matrix)) {
            document.warning(node.json["matrix"], "the matrix is not made of a translation, a rotation and a scale");
            (*node.matrix)[0].w = (*node.matrix)[1].w = (*node.matrix)[2].w = 0.0;
            (*node.matrix)[3].w = 1.0;
        }
    }
    node.translation = vec3_or(node.json, "translation", node.translation);
    node.scale = vec3_or(node.json, "scale", node.scale);
    if (const std::vector<double> r = node.json.numbers("rotation"); r.size() == 4) {
        const double length = std::sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2] + r[3] * r[3]);
        constexpr double rounding = 0.00769;  // of signed bytes, the coarsest numbers that rotations may be stored in
        if (std::abs(length - 1.0) > rounding) {
            document.warning(node.json["rotation"], "the quaternion's length is not 1");
        }
        if (length > 0.0) {
            node.rotation = glm::dquat(r[3] / length, r[0] / length, r[1] / length, r[2] / length);
        }
    }
    for (const double weight : node.json.numbers("weights")) {
        node.weights.push_back(static_cast<float>(weight));
    }
}

std::vector<int> Nodes::roots() const {
    std::vector<int> roots;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        if (nodes_[i].parent < 0) {
            roots.push_back(static_cast<int>(i));
        }
    }
    return roots;
}

// Each node once, though a scene may name a node and one below it.
std::vector<int> Nodes::below(std::vector<int> roots) const {
    std::vector<bool> met(nodes_.size(), false);
    std::vector<int> order;
    std::reverse(roots.begin(), roots.end());
    while (!roots.empty()) {
        const int node = roots.back();
        roots.pop_back();
        if (met[static_cast<std::size_t>(node)]) {
            continue;
        }
        met[static_cast<std::size_t>(node)] = true;
        order.push_back(node);
        const std::vector<int>& children = nodes_[static_cast<std::size_t>(node)].children;
        roots.insert(roots.end(), children.rbegin(), children.rend());
    }
    return order;
}

std::vector<int> Nodes::of_scene(Json scene) const {
    if (!scene) {
        return below(roots());
    }
    std::vector<int> roots;
    for (const Json root : scene["nodes"]) {
        roots.push_back(static_cast<int>(root.value().number));
    }
    return below(std::move(roots));
}

void Nodes::place() {
    for (const int index : below(roots())) {
        Node& node = nodes_[static_cast<std::size_t>(index)];
        node.to_world = local(node);
        if (node.parent >= 0) {
            node.to_world = nodes_[static_cast<std::size_t>(node.parent)].to_world * node.to_world;
        }
    }
}

}  // namespace lancer::gltf
