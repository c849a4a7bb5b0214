#include <cmath>

#include <algorithm>

#include <fmt/format.h>

#include "lancer/import/gltf/check.h"

namespace lancer::gltf {

namespace {

// POSITION, NORMAL and TANGENT stand alone; the others are numbered without gaps from 0 on; those of others begin with an underscore.
bool is_attribute(std::string_view name) {
    if (name == "POSITION" || name == "NORMAL" || name == "TANGENT" || name.substr(0, 1) == "_") {
        return true;
    }
    for (const std::string_view stem : {"TEXCOORD_", "COLOR_", "JOINTS_", "WEIGHTS_"}) {
        if (name.substr(0, stem.size()) == stem) {
            const std::string_view number = name.substr(stem.size());
            return !number.empty() && std::all_of(number.begin(), number.end(), [](char c) { return c >= '0' && c <= '9'; });
        }
    }
    return false;
}

class MeshCheck {
public:
    explicit MeshCheck(Document& document) : document_(document) {}

    void check(Json mesh) {
        std::size_t targets = 0;
        for (const Json primitive : mesh["primitives"]) {
            targets = primitive["targets"].size();
            check_primitive(primitive);
        }
        if (mesh["weights"] && mesh["weights"].size() != targets) {
            document_.warning(mesh["weights"], fmt::format("{} weights for {} morph targets", mesh["weights"].size(), targets));
        }
    }

private:
    void check_primitive(Json primitive) {
        const Json attributes = primitive["attributes"];
        for (const Json attribute : attributes) {
            check_attribute(attribute, attributes);
        }
        for (const Json target : primitive["targets"]) {
            for (const Json attribute : target) {
                const std::string_view name = attribute.value().key;
                if (!is_attribute(name) || (name.substr(0, 1) != "_" && !attributes[name])) {
                    document_.warning(attribute, "a morph target moves what the primitive does not have");
                }
                if (document_.item("accessors", target, name).number("count", 0.0) !=
                    document_.item("accessors", attributes, "POSITION").number("count", 0.0)) {
                    document_.error(attribute, "expected as many values as the primitive has vertices");
                }
            }
        }
        check_material(document_.item("materials", primitive, "material"), primitive);
        const Json indices = document_.item("accessors", primitive, "indices");
        if (indices && (indices.text("type") != "SCALAR" || indices.truth("normalized", false))) {
            document_.warning(primitive["indices"], "expected whole numbers, as SCALAR");
        }
        const Json index_view = document_.item("bufferViews", indices, "bufferView");
        if (index_view["byteStride"]) {
            document_.warning(primitive["indices"], "the view of indices should have no byteStride");
        }
        if (attributes["TANGENT"] && !attributes["NORMAL"]) {
            document_.warning(attributes["TANGENT"], "tangents without normals are passed over");
        }
        const double count = (indices ? indices : document_.item("accessors", attributes, "POSITION")).number("count", 0.0);
        const std::size_t mode = primitive.natural("mode").value_or(4);
        if ((mode == 4 && std::fmod(count, 3.0) != 0.0) || (mode > 4 && count < 3.0) || (mode == 1 && std::fmod(count, 2.0) != 0.0)) {
            document_.warning(primitive, fmt::format("{} corners make no whole number of such pieces", count));
        }
    }

    void check_attribute(Json attribute, Json attributes) {
        const std::string_view name = attribute.value().key;
        if (!is_attribute(name)) {
            document_.warning(attribute, "glTF knows no such attribute; names of one's own begin with \"_\"");
        }
        const Json accessor = document_.item("accessors", attributes, name);
        if (name == "POSITION" && !(accessor["min"] && accessor["max"])) {
            document_.warning(attribute, "the accessor of positions should have \"min\" and \"max\"");
        }
        if (accessor.number("componentType", 0.0) == 5125.0 && name.substr(0, 1) != "_") {
            document_.warning(attribute, "vertices should have no values of 32-bit numbers");
        }
        const bool fits_quantized = document_.root()["extensionsRequired"].size() > 0;
        if ((name == "POSITION" || name == "NORMAL" || name == "TANGENT") && accessor.number("componentType", 5126.0) != 5126.0 &&
            !fits_quantized) {
            document_.warning(attribute, "expected floats, or KHR_mesh_quantization among extensionsRequired");
        }
        const std::string_view type = accessor.text("type");
        if (((name == "POSITION" || name == "NORMAL") && type != "VEC3") || (name == "TANGENT" && type != "VEC4")) {
            document_.error(attribute, fmt::format("{}: this attribute has another number of components", type));
        }
    }

    // Whether the textures have something to be laid by.
    void check_material(Json material, Json primitive) {
        const Json attributes = primitive["attributes"];
        const auto check_texture = [&](Json info) {
            const std::size_t set = info.natural("texCoord").value_or(0);
            if (info && !attributes[fmt::format("TEXCOORD_{}", set)]) {
                document_.warning(primitive, fmt::format("the material asks for TEXCOORD_{}, which the primitive lacks", set));
            }
        };
        const Json pbr = material["pbrMetallicRoughness"];
        check_texture(pbr["baseColorTexture"]);
        check_texture(pbr["metallicRoughnessTexture"]);
        for (const std::string_view name : {"normalTexture", "occlusionTexture", "emissiveTexture"}) {
            check_texture(material[name]);
        }
        if (material["normalTexture"] && primitive.natural("mode").value_or(4) < 4) {
            document_.warning(primitive, "a normal map on points or lines has nothing to turn");
        }
    }

    Document& document_;
};

}  // namespace

void check_meshes(Document& document) {
    MeshCheck mesh_check(document);
    for (const Json mesh : document.items("meshes")) {
        mesh_check.check(mesh);
    }
}

}  // namespace lancer::gltf
