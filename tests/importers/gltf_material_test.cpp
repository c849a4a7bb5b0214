// glTF: materials, textures, tangents.
#include <cmath>

#include <glm/geometric.hpp>

#include "gltf_file.h"

namespace lancer {
namespace {

using namespace lancer::testing;
using nlohmann::json;

// A picture of one grey pixel, as PNM, which our readers know by its first bytes.
std::string picture() { return "data:image/png;base64," + GltfFile::base64("P6 1 1 255\n\x80\x80\x80"); }

// A triangle with normals, texture coordinates and a material, of which the caller writes the rest.
GltfFile textured_triangle() {
    GltfFile file;
    json& primitive = file.triangle();
    primitive["attributes"]["NORMAL"] = file.accessor<float>("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1});
    primitive["attributes"]["TEXCOORD_0"] = file.accessor<float>("VEC2", {0, 1, 1, 1, 0, 0});  // v grows downwards in the file
    primitive["attributes"]["TEXCOORD_3"] = file.accessor<float>("VEC2", {0, 0.5, 0.5, 0.5, 0, 0});
    primitive["material"] = 0;
    file.json["materials"] = {json::object()};
    file.json["images"] = {{{"uri", picture()}}};
    file.json["textures"] = {{{"source", 0}, {"sampler", 0}}};
    file.json["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}}};
    return file;
}

scene::Material material_of(GltfFile& file, const ImportOptions& options = {}) {
    const GltfReading reading = read_gltf_file(file, options);
    EXPECT_TRUE(reading.scene) << reading.all();
    return reading.scene ? reading.scene->materials.at(static_cast<std::size_t>(reading.scene->objects.at(0).material)) : scene::Material{};
}

const scene::PrincipledMaterial& principled(const scene::Material& material) { return std::get<scene::PrincipledMaterial>(material.model); }

TEST(GltfMaterials, Factors) {
    GltfFile file = textured_triangle();
    file.json["materials"][0] = {
        {"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 0.25, 0.125, 1.0}}, {"metallicFactor", 0.25}, {"roughnessFactor", 0.75}}},
        {"emissiveFactor", {1.0, 0.5, 0.0}},
        {"doubleSided", true}};
    const scene::Material material = material_of(file);
    EXPECT_EQ(principled(material).metalness.number, 0.25);
    EXPECT_EQ(principled(material).roughness.number, 0.75);
    ASSERT_TRUE(material.emission);
    EXPECT_TRUE(material.emission->both_sides);
    EXPECT_FALSE(material.open_behind);
}

TEST(GltfMaterials, LeftOutPropertiesAreThoseOfTheSpecification) {
    GltfFile file = textured_triangle();
    const scene::Material material = material_of(file);
    EXPECT_EQ(principled(material).metalness.number, 1.0);
    EXPECT_EQ(principled(material).roughness.number, 1.0);
    EXPECT_TRUE(material.open_behind);
    EXPECT_FALSE(material.emission);
    EXPECT_EQ(material.opacity.number, 1.0);
}

TEST(GltfMaterials, TexturesAreMultipliedWithFactors) {
    GltfFile file = textured_triangle();
    file.json["materials"][0]["pbrMetallicRoughness"] = {{"baseColorTexture", {{"index", 0}}},
                                                         {"baseColorFactor", {1.0, 0.5, 0.25, 0.5}},
                                                         {"metallicRoughnessTexture", {{"index", 0}, {"texCoord", 3}}},
                                                         {"roughnessFactor", 0.5}};
    file.json["materials"][0]["alphaMode"] = "BLEND";
    file.mesh({{"POSITION", 0}});
    file.json["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] =
        file.accessor<std::uint8_t>("VEC4", {255, 255, 255, 255, 0, 0, 0, 0, 255, 0, 0, 255}, true);
    const GltfReading reading = read_gltf_file(file);
    ASSERT_TRUE(reading.scene) << reading.all();
    const scene::Material& material = reading.scene->materials[0];
    const auto& color = std::get<scene::ImageTexture>(principled(material).color);
    EXPECT_EQ(color.tint, scene::Rgb(1.0, 0.5, 0.25));
    EXPECT_TRUE(color.times_mesh_colors);
    EXPECT_FALSE(color.linear);
    EXPECT_TRUE(color.bytes);
    EXPECT_EQ(color.wrap, scene::Wrap::clamp);
    EXPECT_EQ(color.wrap_v, scene::Wrap::mirror);
    EXPECT_EQ(color.filter, scene::Filter::nearest);
    EXPECT_EQ(material.opacity.scale, 0.5);
    EXPECT_EQ(material.opacity.channel, scene::Channel::alpha);
    const scene::Value& roughness = principled(material).roughness;
    ASSERT_TRUE(roughness.texture);
    EXPECT_EQ(roughness.channel, scene::Channel::green);
    EXPECT_EQ(roughness.scale, 0.5);
    EXPECT_TRUE(std::get<scene::ImageTexture>(*roughness.texture).linear);
    EXPECT_EQ(std::get<scene::ImageTexture>(*roughness.texture).uv_set, 1);
    const scene::TriangleMesh& mesh = mesh_of(*reading.scene);
    EXPECT_EQ(mesh.uvs[2], glm::vec2(0, 1));  // upwards
    EXPECT_EQ(mesh.second_uvs[1], glm::vec2(0.5, 0.5));
    EXPECT_EQ(mesh.colors[2], glm::vec4(1, 0, 0, 1));
}

TEST(GltfMaterials, TextureTransformsAreThoseOfTheFile) {
    GltfFile file = textured_triangle();
    file.json["extensionsUsed"] = {"KHR_texture_transform"};
    file.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {
        {"index", 0}, {"extensions", {{"KHR_texture_transform", {{"offset", {0.25, 0.125}}, {"rotation", 0.3}, {"scale", {2.0, 3.0}}}}}}};
    const scene::Material material = material_of(file);
    const auto& t = std::get<scene::ImageTexture>(principled(material).color);
    // A place on the surface, by the file's own way (v downwards, turned anticlockwise on the picture) and by ours.
    const double u = 0.3, v = 0.2, c = std::cos(0.3), s = std::sin(0.3);
    const double expected_u = c * 2.0 * u + s * 3.0 * v + 0.25, expected_v = -s * 2.0 * u + c * 3.0 * v + 0.125;
    const double angle = t.rotation * 3.14159265358979323846 / 180.0, up = 1.0 - v;
    const double x = std::cos(angle) * t.scale.x * u - std::sin(angle) * t.scale.y * up + t.offset.x;
    const double y = std::sin(angle) * t.scale.x * u + std::cos(angle) * t.scale.y * up + t.offset.y;
    EXPECT_NEAR(x, expected_u, 1e-12);
    EXPECT_NEAR(y, 1.0 - expected_v, 1e-12);
}

TEST(GltfMaterials, MasksOfOneValueAreThereOrNot) {
    GltfFile file = textured_triangle();
    file.json["materials"][0] = {
        {"alphaMode", "MASK"}, {"alphaCutoff", 0.6}, {"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, 0.5}}}}};
    EXPECT_EQ(material_of(file).opacity.number, 0.0);
    file.json["materials"][0]["alphaCutoff"] = 0.4;
    EXPECT_EQ(material_of(file).opacity.number, 1.0);
}

TEST(GltfMaterials, GlassIsABodyWhereItIsThick) {
    GltfFile file = textured_triangle();
    file.json["extensionsUsed"] = {"KHR_materials_transmission", "KHR_materials_volume", "KHR_materials_ior", "KHR_materials_dispersion"};
    json& extensions = file.json["materials"][0]["extensions"];
    file.json["materials"][0]["pbrMetallicRoughness"]["metallicFactor"] = 0.0;
    extensions["KHR_materials_transmission"]["transmissionFactor"] = 1.0;
    extensions["KHR_materials_ior"]["ior"] = 1.7;
    scene::Material material = material_of(file);
    EXPECT_TRUE(principled(material).thin);
    EXPECT_TRUE(material.open_behind);
    EXPECT_EQ(principled(material).refraction, 1.7);
    extensions["KHR_materials_volume"] = {{"thicknessFactor", 1.0}, {"attenuationDistance", 0.5}, {"attenuationColor", {0.5, 1.0, 0.25}}};
    material = material_of(file);
    EXPECT_FALSE(principled(material).thin);
    EXPECT_FALSE(material.open_behind);
    extensions["KHR_materials_dispersion"]["dispersion"] = 0.5;
    material = material_of(file);
    const auto& glass = std::get<scene::DielectricMaterial>(material.model);
    EXPECT_EQ(std::get<scene::AbbeGlass>(glass.refraction).abbe_number, 40.0);
}

TEST(GltfMaterials, VariantsAreChosenByName) {
    GltfFile file = textured_triangle();
    file.json["extensionsUsed"] = {"KHR_materials_variants"};
    file.json["materials"] = {{{"name", "first"}}, {{"name", "second"}}};
    file.json["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "day"}}, {{"name", "night"}}};
    file.json["meshes"][0]["primitives"][0]["extensions"]["KHR_materials_variants"]["mappings"] = {{{"variants", {1}}, {"material", 1}}};
    EXPECT_EQ(material_of(file).name, "first");
    ImportOptions options;
    options.variant = "night";
    EXPECT_EQ(material_of(file, options).name, "second");
    options.variant = "nigth";
    EXPECT_NE(read_gltf_file(file, options).all().find("did you mean \"night\""), std::string::npos);
}

TEST(GltfMaterials, UnlitSurfacesShineInTheirColour) {
    GltfFile file = textured_triangle();
    file.json["extensionsUsed"] = {"KHR_materials_unlit"};
    file.json["materials"][0] = {{"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 0.25, 1.0, 1.0}}}},
                                 {"extensions", {{"KHR_materials_unlit", json::object()}}}};
    const scene::Material material = material_of(file);
    ASSERT_TRUE(material.emission);
    EXPECT_TRUE(std::holds_alternative<scene::DiffuseMaterial>(material.model));
}

TEST(GltfMaterials, MissingPicturesAreErrorsOrMagenta) {
    GltfFile file = textured_triangle();
    file.json["images"] = {{{"uri", "not%20there.png"}}};
    file.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 0;
    const GltfReading reading = read_gltf_file(file);
    EXPECT_FALSE(reading.scene);
    EXPECT_NE(reading.all().find("not there.png"), std::string::npos) << reading.all();
    ImportOptions options;
    options.magenta_textures = true;
    EXPECT_TRUE(read_gltf_file(file, options).scene);
}

TEST(GltfTangents, AlongUWhereTheFileHasNone) {
    GltfFile file = textured_triangle();
    file.json["materials"][0]["normalTexture"]["index"] = 0;
    const GltfReading reading = read_gltf_file(file);
    ASSERT_TRUE(reading.scene) << reading.all();
    for (const glm::vec4& tangent : mesh_of(*reading.scene).tangents) {
        EXPECT_EQ(tangent, glm::vec4(1, 0, 0, 1));
    }
    EXPECT_EQ(mesh_of(*reading.scene).tangents.size(), 3u);
}

TEST(GltfTangents, MirroredHalvesAreSplitAndOthersAveraged) {
    // Four triangles around the middle of a square, seen from the front: the right half's picture is mirrored.
    GltfFile file;
    const int positions = file.accessor<float>("VEC3", {0, 0, 0, -1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0});
    const int normals = file.accessor<float>("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
    const int uvs = file.accessor<float>("VEC2", {1, 0.5, 0, 1, 0, 1, 0, 0, 0, 0});
    json& primitive = file.mesh({{"POSITION", positions}, {"NORMAL", normals}, {"TEXCOORD_0", uvs}});
    primitive["indices"] = file.accessor<std::uint16_t>("SCALAR", {0, 2, 3, 0, 4, 1});
    primitive["material"] = 0;
    file.json["materials"] = {{{"normalTexture", {{"index", 0}}}}};
    file.json["images"] = {{{"uri", picture()}}};
    file.json["textures"] = {{{"source", 0}}};
    const GltfReading reading = read_gltf_file(file);
    ASSERT_TRUE(reading.scene) << reading.all();
    const scene::TriangleMesh& mesh = mesh_of(*reading.scene);
    EXPECT_EQ(mesh.positions.size(), 6u);  // the middle is there twice
    for (int k = 0; k < 3; ++k) {
        const glm::vec4 right = mesh.tangents[mesh.triangles[0][k]], left = mesh.tangents[mesh.triangles[1][k]];
        EXPECT_EQ(right, glm::vec4(-1, 0, 0, -1));
        EXPECT_EQ(left, glm::vec4(1, 0, 0, 1));
    }
}

}  // namespace
}  // namespace lancer
