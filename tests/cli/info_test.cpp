// lancer info and import: what is in a file, and what is odd about it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "lancer/image/image.h"

namespace lancer::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const std::string view = "[camera]\nposition = [0, 0, 9]\n[[light]]\ntype = \"point\"\nposition = [0, 8, 2]\n";  // lines 1 to 5

struct Odd {
    std::string name;
    std::string text;
    std::string said;  // empty: nothing is odd
};

class Oddities : public testing::TestWithParam<Odd> {};

TEST_P(Oddities, AreToldWithTheirPlace) {
    const Folder folder;
    folder.write("scene.toml", GetParam().text);
    const Finished finished = run_lancer(folder, {"info", "scene.toml"});
    EXPECT_EQ(finished.status, 0) << finished.err;
    if (GetParam().said.empty()) {
        EXPECT_THAT(finished.err, IsEmpty());
    } else {
        EXPECT_THAT(finished.err, HasSubstr(GetParam().said));
    }
}

// A tetrahedron with one corner at the origin; with its faces turned round it points inwards.
std::string tetrahedron(const std::string& triangles, const std::string& material) {
    return view + "[[mesh]]\nname = \"tetra\"\npositions = [[0,0,0],[1,0,0],[0,1,0],[0,0,1]]\ntriangles = " + triangles +
           "\nmaterial = { type = \"" + material + "\" }\n";
}

INSTANTIATE_TEST_SUITE_P(
    Of, Oddities,
    testing::Values(
        Odd{"nothing", view + "[[sphere]]\n", ""}, Odd{"outwards", tetrahedron("[[0,2,1],[0,1,3],[0,3,2],[1,2,3]]", "whitted"), ""},
        Odd{"inwards", tetrahedron("[[0,1,2],[0,3,1],[0,2,3],[1,3,2]]", "whitted"),
            "scene.toml:6:1: warning: the faces of \"tetra\" point inwards"},
        Odd{"open_is_fine_when_opaque", tetrahedron("[[0,2,1],[0,1,3]]", "whitted"), ""},
        Odd{"open_glass", tetrahedron("[[0,2,1],[0,1,3]]", "whitted\", transparency = 0.9, refraction = \"N-BK7"),
            "\"tetra\" is a clear body with holes"},
        Odd{"camera_inside", view + "[[box]]\nmin = [-1, -1, 8]\nmax = [1, 1, 10]\n",
            "scene.toml:1:1: warning: camera without a name is inside"},
        Odd{"camera_in_a_lit_room", view + "[[box]]\nmin = [-10, -10, -10]\nmax = [10, 10, 10]\n", ""},
        Odd{"light_inside", view + "[[sphere]]\ncenter = [0, 8, 2]\n", "scene.toml:3:1: warning: light without a name is shut in"},
        Odd{"missing_picture", view + "[[sphere]]\nmaterial = { color = { type = \"image\", file = \"gone.png\" } }\n",
            "scene.toml:7:47: warning: cannot read \"gone.png\""},
        Odd{"no_power", view + "[[light]]\nname = \"off\"\ntype = \"directional\"\ndirection = [0, -1, 0]\nintensity = 0\n[[sphere]]\n",
            "scene.toml:6:1: warning: light \"off\" gives no light"},
        Odd{"lamp_without_strength",
            view + "power = [9, 9, 9]\n[[sphere]]\nmaterial = { type = \"diffuse\", emission = [1, 1, 1], emission_strength = 0 }\n",
            "shines with a strength of 0"},
        Odd{"millimetres", view + "[[sphere]]\ncenter = [0, 0, -5000]\nradius = 2000\n", "were millimetres taken for metres?"}),
    [](const auto& odd) { return odd.param.name; });

TEST(Info, OfAFileWithTooBrightAColor) {
    const Folder folder;
    folder.write("scene.xml",
                 "<scene version='3.0.0'><sensor type='perspective'/><shape type='sphere'><bsdf type='diffuse'>"
                 "<rgb name='reflectance' value='1.5, 1, 1'/></bsdf></shape><emitter type='constant'/></scene>");
    const Finished finished = run_lancer(folder, {"info", "scene.xml"});
    EXPECT_EQ(finished.status, 0) << finished.err;
    EXPECT_THAT(finished.err, HasSubstr("warning"));
}

TEST(Info, OfAnAnimation) {
    const Folder folder;
    folder.write("scene.gltf", R"({"asset": {"version": "2.0"}, "nodes": [{"mesh": 0, "name": "flag"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "buffers": [{"byteLength": 68, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAIEAAAAAAAAAAAAAAAAAAAIA/AAAAAAAAAAA="}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 8}, {"buffer": 0, "byteOffset": 44, "byteLength": 24}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
                      {"bufferView": 1, "componentType": 5126, "count": 2, "type": "SCALAR", "min": [0], "max": [2.5]},
                      {"bufferView": 2, "componentType": 5126, "count": 2, "type": "VEC3"}],
        "animations": [{"name": "wave", "samplers": [{"input": 1, "output": 2}], "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]}]})");
    const Finished finished = run_lancer(folder, {"info", "scene.gltf"});
    EXPECT_EQ(finished.status, 0) << finished.err;
    EXPECT_THAT(finished.out, HasSubstr("wave (2.5 s, 1 channel)"));
    EXPECT_THAT(finished.err, HasSubstr("there is no camera: one that sees everything is used"));
    EXPECT_THAT(finished.err, HasSubstr("there is no light: neutral surroundings"));
    const nlohmann::json json = nlohmann::json::parse(run_lancer(folder, {"info", "scene.gltf", "--json"}).out);
    EXPECT_EQ(json["animations"][0]["name"], "wave");
}

TEST(Info, OfAPicture) {
    const Folder folder;
    Image image{2, 1, 3, {0.0f, 0.5f, 1.0f, 4.0f, 0.25f, 1.0f}};
    write_image(folder.file("picture.exr"), image, {{"lancer:scene", "x.toml"}});
    const Finished text = run_lancer(folder, {"info", "picture.exr"});
    EXPECT_EQ(text.status, 0) << text.err;
    EXPECT_THAT(text.out, HasSubstr("2 x 1"));
    EXPECT_THAT(text.out, HasSubstr("0 to 4, mean 2"));
    EXPECT_THAT(text.out, HasSubstr("x.toml"));
    const nlohmann::json json = nlohmann::json::parse(run_lancer(folder, {"info", "picture.exr", "--json"}).out);
    EXPECT_EQ(json["width"], 2);
    EXPECT_EQ(json["channels"].size(), 3u);
}

TEST(Info, OfWhatIsNoPictureSaysSo) {
    const Folder folder;
    folder.write("picture.exr", "nothing of the kind");
    const Finished finished = run_lancer(folder, {"info", "picture.exr"});
    EXPECT_EQ(finished.status, 2);
    EXPECT_THAT(finished.err, HasSubstr("picture.exr"));
}

TEST(Convert, WritesTheSceneAndWhatLiesBesideIt) {
    const Folder folder;
    folder.write("scene.obj", "mtllib scene.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n");
    folder.write("scene.mtl", "newmtl red\nKd 1 0 0\n");
    const Finished done = run_lancer(folder, {"convert", "scene.obj", "-o", "new.toml"});
    EXPECT_EQ(done.status, 0) << done.err;
    EXPECT_THAT(done.out, HasSubstr("new.meshes"));
    EXPECT_EQ(run_lancer(folder, {"render", "scene.obj", "-o", "a.exr", "--size", "16x9", "--spp", "2"}).status, 0);
    EXPECT_EQ(run_lancer(folder, {"render", "new.toml", "-o", "b.exr", "--size", "16x9", "--spp", "2"}).status, 0);
    const Finished same = run_lancer(folder, {"compare", "a.exr", "b.exr", "--exact"});
    EXPECT_EQ(same.status, 0) << same.out << same.err;
}

TEST(Convert, SaysWhatIsWrong) {
    const Folder folder;
    folder.write("scene.toml", view + "[[sphere]]\n");
    EXPECT_THAT(run_lancer(folder, {"convert", "scene.toml"}).err, HasSubstr("where shall it go?"));
    EXPECT_THAT(run_lancer(folder, {"convert", "scene.toml", "-o", "scene.toml"}).err, HasSubstr("this is the scene itself"));
    EXPECT_THAT(run_lancer(folder, {"convert", "scene.toml", "-o", "scene.gltf"}).err, HasSubstr(".toml file"));
    const Finished none = run_lancer(folder, {"convert", "none.toml", "-o", "new.toml"});
    EXPECT_EQ(none.status, 2);
    EXPECT_THAT(none.err, HasSubstr("no such file"));
}

TEST(Import, TellsWhetherAFileCanBeRead) {
    const Folder folder;
    folder.write("scene.toml", view + "[[sphere]]\n");
    const Finished good = run_lancer(folder, {"import", "scene.toml"});
    EXPECT_EQ(good.status, 0);
    EXPECT_THAT(good.out, HasSubstr("scene.toml can be read"));
    const Finished none = run_lancer(folder, {"import", "none.toml", "--json"});
    EXPECT_EQ(none.status, 2);
    EXPECT_THAT(nlohmann::json::parse(none.out)["messages"][0].get<std::string>(), HasSubstr("no such file"));
    const Finished define = run_lancer(folder, {"import", "scene.toml", "-D", "nothing"});
    EXPECT_EQ(define.status, 2);
    EXPECT_THAT(define.err, HasSubstr("expected NAME=VALUE"));
}

}  // namespace
}  // namespace lancer::test
