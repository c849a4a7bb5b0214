// [[include]]: other scene files as parts of a TOML scene.
#include <glm/geometric.hpp>

#include "gltf_file.h"
#include "rendered.h"

namespace lancer {
namespace {

using namespace lancer::testing;

constexpr const char* room = R"(
[camera.door]
position = [0, 1, 4]
[camera.window]
position = [4, 1, 0]
direction = [-1, 0, 0]
[render]
size = [64, 32]
spp = 3
[background]
color = [0.5, 0.25, 0.125]
[[light]]
name = "lamp"
type = "point"
position = [1, 2, 3]
power = [4, 4, 4]
[[light]]
name = "sun"
type = "directional"
direction = [0, -1, 0]
power = [1, 1, 1]
[material.gold]
type = "conductor"
metal = "gold"
[material.chalk]
type = "diffuse"
[[sphere]]
material = "gold"
[[group]]
name = "pair"
[[group.sphere]]
radius = 0.25
material = "chalk"
[[place]]
group = "pair"
translate = [2, 0, 0]
)";

TEST(Include, AloneIsTheSceneItself) {
    const TemporaryFolder folder;
    folder.write("room.toml", room);
    const Reading whole = read_path(folder / "room.toml");
    const Reading included = read_path(folder.write("main.toml", "[[include]]\nfile = 'room.toml'\n"));
    ASSERT_TRUE(whole.scene && included.scene) << included.all();
    EXPECT_EQ(included.messages, std::vector<std::string>{});
    EXPECT_EQ(included.scene->cameras.front().name, "door");
    EXPECT_TRUE(same_pixels(film_of(*whole.scene, 16, 12, 4), film_of(*included.scene, 16, 12, 4)));
}

TEST(Include, IsPlacedWithItsLightsAndCameras) {
    const TemporaryFolder folder;
    folder.write("room.toml", room);
    const Reading reading = read_path(folder.write("main.toml", R"(
[[include]]
file = "room.toml"
scale = 2
rotate = [0, 90, 0]
translate = [10, 0, 0]
)"));
    ASSERT_TRUE(reading.scene) << reading.all();
    const auto& lamp = std::get<scene::PointLight>(reading.scene->lights.at(0).model);
    EXPECT_LT(glm::distance(lamp.position, glm::dvec3(16.0, 4.0, -2.0)), 1e-12);
    const scene::Camera& window = reading.scene->cameras.at(1);
    EXPECT_LT(glm::distance(window.position, glm::dvec3(10.0, 2.0, -8.0)), 1e-12);
    EXPECT_LT(glm::distance(window.direction, glm::dvec3(0.0, 0.0, 1.0)), 1e-12);
    EXPECT_NEAR(window.focus_distance, 10.0, 1e-12);
}

TEST(Include, WhatTheFileNamesItselfIsMeant) {
    const TemporaryFolder folder;
    folder.write("room.toml", room);
    const Reading reading = read_path(folder.write("main.toml", R"(
[camera.door]
position = [9, 9, 9]
[render]
spp = 7
[background]
color = [1, 1, 1]
[[light]]
name = "lamp"
type = "point"
position = [0, 0, 0]
power = [9, 9, 9]
[material.gold]
type = "conductor"
metal = "silver"
[[include]]
file = "room.toml"
[[sphere]]
material = "chalk"
)"));
    ASSERT_TRUE(reading.scene) << reading.all();
    const scene::Scene& scene = *reading.scene;
    EXPECT_EQ(scene.cameras.size(), 2u);
    EXPECT_EQ(scene.cameras[0].position, glm::dvec3(9.0));
    EXPECT_EQ(scene.settings.spp, 7);
    EXPECT_EQ(scene.settings.width, 64);
    EXPECT_EQ(scene.background.zenith.rgb, scene::Rgb(1.0));
    ASSERT_EQ(scene.lights.size(), 2u);
    EXPECT_EQ(scene.lights[0].power->rgb, scene::Rgb(9.0));
    const scene::Object& ball = scene.groups.back().objects.at(0);
    EXPECT_EQ(std::get<scene::ConductorMaterial>(scene.materials[static_cast<std::size_t>(ball.material)].model).metal, "silver");
    EXPECT_EQ(scene.materials[static_cast<std::size_t>(scene.objects.at(0).material)].name, "chalk");
}

TEST(Include, WithANameIsAGroup) {
    const TemporaryFolder folder;
    folder.write("room.toml", room);
    const Reading reading = read_path(folder.write("main.toml", R"(
[[include]]
file = "room.toml"
name = "room"
[[light]]
type = "point"
position = [0, 5, 0]
[[group]]
name = "two rooms"
[[group.place]]
group = "room"
[[group.place]]
group = "room"
translate = [5, 0, 0]
material = "chalk"
[[place]]
group = "two rooms"
)"));
    ASSERT_TRUE(reading.scene) << reading.all();
    EXPECT_EQ(reading.scene->lights.size(), 1u);
    EXPECT_EQ(reading.scene->groups.size(), 3u);
    EXPECT_EQ(reading.scene->groups.back().placements.at(1).group, 1);
}

TEST(Include, AnyFormat) {
    const TemporaryFolder folder;
    GltfFile file;
    file.triangle();
    folder.write("a.gltf", file.text());
    folder.write("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n");
    folder.write("a.mtl", "newmtl red\nKd 1 0 0\n");
    folder.write("a.ply",
                 "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                 "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    folder.write("a.pbrt", "WorldBegin\nLightSource \"point\"\nShape \"sphere\"\n");
    folder.write("a.xml", "<scene version='3.0.0'><shape type='sphere'/><emitter type='point'/></scene>");
    const Reading reading = read_path(folder.write("main.toml", R"(
[[include]]
file = "a.gltf"
[[include]]
file = "a.obj"
[[include]]
file = "a.ply"
[[include]]
file = "a.pbrt"
[[include]]
file = "a.xml"
)"));
    ASSERT_TRUE(reading.scene) << reading.all();
    EXPECT_EQ(reading.scene->placements.size(), 5u);
    EXPECT_EQ(reading.scene->lights.size(), 2u);
    EXPECT_EQ(reading.scene->settings.integrator, "auto");  // glTF, the first, says nothing of it
    EXPECT_TRUE(
        std::any_of(reading.scene->materials.begin(), reading.scene->materials.end(), [](const auto& m) { return m.name == "red"; }));
}

TEST(Include, ErrorsStandWhereTheFileIsNamed) {
    const TemporaryFolder folder;
    const std::string main = folder.write("main.toml", "[[include]]\nfile = 'gone.gltf'\n[[sphere]]\n");
    EXPECT_NE(read_path(main).all().find("main.toml:2:8: error"), std::string::npos) << read_path(main).all();
    EXPECT_FALSE(read_path(main).scene);
    folder.write("a.blend", "BLENDER");
    const std::string odd = folder.write("odd.toml", "[[include]]\nfile = 'a.blend'\n[[sphere]]\n");
    EXPECT_NE(read_path(odd).all().find("odd.toml:2:8: error: cannot tell what"), std::string::npos) << read_path(odd).all();
}

TEST(Include, CirclesAreRefused) {
    const TemporaryFolder folder;
    folder.write("a.toml", "[[include]]\nfile = 'b.toml'\n");
    folder.write("b.toml", "[[include]]\nfile = './a.toml'\n");
    const Reading reading = read_path(folder / "a.toml");
    EXPECT_FALSE(reading.scene);
    EXPECT_NE(reading.all().find("includes itself"), std::string::npos) << reading.all();
}

// Ten files of ten includes each are 10^10 scenes.
TEST(Include, ABillionLaughsAreRefused) {
    const TemporaryFolder folder;
    for (int level = 0; level < 10; ++level) {
        std::string text;
        for (int i = 0; i < 10; ++i) {
            text += "[[include]]\nfile = 'level" + std::to_string(level + 1) + ".toml'\n";
        }
        folder.write("level" + std::to_string(level) + ".toml", text);
    }
    folder.write("level10.toml", "[[sphere]]\n");
    const Reading reading = read_path(folder / "level0.toml");
    EXPECT_FALSE(reading.scene);
    EXPECT_NE(reading.all().find("more than 1000 scenes"), std::string::npos) << reading.all();
}

TEST(Include, DeepChainsAreRefused) {
    const TemporaryFolder folder;
    for (int level = 0; level < 40; ++level) {
        folder.write("level" + std::to_string(level) + ".toml", "[[include]]\nfile = 'level" + std::to_string(level + 1) + ".toml'\n");
    }
    const Reading reading = read_path(folder / "level0.toml");
    EXPECT_NE(reading.all().find("more than 16 deep"), std::string::npos) << reading.all();
}

TEST(Include, SandboxHoldsForFilesOfFiles) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "inner");
    folder.write("secret.ply", "ply\n");
    folder.write("inner/part.toml", "[[mesh]]\nfile = '../secret.ply'\n");
    folder.write("inner/main.toml", "[[include]]\nfile = 'part.toml'\n");
    folder.write("inner/up.toml", "[[include]]\nfile = '../secret.ply'\n");
    ImportOptions options;
    options.sandbox = true;
    for (const char* name : {"inner/main.toml", "inner/up.toml"}) {
        Diagnostics diagnostics;
        ImportReport report;
        EXPECT_FALSE(import_scene(folder / name, options, report, diagnostics));
        ASSERT_FALSE(diagnostics.list().empty());
        EXPECT_NE(diagnostics.list().front().message.find("outside the scene's folder"), std::string::npos)
            << to_string(diagnostics.list().front());
    }
}

}  // namespace
}  // namespace lancer
