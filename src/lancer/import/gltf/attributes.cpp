#include "lancer/import/gltf/attributes.h"

#include <algorithm>

#include <fmt/format.h>

#include "lancer/import/gltf/draco.h"

namespace lancer::gltf {

namespace {

class AttributeReader {
public:
    AttributeReader(Document& document, Accessors& accessors, Json primitive)
        : document_(document), accessors_(accessors), attributes_(primitive["attributes"]) {}

    bool has(std::string_view name) const { return static_cast<bool>(attributes_[name]); }

    // An attribute as floats, `components` of them a vertex; empty, with a message, where it can't be used.
    std::vector<float> read(const std::string& name, std::size_t components, std::size_t count) {
        const Json property = attributes_[name];
        const auto accessor = accessors_.open(document_.item("accessors", attributes_, name));
        if (!accessor) {
            return {};
        }
        if (accessor->components != components) {
            document_.error(property, fmt::format("{}: expected {} numbers a vertex", Accessors::kind(*accessor), components));
            return {};
        }
        if (count != any_count && accessor->count != count) {
            document_.error(property, fmt::format("{} values for {} vertices", accessor->count, count));
            return {};
        }
        auto values = accessors_.floats(*accessor);
        return values ? std::move(*values) : std::vector<float>();
    }

    std::size_t components(const std::string& name) const {
        const std::string_view type = document_.item("accessors", attributes_, name).text("type");
        return type == "VEC4" ? 4 : type == "VEC2" ? 2 : 3;
    }

    static constexpr std::size_t any_count = static_cast<std::size_t>(-1);

private:
    Document& document_;
    Accessors& accessors_;
    Json attributes_;
};

template <class Vector>
std::vector<Vector> as_vectors(const std::vector<float>& values) {
    constexpr int length = Vector::length();
    std::vector<Vector> vectors(values.size() / static_cast<std::size_t>(length));
    for (std::size_t i = 0; i < vectors.size(); ++i) {
        for (int c = 0; c < length; ++c) {
            vectors[i][c] = values[i * static_cast<std::size_t>(length) + static_cast<std::size_t>(c)];
        }
    }
    return vectors;
}

}  // namespace

bool read_attributes(Document& document, Accessors& accessors, Json primitive, const Pose& pose, const Wishes& wishes,
                     Attributes& attributes) {
    AttributeReader reader(document, accessors, primitive);
    if (!reader.has("POSITION")) {
        document.warning(primitive, "a primitive without positions shows nothing");
        return false;
    }
    if (const Json draco = document.extension(primitive, "KHR_draco_mesh_compression")) {
        if (!read_draco(document, accessors, primitive, draco, wishes, attributes)) {
            return false;
        }
    } else {
        attributes.positions = as_vectors<glm::vec3>(reader.read("POSITION", 3, AttributeReader::any_count));
        const std::size_t count = attributes.positions.size();
        if (count == 0) {
            return false;
        }
        if (reader.has("NORMAL")) {
            attributes.normals = as_vectors<glm::vec3>(reader.read("NORMAL", 3, count));
        }
        if (wishes.tangents && reader.has("NORMAL") && reader.has("TANGENT")) {
            attributes.tangents = as_vectors<glm::vec4>(reader.read("TANGENT", 4, count));
        }
        for (std::size_t set = 0; set < wishes.uv_sets.size() && set < 2; ++set) {
            const std::string name = fmt::format("TEXCOORD_{}", wishes.uv_sets[set]);
            if (reader.has(name)) {
                attributes.uvs[set] = as_vectors<glm::vec2>(reader.read(name, 2, count));
            } else {
                document.warning(primitive, fmt::format("the material's texture asks for {}, which the primitive lacks", name));
            }
        }
        if (reader.has("COLOR_0")) {
            const std::size_t components = reader.components("COLOR_0");
            const std::vector<float> colors = reader.read("COLOR_0", components == 4 ? 4 : 3, count);
            attributes.colors = components == 4 ? as_vectors<glm::vec4>(colors) : std::vector<glm::vec4>();
            if (components == 3) {
                for (std::size_t i = 0; i + 2 < colors.size(); i += 3) {
                    attributes.colors.emplace_back(colors[i], colors[i + 1], colors[i + 2], 1.0f);
                }
            }
        }
        if (primitive["indices"]) {
            const auto accessor = accessors.open(document.item("accessors", primitive, "indices"));
            auto indices = accessor ? accessors.naturals(*accessor) : std::nullopt;
            if (!indices) {
                return false;
            }
            attributes.indices = std::move(*indices);
        }
    }
    if (document.has_errors()) {
        return false;
    }
    for (std::vector<glm::vec2>& uvs : attributes.uvs) {
        for (glm::vec2& uv : uvs) {
            uv.y = 1.0f - uv.y;
        }
    }
    if (!pose.weights.empty()) {
        apply_morphs(document, accessors, primitive, pose.weights, wishes, attributes);
    }
    if (!pose.joints.empty()) {
        apply_skin(document, accessors, primitive, pose.joints, attributes);
    }
    return !document.has_errors();
}

}  // namespace lancer::gltf
