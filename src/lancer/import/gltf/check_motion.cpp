// Skins and animations.
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "lancer/import/gltf/check.h"

namespace lancer::gltf {

namespace {

// Rotations and weights may be stored in signed or unsigned bytes, the coarsest numbers there are.
constexpr double coarsest = 0.00769;

bool has_skinned_primitive(Json mesh) {
    for (const Json primitive : mesh["primitives"]) {
        if (primitive["attributes"]["JOINTS_0"] && primitive["attributes"]["WEIGHTS_0"]) {
            return true;
        }
    }
    return false;
}

// The number of morph targets of a mesh.
std::size_t targets_of(Json mesh) {
    for (const Json primitive : mesh["primitives"]) {
        return primitive["targets"].size();
    }
    return 0;
}

int root_of(const Nodes& nodes, std::size_t index) {
    int node = static_cast<int>(index);
    while (nodes.list()[static_cast<std::size_t>(node)].parent >= 0) {
        node = nodes.list()[static_cast<std::size_t>(node)].parent;
    }
    return node;
}

void check_skin(Document& document, const Nodes& nodes, Json skin) {
    std::set<int> roots;
    for (const Json joint : skin["joints"]) {
        roots.insert(root_of(nodes, static_cast<std::size_t>(joint.value().number)));
    }
    if (roots.size() > 1) {
        document.warning(skin["joints"], "the joints have no common root");
    }
    const auto skeleton = skin.natural("skeleton");
    if (skeleton && *skeleton < nodes.list().size()) {
        for (const Json joint : skin["joints"]) {
            int node = static_cast<int>(joint.value().number);
            while (node >= 0 && node != static_cast<int>(*skeleton)) {
                node = nodes.list()[static_cast<std::size_t>(node)].parent;
            }
            if (node < 0) {
                document.warning(skin["skeleton"], "expected a node above all joints");
                break;
            }
        }
    }
    const Json matrices = document.item("accessors", skin, "inverseBindMatrices");
    if (matrices && matrices.number("count", 0.0) < static_cast<double>(skin["joints"].size())) {
        document.error(skin["inverseBindMatrices"],
                       fmt::format("{} matrices for {} joints", matrices.number("count", 0.0), skin["joints"].size()));
    }
    if (document.item("bufferViews", matrices, "bufferView")["byteStride"]) {
        document.warning(skin["inverseBindMatrices"], "the view should have no byteStride");
    }
}

// Joints that are there, weights that sum to 1.
void check_binding(Document& document, Accessors& accessors, Json attributes, std::size_t joint_count) {
    const auto joints = accessors.open(document.item("accessors", attributes, "JOINTS_0"));
    const auto weights = accessors.open(document.item("accessors", attributes, "WEIGHTS_0"));
    if (!joints || !weights || joints->components != 4 || weights->components != 4 || joints->count != weights->count) {
        return;
    }
    const auto numbers = accessors.naturals(*joints);
    const auto shares = accessors.floats(*weights);
    if (!numbers || !shares) {
        return;
    }
    bool sums = true, are_there = true, differ = true, positive = true;
    for (std::size_t i = 0; i < 4 * joints->count; i += 4) {
        double sum = 0.0;
        for (std::size_t k = i; k < i + 4; ++k) {
            sum += static_cast<double>((*shares)[k]);
            positive = positive && (*shares)[k] >= 0.0f;
            are_there = are_there && (*numbers)[k] < joint_count;
            for (std::size_t other = i; other < k; ++other) {
                differ = differ && ((*numbers)[k] != (*numbers)[other] || (*shares)[k] == 0.0f || (*shares)[other] == 0.0f);
            }
        }
        sums = sums && (std::abs(sum - 1.0) <= coarsest || attributes["WEIGHTS_1"]);
    }
    if (!sums || !positive) {
        document.warning(attributes["WEIGHTS_0"], "the weights of a vertex should be positive and sum to 1; they are scaled");
    }
    if (!differ) {
        document.warning(attributes["JOINTS_0"], "a vertex names the same joint twice");
    }
    if (!are_there) {
        document.error(attributes["JOINTS_0"], fmt::format("a vertex names a joint that is not there: the skin has {}", joint_count));
    }
}

void check_sampler(Document& document, Accessors& accessors, Json sampler, std::string_view path) {
    const auto input = accessors.open(document.item("accessors", sampler, "input"));
    const auto output = accessors.open(document.item("accessors", sampler, "output"));
    if (!input || !output) {
        return;
    }
    for (const std::string_view side : {"input", "output"}) {
        if (document.item("bufferViews", document.item("accessors", sampler, side), "bufferView")["byteStride"]) {
            document.warning(sampler[side], "the view of an animation should have no byteStride");
        }
    }
    if (!input->json["min"] || !input->json["max"]) {
        document.warning(sampler["input"], "the accessor of times should have \"min\" and \"max\"");
    }
    const auto times = accessors.floats(*input);
    if (times && !times->empty() && times->front() < 0.0f) {
        document.warning(sampler["input"], "an animation should not begin before 0");
    }
    if (path == "rotation" && output->components == 4) {
        const auto values = accessors.floats(*output);
        const bool is_cubic = sampler.text("interpolation") == "CUBICSPLINE";
        for (std::size_t i = is_cubic ? 4 : 0; values && i + 3 < values->size(); i += is_cubic ? 12 : 4) {
            double square = 0.0;
            for (std::size_t k = i; k < i + 4; ++k) {
                square += static_cast<double>((*values)[k]) * static_cast<double>((*values)[k]);
            }
            if (std::abs(std::sqrt(square) - 1.0) > coarsest) {
                document.warning(sampler["output"], fmt::format("quaternion {} has a length of {}", i / 4, std::sqrt(square)));
                break;
            }
        }
    }
}

}  // namespace

void check_skins(Document& document, Accessors& accessors, const Nodes& nodes) {
    for (const Json skin : document.items("skins")) {
        check_skin(document, nodes, skin);
    }
    std::set<std::pair<std::uint32_t, std::uint32_t>> bound;
    for (const Node& node : nodes.list()) {
        const Json mesh = document.item("meshes", node.json, "mesh");
        const Json skin = document.item("skins", node.json, "skin");
        if (node.json["weights"] && node.json["weights"].size() != targets_of(mesh)) {
            document.warning(node.json["weights"],
                             fmt::format("{} weights for {} morph targets", node.json["weights"].size(), targets_of(mesh)));
        }
        if (skin && !has_skinned_primitive(mesh)) {
            document.warning(node.json["skin"], "a skin needs a mesh with joints and weights");
        } else if (skin && bound.insert({mesh.index(), skin.index()}).second) {
            for (const Json primitive : mesh["primitives"]) {
                if (primitive["attributes"]["JOINTS_0"] && primitive["attributes"]["WEIGHTS_0"]) {
                    check_binding(document, accessors, primitive["attributes"], skin["joints"].size());
                }
            }
        } else if (mesh && !skin && has_skinned_primitive(mesh)) {
            document.warning(node.json, "the mesh has joints and weights, but its node has no skin: it stays as it is");
        }
    }
}

void check_animations(Document& document, Accessors& accessors) {
    for (const Json animation : document.items("animations")) {
        std::vector<Json> samplers;
        for (const Json sampler : animation["samplers"]) {
            samplers.push_back(sampler);
        }
        for (const Json channel : animation["channels"]) {
            const std::size_t number = channel.natural("sampler").value_or(samplers.size());
            if (number < samplers.size()) {
                check_sampler(document, accessors, samplers[number], channel["target"].text("path"));
            }
        }
    }
}

}  // namespace lancer::gltf
