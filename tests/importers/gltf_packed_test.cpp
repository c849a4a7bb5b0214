// glTF: EXT_meshopt_compression, bit by bit, and within a file.
#include <cstring>

#include "gltf_file.h"

#include "lancer/import/gltf/meshopt.h"

namespace lancer {
namespace {

using namespace lancer::testing;
using gltf::decode_meshopt;
using gltf::MeshoptView;

std::string bytes(std::initializer_list<int> values) {
    std::string text;
    for (const int value : values) {
        text.push_back(static_cast<char>(value));
    }
    return text;
}

std::string decoded(const std::string& packed, std::size_t count, std::size_t stride, const char* mode, const char* filter = "NONE") {
    std::string problem;
    const auto result = decode_meshopt({packed, count, stride, mode, filter}, problem);
    EXPECT_TRUE(result) << problem;
    return result.value_or(std::string());
}

// Every group of 16 bytes as it is.
std::string pack_attributes(const std::string& elements, std::size_t stride) {
    std::string packed = bytes({0xA0});
    std::string before(stride, '\0');
    const std::size_t count = elements.size() / stride, most = std::min<std::size_t>(8192 / stride / 16 * 16, 256);
    for (std::size_t first = 0; first < count; first += most) {
        const std::size_t here = std::min(most, count - first), groups = (here + 15) / 16;
        for (std::size_t k = 0; k < stride; ++k) {
            packed.append((groups + 3) / 4, '\xFF');
            for (std::size_t i = 0; i < 16 * groups; ++i) {
                const int difference = i < here ? static_cast<std::int8_t>(elements[(first + i) * stride + k] - before[k]) : 0;
                packed.push_back(static_cast<char>(static_cast<std::uint8_t>(difference < 0 ? -2 * difference - 1 : 2 * difference)));
                before[k] = i < here ? elements[(first + i) * stride + k] : before[k];
            }
        }
    }
    return packed + std::string(std::max<std::size_t>(stride, 32), '\0');
}

TEST(Meshopt, AttributesOfSeveralBlocks) {
    std::string elements;
    for (int i = 0; i < 12 * 700; ++i) {
        elements.push_back(static_cast<char>(i * i / 7 % 251));
    }
    EXPECT_EQ(decoded(pack_attributes(elements, 12), 700, 12, "ATTRIBUTES"), elements);
}

TEST(Meshopt, GroupsOfTwoAndFourBitsWithEscapes) {
    // Byte 0: differences of two bits, of which the fifth is escaped; byte 1: of four bits; byte 2: all zero; byte 3: as it is.
    std::string packed = bytes({0xA0, 0x01, 0b00011000, 0b11000000, 0, 0, 0x14, 0x02, 0x21, 0, 0, 0, 0, 0, 0, 0xF0, 0x64, 0x00, 0x03});
    for (int i = 0; i < 16; ++i) {
        packed.push_back(i == 3 ? '\x05' : '\0');
    }
    packed += std::string(28, '\0') + bytes({1, 2, 3, 4});  // the baseline
    const std::string elements = decoded(packed, 16, 4, "ATTRIBUTES");
    ASSERT_EQ(elements.size(), 64u);
    const auto column = [&](std::size_t k) {
        std::vector<int> values;
        for (std::size_t i = 0; i < 16; ++i) {
            values.push_back(static_cast<std::uint8_t>(elements[4 * i + k]));
        }
        return values;
    };
    // Zigzag: 1 is -1, 2 is 1, 0x14 is 10, 0x64 is 50.
    EXPECT_EQ(column(0), (std::vector<int>{1, 0, 1, 1, 11, 11, 11, 11, 11, 11, 11, 11, 11, 11, 11, 11}));
    EXPECT_EQ(column(1), (std::vector<int>{3, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 52, 52}));
    EXPECT_EQ(column(2), std::vector<int>(16, 3));
    EXPECT_EQ(column(3), (std::vector<int>{4, 4, 4, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}));
}

TEST(Meshopt, TrianglesAtEdgesAndOnTheirOwn) {
    // On its own by the table; at the newest edge with a new corner; at an older edge with a free corner; with the one before that.
    const std::string packed = bytes({0xE1, 0xF0, 0x00, 0x3F, 0x0D, 0x0E}) + std::string(16, '\0');
    const std::string result = decoded(packed, 12, 4, "TRIANGLES");
    std::vector<std::uint32_t> indices(12);
    ASSERT_EQ(result.size(), 48u);
    std::memcpy(indices.data(), result.data(), 48);
    EXPECT_EQ(indices, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3, 2, 1, 7, 2, 7, 6}));
}

TEST(Meshopt, IndicesAsDifferences) {
    const std::string result = decoded(bytes({0xD1, 20, 4, 6, 0, 0, 0, 0}), 3, 2, "INDICES");
    EXPECT_EQ(result, bytes({5, 0, 6, 0, 4, 0}));
}

TEST(Meshopt, Filters) {
    const auto filtered = [](const std::string& element, const char* filter) {
        return decoded(pack_attributes(element, element.size()), 1, element.size(), "ATTRIBUTES", filter);
    };
    EXPECT_EQ(filtered(bytes({0, 0, 127, 9}), "OCTAHEDRAL"), bytes({0, 0, 127, 9}));
    EXPECT_EQ(filtered(bytes({127, 0, 127, 9}), "OCTAHEDRAL"), bytes({127, 0, 0, 9}));
    EXPECT_EQ(filtered(bytes({0, 0, 0, 0, 0, 0, 0xFF, 0x7F}), "QUATERNION"), bytes({0, 0, 0, 0, 0, 0, 0xFF, 0x7F}));
    const std::string halves = filtered(bytes({3, 0, 0, 0xFF}), "EXPONENTIAL");
    float value = 0.0f;
    std::memcpy(&value, halves.data(), 4);
    EXPECT_EQ(value, 1.5f);
}

TEST(Meshopt, BrokenBytesAreRefused) {
    const std::string packed = pack_attributes(std::string(64, 'x'), 4);
    std::string problem;
    for (std::size_t size = 0; size < packed.size(); ++size) {
        EXPECT_FALSE(decode_meshopt({packed.substr(0, size), 16, 4, "ATTRIBUTES", "NONE"}, problem)) << size;
    }
    EXPECT_FALSE(decode_meshopt({packed, 4000000000u, 4, "ATTRIBUTES", "NONE"}, problem));
    EXPECT_FALSE(decode_meshopt({packed, 16, 4, "ATTRIBUTES", "QUATERNION"}, problem));
    EXPECT_FALSE(decode_meshopt({bytes({0xE1, 0xF0}) + std::string(16, '\0'), 6, 4, "TRIANGLES", "NONE"}, problem));
}

TEST(Gltf, CompressedViews) {
    GltfFile file;
    const std::vector<float> positions = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const std::string raw(reinterpret_cast<const char*>(positions.data()), 36);
    const std::string packed = pack_attributes(raw, 12);
    const auto data = static_cast<std::size_t>(file.view(std::vector<std::uint8_t>(packed.begin(), packed.end())));
    const nlohmann::json where = file.json["bufferViews"][data];
    file.json["bufferViews"].push_back({{"buffer", 0},
                                        {"byteLength", 36},
                                        {"byteStride", 12},
                                        {"extensions",
                                         {{"EXT_meshopt_compression",
                                           {{"buffer", 0},
                                            {"byteOffset", where["byteOffset"]},
                                            {"byteLength", packed.size()},
                                            {"byteStride", 12},
                                            {"mode", "ATTRIBUTES"},
                                            {"count", 3}}}}}});
    file.json["accessors"].push_back(
        {{"bufferView", 1}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}, {"min", {0, 0, 0}}, {"max", {1, 1, 0}}});
    file.json["extensionsUsed"] = file.json["extensionsRequired"] = {"EXT_meshopt_compression"};
    file.mesh({{"POSITION", 0}});
    const GltfReading reading = read_gltf_file(file);
    ASSERT_TRUE(reading.scene) << reading.all();
    EXPECT_EQ(mesh_of(*reading.scene).positions[1], glm::vec3(1, 0, 0));
}

}  // namespace
}  // namespace lancer
