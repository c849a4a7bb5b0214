// Small glTF files made by tests.
#pragma once

#include <cstring>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "reading.h"

namespace lancer::testing {

// The JSON of a file with one buffer, to which accessors can be added; everything else is written into `json` by hand.
class GltfFile {
public:
    GltfFile() { json = {{"asset", {{"version", "2.0"}}}}; }

    nlohmann::json json;

    // A view of the bytes given, from a multiple of 4 bytes on; its index.
    template <class Number>
    int view(const std::vector<Number>& values) {
        bytes_.resize((bytes_.size() + 3) / 4 * 4, '\0');
        const std::size_t begin = bytes_.size();
        bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Number));
        json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", begin}, {"byteLength", values.size() * sizeof(Number)}});
        return static_cast<int>(json["bufferViews"].size()) - 1;
    }

    template <class Number>
    static constexpr int component_type() {
        return std::is_same_v<Number, float>           ? 5126
               : std::is_same_v<Number, std::uint32_t> ? 5125
               : std::is_same_v<Number, std::uint16_t> ? 5123
               : std::is_same_v<Number, std::int16_t>  ? 5122
               : std::is_same_v<Number, std::uint8_t>  ? 5121
                                                       : 5120;
    }

    // An accessor of these values; its index.
    template <class Number>
    int accessor(const std::string& type, const std::vector<Number>& values, bool normalized = false) {
        const std::size_t width = type == "SCALAR" ? 1 : type == "VEC2" ? 2 : type == "VEC3" ? 3 : type == "MAT4" ? 16 : 4;
        nlohmann::json accessor = {
            {"bufferView", view(values)}, {"componentType", component_type<Number>()}, {"count", values.size() / width}, {"type", type}};
        if (normalized) {
            accessor["normalized"] = true;
        }
        std::vector<double> low(width, 1e300), high(width, -1e300);
        for (std::size_t i = 0; i < values.size(); ++i) {
            low[i % width] = std::min(low[i % width], static_cast<double>(values[i]));
            high[i % width] = std::max(high[i % width], static_cast<double>(values[i]));
        }
        accessor["min"] = low;
        accessor["max"] = high;
        json["accessors"].push_back(accessor);
        return static_cast<int>(json["accessors"].size()) - 1;
    }

    // A mesh of one primitive with these attributes, at a node of its own; the primitive, to be added to.
    nlohmann::json& mesh(const nlohmann::json& attributes) {
        json["nodes"].push_back({{"mesh", json["meshes"].size()}});
        json["meshes"].push_back({{"primitives", nlohmann::json::array({{{"attributes", attributes}}})}});
        return json["meshes"].back()["primitives"][0];
    }

    // A triangle in the plane z = 0, which faces +z.
    nlohmann::json& triangle() { return mesh({{"POSITION", accessor<float>("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0})}}); }

    std::string text() {
        if (!bytes_.empty()) {
            json["buffers"] =
                nlohmann::json::array({{{"byteLength", bytes_.size()}, {"uri", "data:application/octet-stream;base64," + base64(bytes_)}}});
        }
        return json.dump(1);
    }

    std::string binary() {
        if (!bytes_.empty()) {
            json["buffers"] = nlohmann::json::array({{{"byteLength", bytes_.size()}}});
        }
        std::string text = json.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        std::string data = bytes_;
        data.resize((data.size() + 3) / 4 * 4, '\0');
        return "glTF" + word(2) + word(static_cast<std::uint32_t>(28 + text.size() + data.size())) +
               word(static_cast<std::uint32_t>(text.size())) + "JSON" + text + word(static_cast<std::uint32_t>(data.size())) +
               std::string("BIN\0", 4) + data;
    }

    static std::string word(std::uint32_t value) {
        std::string bytes(4, '\0');
        std::memcpy(bytes.data(), &value, 4);
        return bytes;
    }

    static std::string base64(const std::string& bytes) {
        static constexpr char alphabet[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        std::string text;
        for (std::size_t i = 0; i < bytes.size(); i += 3) {
            std::uint32_t bits = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
            }
            for (std::size_t k = 0; k < 4; ++k) {
                text += i + k <= bytes.size() ? alphabet[bits >> (18 - 6 * k) & 63] : '=';
            }
        }
        return text;
    }

private:
    std::string bytes_;
};

struct GltfReading : Reading {
    ImportReport report;
};

inline GltfReading read_gltf_bytes(const std::string& bytes, const ImportOptions& options = {}, const std::string& name = "scene.gltf") {
    const TemporaryFolder folder;
    const std::string path = folder.write(name, bytes);
    Diagnostics diagnostics;
    GltfReading reading;
    auto scene = import_scene(path, options, reading.report, diagnostics);
    static_cast<Reading&>(reading) = gather(std::move(scene), diagnostics);
    return reading;
}

inline GltfReading read_gltf_file(GltfFile& file, const ImportOptions& options = {}) { return read_gltf_bytes(file.text(), options); }

// The triangles of the object of that number.
inline const scene::TriangleMesh& mesh_of(const scene::Scene& scene, std::size_t object = 0) {
    return *std::get<scene::Mesh>(scene.objects.at(object).shape).data;
}

}  // namespace lancer::testing
