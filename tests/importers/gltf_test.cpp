// glTF: geometry, nodes, cameras and lights.
#include <cmath>

#include "gltf_file.h"

namespace lancer {
namespace {

using namespace lancer::testing;
using nlohmann::json;

TEST(Gltf, TriangleAsTextAndAsBinary) {
    GltfFile file;
    file.triangle();
    for (const GltfReading& reading : {read_gltf_bytes(file.text()), read_gltf_bytes(file.binary(), {}, "scene.glb")}) {
        ASSERT_TRUE(reading.scene) << reading.all();
        EXPECT_EQ(reading.messages.size(), 2u) << reading.all();
        EXPECT_NE(reading.all().find("note: there is no camera"), std::string::npos);
        EXPECT_NE(reading.all().find("note: there is no light"), std::string::npos);
        ASSERT_EQ(reading.scene->objects.size(), 1u);
        const scene::TriangleMesh& mesh = mesh_of(*reading.scene);
        EXPECT_EQ(mesh.positions[1], glm::vec3(1, 0, 0));
        EXPECT_EQ(mesh.triangles[0], glm::uvec3(0, 1, 2));
        EXPECT_EQ(scene::chosen_integrator(*reading.scene), "path");
        EXPECT_EQ(reading.scene->cameras.size(), 1u);
        EXPECT_NE(reading.scene->background.zenith, scene::Background{}.zenith);
    }
}

TEST(Gltf, IndicesOfEveryTypeStripsAndFans) {
    const std::vector<float> square = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
    const auto triangles = [&](int mode, auto indices) {
        GltfFile file;
        json& primitive = file.mesh({{"POSITION", file.accessor<float>("VEC3", square)}});
        primitive["mode"] = mode;
        primitive["indices"] = file.accessor("SCALAR", indices);
        const GltfReading reading = read_gltf_file(file);
        EXPECT_TRUE(reading.scene) << reading.all();
        return reading.scene ? mesh_of(*reading.scene).triangles : std::vector<glm::uvec3>();
    };
    const std::vector<glm::uvec3> two = {{0, 1, 2}, {1, 3, 2}};
    EXPECT_EQ(triangles(4, std::vector<std::uint8_t>{0, 1, 2, 1, 3, 2}), two);
    EXPECT_EQ(triangles(4, std::vector<std::uint16_t>{0, 1, 2, 1, 3, 2}), two);
    EXPECT_EQ(triangles(4, std::vector<std::uint32_t>{0, 1, 2, 1, 3, 2}), two);
    // A strip and a fan face the same way as the triangles.
    EXPECT_EQ(triangles(5, std::vector<std::uint16_t>{0, 1, 2, 3}), two);
    EXPECT_EQ(triangles(6, std::vector<std::uint16_t>{0, 1, 3, 2}), (std::vector<glm::uvec3>{{1, 3, 0}, {3, 2, 0}}));
}

TEST(Gltf, NormalizedIntegersAndSparseValues) {
    GltfFile file;
    const std::vector<std::int16_t> positions = {0, 0, 0, 0, 32767, 0, 0, 0, -32768, 16384, 0, 0};
    const int accessor = file.accessor<std::int16_t>("VEC4", positions, true);
    file.json["accessors"][0]["type"] = "VEC3";
    file.json["accessors"][0]["count"] = 3;
    file.json["accessors"][0].erase("min");
    file.json["accessors"][0].erase("max");
    file.json["bufferViews"][0]["byteStride"] = 8;
    file.json["accessors"][0]["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", file.view<std::uint8_t>({1})}, {"componentType", 5121}}},
        {"values", {{"bufferView", file.view<std::int16_t>({32767, 0, 0, 0})}}},
    };
    file.json["extensionsUsed"] = file.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    file.mesh({{"POSITION", accessor}});
    const GltfReading reading = read_gltf_file(file);
    ASSERT_TRUE(reading.scene) << reading.all();
    const std::vector<glm::vec3>& read = mesh_of(*reading.scene).positions;
    EXPECT_EQ(read[0], glm::vec3(0.0f));
    EXPECT_EQ(read[1], glm::vec3(1.0f, 0.0f, 0.0f));
    EXPECT_EQ(read[2], glm::vec3(-1.0f, 16384.0f / 32767.0f, 0.0f));
}

TEST(Gltf, NodesCarryEachOther) {
    GltfFile file;
    file.triangle();
    file.json["nodes"][0]["translation"] = {1, 0, 0};
    file.json["nodes"].push_back({{"children", {0}}, {"scale", {2, 2, 2}}, {"rotation", {0, 0, std::sqrt(0.5), std::sqrt(0.5)}}});
    file.json["scenes"] = {{{"nodes", {1}}}};
    const GltfReading reading = read_gltf_file(file);
    ASSERT_TRUE(reading.scene) << reading.all();
    // Moved along x, turned to y, scaled by 2.
    const glm::dvec4 corner = reading.scene->objects[0].to_parent * glm::dvec4(0, 0, 0, 1);
    EXPECT_NEAR(corner.x, 0.0, 1e-12);
    EXPECT_NEAR(corner.y, 2.0, 1e-12);
}

TEST(Gltf, ScenesAreChosen) {
    GltfFile file;
    file.triangle();
    file.triangle();
    file.json["scenes"] = {{{"nodes", {0}}, {"name", "one"}}, {{"nodes", {0, 1}}, {"name", "two"}}};
    EXPECT_EQ(read_gltf_file(file).scene->objects.size(), 1u);
    file.json["scene"] = 1;
    EXPECT_EQ(read_gltf_file(file).scene->objects.size(), 2u);
    ImportOptions options;
    options.scene = "one";
    EXPECT_EQ(read_gltf_file(file, options).scene->objects.size(), 1u);
    options.scene = "tow";
    const GltfReading missing = read_gltf_file(file, options);
    EXPECT_FALSE(missing.scene);
    EXPECT_NE(missing.all().find("did you mean \"two\""), std::string::npos) << missing.all();
}

TEST(Gltf, CamerasLookAlongTheirNode) {
    GltfFile file;
    file.triangle();
    file.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}, {"aspectRatio", 2.0}}}},
                            {{"type", "orthographic"}, {"orthographic", {{"xmag", 1.5}, {"ymag", 3.0}, {"znear", 0.1}, {"zfar", 10.0}}}}};
    file.json["nodes"].push_back({{"camera", 0}, {"translation", {0, 0, 4}}});
    file.json["nodes"].push_back({{"camera", 1}, {"rotation", {0, std::sqrt(0.5), 0, std::sqrt(0.5)}}});
    const GltfReading reading = read_gltf_file(file);
    ASSERT_TRUE(reading.scene) << reading.all();
    const std::vector<scene::Camera>& cameras = reading.scene->cameras;
    ASSERT_EQ(cameras.size(), 2u);
    EXPECT_EQ(cameras[0].position, glm::dvec3(0, 0, 4));
    EXPECT_EQ(cameras[0].direction, glm::dvec3(0, 0, -1));
    EXPECT_NEAR(cameras[0].fov, 57.29577951, 1e-6);
    EXPECT_EQ(reading.scene->settings.width, 2 * reading.scene->settings.height);
    EXPECT_EQ(cameras[1].projection, scene::Projection::orthographic);
    EXPECT_EQ(cameras[1].extent, 6.0);
    EXPECT_NEAR(cameras[1].direction.x, -1.0, 1e-12);
}

TEST(Gltf, LightsHangOnNodes) {
    GltfFile file;
    file.triangle();
    file.json["extensionsUsed"] = {"KHR_lights_punctual"};
    file.json["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "point"}, {"intensity", 20.0}, {"color", {1.0, 0.5, 0.0}}},
        {{"type", "directional"}, {"intensity", 3.0}},
        {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", 0.5}}}},
    };
    for (int i = 0; i < 3; ++i) {
        file.json["nodes"].push_back({{"translation", {0, 2, 0}}, {"extensions", {{"KHR_lights_punctual", {{"light", i}}}}}});
    }
    const GltfReading reading = read_gltf_file(file);
    ASSERT_TRUE(reading.scene) << reading.all();
    const std::vector<scene::Light>& lights = reading.scene->lights;
    ASSERT_EQ(lights.size(), 3u);
    EXPECT_EQ(std::get<scene::PointLight>(lights[0].model).position, glm::dvec3(0, 2, 0));
    EXPECT_EQ(std::get<scene::DirectionalLight>(lights[1].model).direction, glm::dvec3(0, 0, -1));
    EXPECT_NEAR(std::get<scene::SpotLight>(lights[2].model).angle, 28.6478898, 1e-6);
    EXPECT_NEAR(std::get<scene::SpotLight>(lights[2].model).falloff, 22.9183118, 1e-6);
    // Lit by its own lamps, the scene gets no surroundings.
    EXPECT_EQ(reading.scene->background.zenith, scene::Background{}.zenith);
}

TEST(Gltf, InstancesArePlacements) {
    GltfFile file;
    file.triangle();
    file.json["extensionsUsed"] = file.json["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
    const int places = file.accessor<float>("VEC3", {0, 0, 0, 0, 0, -5});
    const int sizes = file.accessor<float>("VEC3", {1, 1, 1, 3, 3, 3});
    file.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"TRANSLATION", places}, {"SCALE", sizes}};
    const GltfReading reading = read_gltf_file(file);
    ASSERT_TRUE(reading.scene) << reading.all();
    EXPECT_TRUE(reading.scene->objects.empty());
    ASSERT_EQ(reading.scene->placements.size(), 2u);
    EXPECT_EQ(reading.scene->placements[1].to_parent * glm::dvec4(1, 0, 0, 1), glm::dvec4(3, 0, -5, 1));
}

// ---- What moves -------------------------------------------------------------------------------------------------------------------

// A node's translation along x: 0 at one second, 1 at two; the tangents of the spline are 0 and 3.
double translation_at(const std::string& interpolation, double seconds) {
    GltfFile file;
    file.triangle();
    const bool is_cubic = interpolation == "CUBICSPLINE";
    const int times = file.accessor<float>("SCALAR", {1, 2});
    const int values = is_cubic ? file.accessor<float>("VEC3", {0, 0, 0, 0, 0, 0, 0, 0, 0, 3, 0, 0, 1, 0, 0, 0, 0, 0})
                                : file.accessor<float>("VEC3", {0, 0, 0, 1, 0, 0});
    file.json["animations"] = {{{"samplers", {{{"input", times}, {"output", values}, {"interpolation", interpolation}}}},
                                {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}}};
    ImportOptions options;
    options.frame = seconds;
    const GltfReading reading = read_gltf_file(file, options);
    EXPECT_TRUE(reading.scene) << reading.all();
    return reading.scene ? reading.scene->objects[0].to_parent[3].x : -1.0;
}

TEST(GltfAnimation, StepsLinesAndSplines) {
    for (const char* interpolation : {"STEP", "LINEAR", "CUBICSPLINE"}) {
        EXPECT_EQ(translation_at(interpolation, 0.0), 0.0) << interpolation;
        EXPECT_EQ(translation_at(interpolation, 9.0), 1.0) << interpolation;
    }
    EXPECT_EQ(translation_at("STEP", 1.75), 0.0);
    EXPECT_EQ(translation_at("LINEAR", 1.75), 0.75);
    // Hermite's polynomials at 3/4: the second value 27/32, its tangent -9/64.
    EXPECT_NEAR(translation_at("CUBICSPLINE", 1.75), 27.0 / 32.0 - 3.0 * 9.0 / 64.0, 1e-12);
}

TEST(GltfAnimation, RotationsTakeTheShortWay) {
    GltfFile file;
    file.triangle();
    const float h = std::sqrt(0.5f);
    const int times = file.accessor<float>("SCALAR", {0, 1});
    const int values = file.accessor<float>("VEC4", {0, 0, 0, 1, 0, 0, -h, -h});  // a quarter turn, with the other sign
    file.json["animations"] = {{{"samplers", {{{"input", times}, {"output", values}}}},
                                {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "rotation"}}}}}}}};
    ImportOptions options;
    options.frame = 0.5;
    const GltfReading reading = read_gltf_file(file, options);
    ASSERT_TRUE(reading.scene) << reading.all();
    const glm::dvec4 x = reading.scene->objects[0].to_parent * glm::dvec4(1, 0, 0, 0);
    EXPECT_NEAR(x.x, std::cos(0.7853981633974483), 1e-6);
    EXPECT_NEAR(x.y, std::sin(0.7853981633974483), 1e-6);
}

TEST(GltfAnimation, MorphTargetsAreWeighed) {
    GltfFile file;
    json& primitive = file.triangle();
    const int target = file.accessor<float>("VEC3", {0, 0, 0, 0, 0, 0, 0, 0, 2});
    primitive["targets"] = {{{"POSITION", target}}};
    file.json["meshes"][0]["weights"] = {0.5};
    EXPECT_EQ(mesh_of(*read_gltf_file(file).scene).positions[2], glm::vec3(0, 1, 1));
    const int times = file.accessor<float>("SCALAR", {0, 1});
    const int weights = file.accessor<float>("SCALAR", {0, 1});
    file.json["animations"] = {{{"samplers", {{{"input", times}, {"output", weights}}}},
                                {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}}}}};
    ImportOptions options;
    options.frame = 0.25;
    EXPECT_EQ(mesh_of(*read_gltf_file(file, options).scene).positions[2], glm::vec3(0, 1, 0.5));
}

TEST(GltfAnimation, SkinsFollowTheirJoints) {
    GltfFile file;
    const int positions = file.accessor<float>("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0});
    const int joints = file.accessor<std::uint8_t>("VEC4", {0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0});
    const int weights = file.accessor<float>("VEC4", {1, 0, 0, 0, 0.5, 0.5, 0, 0, 1, 0, 0, 0});
    file.mesh({{"POSITION", positions}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}});
    const int inverse =
        file.accessor<float>("MAT4", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1});
    file.json["nodes"][0]["translation"] = {100, 0, 0};  // means nothing to a skin
    file.json["nodes"][0]["skin"] = 0;
    file.json["nodes"].push_back({{"children", {2}}});
    file.json["nodes"].push_back({{"translation", {1, 0, 4}}});
    file.json["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", inverse}}};
    const GltfReading reading = read_gltf_file(file);
    ASSERT_TRUE(reading.scene) << reading.all();
    const std::vector<glm::vec3>& read = mesh_of(*reading.scene).positions;
    EXPECT_EQ(read[0], glm::vec3(0, 0, 0));
    EXPECT_EQ(read[1], glm::vec3(1, 0, 2));
    EXPECT_EQ(read[2], glm::vec3(0, 1, 4));
    EXPECT_EQ(reading.scene->objects[0].to_parent, glm::dmat4(1.0));
}

// ---- Mistakes ---------------------------------------------------------------------------------------------------------------------

void expect_refused(const GltfReading& reading, const std::string& words) {
    EXPECT_FALSE(reading.scene) << words;
    EXPECT_NE(reading.all().find(words), std::string::npos) << words << "\n" << reading.all();
}

TEST(GltfErrors, ExtensionsThatAreRequired) {
    GltfFile file;
    file.triangle();
    file.json["extensionsUsed"] = file.json["extensionsRequired"] = {"EXT_of_another_kind"};
    expect_refused(read_gltf_file(file), "EXT_of_another_kind");
    file.json.erase("extensionsRequired");
    const GltfReading reading = read_gltf_file(file);
    EXPECT_TRUE(reading.scene);
    EXPECT_EQ(reading.report.count(Treatment::dropped), 1u);
}

TEST(GltfErrors, NodesThatGoInCircles) {
    GltfFile file;
    file.triangle();
    file.json["nodes"] = {{{"children", {1}}}, {{"children", {0}}, {"mesh", 0}}};
    expect_refused(read_gltf_file(file), "its own ancestor");
}

TEST(GltfErrors, PlacesAndPointers) {
    const GltfReading broken = read_gltf_bytes("{\"asset\": {\"version\": \"2.0\"},\n \"nodes\": [ {\"mesh\": 7} ]}");
    EXPECT_FALSE(broken.scene);
    EXPECT_NE(broken.all().find("scene.gltf:2:22: error: /nodes/0/mesh: 7"), std::string::npos) << broken.all();
    expect_refused(read_gltf_bytes("{\"asset\": 01}"), ":1:");
    GltfFile file;
    file.triangle();
    file.json["nodes"][0]["mesh"] = -1;
    expect_refused(read_gltf_bytes(file.binary(), {}, "scene.glb"), "byte ");
}

TEST(GltfErrors, CountsThatNoBytesExplain) {
    GltfFile file;
    file.triangle();
    file.json["accessors"][0]["count"] = 4294967295u;
    expect_refused(read_gltf_file(file), "4294967295 elements");
    file.json["accessors"][0].erase("bufferView");
    expect_refused(read_gltf_file(file), "far more memory");
}

// A data URI of 2 GB; of a file with a hole in it, so that the disk holds next to nothing.
TEST(GltfErrors, DataThatIsTooLargeForText) {
    const TemporaryFolder folder;
    const std::string path =
        folder.write("large.gltf", R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 2000000000, "uri": "data:;base64,)");
    std::filesystem::resize_file(path, std::uintmax_t{2} << 30);
    const Reading reading = read_path(path);
    EXPECT_FALSE(reading.scene);
    EXPECT_EQ(reading.messages.size(), 1u);
}

TEST(GltfErrors, BytesThatAreNotThere) {
    GltfFile file;
    file.triangle();
    file.json["bufferViews"][0]["byteLength"] = 100;
    expect_refused(read_gltf_file(file), "bytes 0 to 100 of a buffer of 36");
    GltfFile other;
    other.triangle();
    std::string text = other.text();
    text.replace(text.find("\"data:"), 40, "\"data:application/octet-stream;base64,!!");
    expect_refused(read_gltf_bytes(text), "no valid base64");
    std::string cut = other.binary();
    cut.resize(cut.size() - 20);
    expect_refused(read_gltf_bytes(cut, {}, "scene.glb"), "the file has");
}

TEST(GltfErrors, FilesOutsideTheSandbox) {
    GltfFile file;
    file.triangle();
    file.text();
    file.json["buffers"] = {{{"byteLength", 36}, {"uri", "../../etc/passwd"}}};
    ImportOptions options;
    options.sandbox = true;
    expect_refused(read_gltf_bytes(file.json.dump(), options), "outside the scene's folder");
    file.json["buffers"][0]["uri"] = "..%2f..%2fetc/passwd";
    expect_refused(read_gltf_bytes(file.json.dump(), options), "outside the scene's folder");
}

TEST(GltfErrors, DeepJsonAndManyMessages) {
    expect_refused(read_gltf_bytes(std::string(100000, '[')), "100 deep");
    std::string text = "{\"asset\": {\"version\": \"2.0\"}, \"nodes\": [";
    for (int i = 0; i < 1000; ++i) {
        text += "{\"mesh\": 5},";
    }
    const GltfReading reading = read_gltf_bytes(text + "{}]}");
    EXPECT_FALSE(reading.scene);
    EXPECT_LT(reading.messages.size(), 110u);
}

TEST(GltfErrors, IndicesBeyondTheVerticesAreLeftOut) {
    GltfFile file;
    json& primitive = file.mesh({{"POSITION", file.accessor<float>("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0})}});
    primitive["indices"] = file.accessor<std::uint16_t>("SCALAR", {0, 1, 2, 0, 1, 7});
    const GltfReading reading = read_gltf_file(file);
    ASSERT_TRUE(reading.scene) << reading.all();
    EXPECT_EQ(mesh_of(*reading.scene).triangles.size(), 1u);
    EXPECT_NE(reading.all().find("not there"), std::string::npos) << reading.all();
}

}  // namespace
}  // namespace lancer
