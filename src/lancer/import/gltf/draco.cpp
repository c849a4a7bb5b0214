#include "lancer/import/gltf/draco.h"

#include <fmt/format.h>

#ifdef LANCER_HAS_DRACO
#include <new>

#include <draco/compression/decode.h>
#endif

namespace lancer::gltf {

#ifdef LANCER_HAS_DRACO

namespace {

// One of the mesh's attributes, `components` floats a vertex; empty where the file does not name it.
std::vector<float> read(Document& document, const draco::Mesh& mesh, Json ids, const std::string& name, int components) {
    const auto id = ids.natural(name);
    if (!id) {
        return {};
    }
    const draco::PointAttribute* attribute = mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(*id));
    if (attribute == nullptr) {
        document.error(ids[name], fmt::format("the compressed mesh has no attribute {}", *id));
        return {};
    }
    const auto count = static_cast<std::size_t>(mesh.num_points());
    const auto width = static_cast<std::size_t>(components);
    std::vector<float> values(count * width);
    for (std::size_t i = 0; i < count; ++i) {
        const auto point = draco::PointIndex(static_cast<std::uint32_t>(i));
        if (!attribute->ConvertValue(attribute->mapped_index(point), static_cast<std::int8_t>(components), &values[i * width])) {
            document.error(ids[name], "the compressed attribute can't be read");
            return {};
        }
    }
    return values;
}

template <class Vector>
std::vector<Vector> as_vectors(const std::vector<float>& values) {
    std::vector<Vector> vectors(values.size() / static_cast<std::size_t>(Vector::length()));
    for (std::size_t i = 0; i < values.size(); ++i) {
        vectors[i / static_cast<std::size_t>(Vector::length())][static_cast<int>(i % static_cast<std::size_t>(Vector::length()))] =
            values[i];
    }
    return vectors;
}

void fill(Document& document, const draco::Mesh& mesh, Json primitive, Json ids, const Wishes& wishes, Attributes& attributes) {
    attributes.positions = as_vectors<glm::vec3>(read(document, mesh, ids, "POSITION", 3));
    attributes.normals = as_vectors<glm::vec3>(read(document, mesh, ids, "NORMAL", 3));
    if (wishes.tangents) {
        attributes.tangents = as_vectors<glm::vec4>(read(document, mesh, ids, "TANGENT", 4));
    }
    for (std::size_t set = 0; set < wishes.uv_sets.size() && set < 2; ++set) {
        attributes.uvs[set] = as_vectors<glm::vec2>(read(document, mesh, ids, fmt::format("TEXCOORD_{}", wishes.uv_sets[set]), 2));
    }
    const Json color = document.item("accessors", primitive["attributes"], "COLOR_0");
    attributes.colors = as_vectors<glm::vec4>(read(document, mesh, ids, "COLOR_0", 4));
    if (color.text("type") == "VEC3") {
        for (glm::vec4& c : attributes.colors) {
            c.w = 1.0f;
        }
    }
    attributes.indices.reserve(3 * static_cast<std::size_t>(mesh.num_faces()));
    for (std::uint32_t f = 0; f < mesh.num_faces(); ++f) {
        for (const draco::PointIndex& corner : mesh.face(draco::FaceIndex(f))) {
            attributes.indices.push_back(corner.value());
        }
    }
}

}  // namespace

bool read_draco(Document& document, Accessors& accessors, Json primitive, Json draco_json, const Wishes& wishes, Attributes& attributes) {
    const auto view = draco_json.natural("bufferView");
    const auto bytes = view ? accessors.view(*view) : std::nullopt;
    if (!bytes) {
        return false;
    }
    // The numbers of vertices and indices stand in the accessors, too, and are what may be allocated.
    try {
        draco::DecoderBuffer buffer;
        buffer.Init(bytes->data(), bytes->size());
        auto decoded = draco::Decoder().DecodeMeshFromBuffer(&buffer);
        if (!decoded.ok()) {
            document.error(draco_json, fmt::format("the compressed mesh is broken: {}", decoded.status().error_msg_string()));
            return false;
        }
        fill(document, *decoded.value(), primitive, draco_json["attributes"], wishes, attributes);
    } catch (const std::bad_alloc&) {
        document.error(draco_json, "the compressed mesh asks for more memory than there is");
        return false;
    }
    if (document.has_errors()) {
        return false;
    }
    document.honoured("KHR_draco_mesh_compression", draco_json);
    return !attributes.positions.empty();
}

#else

bool read_draco(Document& document, Accessors&, Json, Json draco_json, const Wishes&, Attributes&) {
    document.error(draco_json, "this build of lancer can't read meshes compressed by Draco: it was built without libdraco-dev");
    return false;
}

#endif

}  // namespace lancer::gltf
