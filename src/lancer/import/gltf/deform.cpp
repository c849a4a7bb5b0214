// Morph targets and skins [Khronos 2021, sections 3.7.2.2 and 3.7.3].
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "lancer/import/gltf/attributes.h"

namespace lancer::gltf {

namespace {

// Adds weight * (what the target says) to the first `components` numbers of each vertex.
template <class Vector>
void add_target(Document& document, Accessors& accessors, Json target, const std::string& name, float weight, std::vector<Vector>& vectors,
                int components, glm::vec4 sign = glm::vec4(1.0f)) {
    const auto accessor = accessors.open(document.item("accessors", target, name));
    if (!accessor) {
        return;
    }
    if (accessor->components != static_cast<std::size_t>(components) || accessor->count != vectors.size()) {
        document.error(target[name], fmt::format("{} elements, {}: expected as many as the mesh has vertices, of {} numbers",
                                                 accessor->count, Accessors::kind(*accessor), components));
        return;
    }
    const auto values = accessors.floats(*accessor);
    if (!values) {
        return;
    }
    const float* value = values->data();
    for (Vector& vector : vectors) {
        for (int c = 0; c < components; ++c) {
            vector[c] += weight * sign[c] * *value++;
        }
    }
}

glm::vec3 unit(const glm::vec3& v) {
    const float length = glm::length(v);
    return length > 0.0f ? v / length : v;
}

}  // namespace

void apply_morphs(Document& document, Accessors& accessors, Json primitive, const std::vector<float>& weights, const Wishes& wishes,
                  Attributes& attributes) {
    std::size_t number = 0;
    for (const Json target : primitive["targets"]) {
        const float weight = number < weights.size() ? weights[number] : 0.0f;
        ++number;
        if (weight == 0.0f) {
            continue;
        }
        if (target["POSITION"]) {
            add_target(document, accessors, target, "POSITION", weight, attributes.positions, 3);
        }
        if (target["NORMAL"] && !attributes.normals.empty()) {
            add_target(document, accessors, target, "NORMAL", weight, attributes.normals, 3);
        }
        if (target["TANGENT"] && !attributes.tangents.empty()) {
            add_target(document, accessors, target, "TANGENT", weight, attributes.tangents, 3);
        }
        for (std::size_t set = 0; set < wishes.uv_sets.size() && set < 2; ++set) {
            const std::string name = fmt::format("TEXCOORD_{}", wishes.uv_sets[set]);
            if (target[name] && !attributes.uvs[set].empty()) {
                add_target(document, accessors, target, name, weight, attributes.uvs[set], 2, {1.0f, -1.0f, 1.0f, 1.0f});
            }
        }
        if (target["COLOR_0"] && !attributes.colors.empty()) {
            const bool has_alpha = document.item("accessors", target, "COLOR_0").text("type") == "VEC4";
            add_target(document, accessors, target, "COLOR_0", weight, attributes.colors, has_alpha ? 4 : 3);
        }
    }
    for (glm::vec4& color : attributes.colors) {
        color = glm::clamp(color, 0.0f, 1.0f);
    }
}

void apply_skin(Document& document, Accessors& accessors, Json primitive, const std::vector<glm::mat4>& joints, Attributes& attributes) {
    const Json names = primitive["attributes"];
    const std::size_t count = attributes.positions.size();
    std::vector<glm::mat4> blended;
    std::vector<float> sums(count, 0.0f);
    for (int set = 0; set < 16; ++set) {
        const std::string joints_name = fmt::format("JOINTS_{}", set), weights_name = fmt::format("WEIGHTS_{}", set);
        if (!names[joints_name] || !names[weights_name]) {
            break;
        }
        const auto joint_accessor = accessors.open(document.item("accessors", names, joints_name));
        const auto weight_accessor = accessors.open(document.item("accessors", names, weights_name));
        if (!joint_accessor || !weight_accessor) {
            return;
        }
        if (joint_accessor->components != 4 || weight_accessor->components != 4 || joint_accessor->count != count ||
            weight_accessor->count != count) {
            document.error(names[joints_name], "expected four joints and four weights for each vertex");
            return;
        }
        const auto numbers = accessors.naturals(*joint_accessor);
        const auto weights = accessors.floats(*weight_accessor);
        if (!numbers || !weights) {
            return;
        }
        blended.resize(count, glm::mat4(0.0f));
        for (std::size_t i = 0; i < 4 * count; ++i) {
            const float weight = (*weights)[i];
            if (weight == 0.0f) {
                continue;
            }
            if ((*numbers)[i] >= joints.size()) {
                document.error(names[joints_name], fmt::format("joint {}: the skin has {}", (*numbers)[i], joints.size()));
                return;
            }
            blended[i / 4] += weight * joints[(*numbers)[i]];
            sums[i / 4] += weight;
        }
    }
    if (blended.empty()) {
        document.warning(primitive, "the mesh of a skin has no joints and weights, and stays where it was bound");
        return;
    }
    for (std::size_t i = 0; i < count; ++i) {
        if (!(sums[i] > 0.0f)) {
            continue;  // held by no joint
        }
        // Weights should sum to 1; stored as bytes they often don't quite.
        const glm::mat4 matrix = blended[i] / sums[i];
        attributes.positions[i] = glm::vec3(matrix * glm::vec4(attributes.positions[i], 1.0f));
        const glm::mat3 linear(matrix);
        if (!attributes.normals.empty()) {
            // The cofactors are the inverse transpose times the determinant, and exist when the inverse does not.
            const glm::mat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]), glm::cross(linear[0], linear[1]));
            attributes.normals[i] = unit(cofactors * attributes.normals[i]);
        }
        if (!attributes.tangents.empty()) {
            attributes.tangents[i] = glm::vec4(unit(linear * glm::vec3(attributes.tangents[i])), attributes.tangents[i].w);
        }
    }
}

}  // namespace lancer::gltf
