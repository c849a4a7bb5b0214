// Scenes that can't be rendered: where and what is said, and that an older picture survives.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/program.h"

namespace lancer::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const std::string camera_and_light = "[camera]\nposition = [0, 1, 5]\n[[light]]\ntype = \"point\"\nposition = [1, 5, 2]\n";  // lines 1 to 5
const std::string sphere = "[[sphere]]\nradius = 1\n";

struct BadScene {
    std::string name;
    std::string text;
    std::vector<std::string> said;
};

class BadScenes : public testing::TestWithParam<BadScene> {};

TEST_P(BadScenes, AreRefusedWithTheirPlace) {
    const Folder folder;
    folder.write("scene.toml", GetParam().text);
    folder.write("picture.png", "precious");
    const Finished finished = run_lancer(folder, {"render", "scene.toml", "-o", "picture.png"});
    EXPECT_EQ(finished.status, 2) << finished.err;
    for (const std::string& words : GetParam().said) {
        EXPECT_THAT(finished.err, HasSubstr(words));
    }
    EXPECT_THAT(finished.out, IsEmpty());
    EXPECT_THAT(folder.names(), ElementsAre("picture.png", "scene.toml"));
    EXPECT_TRUE(folder.read("picture.png") == "precious");
}

std::string deep_groups(int depth) {
    std::string text = camera_and_light;
    for (int i = 0; i < depth; ++i) {
        text += "[[group.group]]\n";
    }
    return text;
}

std::string nested_arrays(int depth) {
    return camera_and_light + "[[sphere]]\ncenter = " + std::string(static_cast<std::size_t>(depth), '[');
}

INSTANTIATE_TEST_SUITE_P(
    Of, BadScenes,
    testing::Values(
        BadScene{"wrong_type", camera_and_light + "[[sphere]]\nradius = \"big\"\n", {"scene.toml:7:", "error", "radius"}},
        BadScene{
            "unknown_key", camera_and_light + "[[sphere]]\nradus = 1\n", {"scene.toml:7:1: error", "radus", "did you mean \"radius\"?"}},
        BadScene{"unknown_table", camera_and_light + "[[spere]]\nradius = 1\n", {"scene.toml:6:", "spere", "did you mean \"sphere\"?"}},
        BadScene{"missing_material",
                 camera_and_light + sphere + "material = \"mirorr\"\n[material.mirror]\n",
                 {"scene.toml:8:", "mirorr", "did you mean \"mirror\"?"}},
        BadScene{"zero_size", "[render]\nsize = [0, 100]\n" + camera_and_light + sphere, {"scene.toml:2:", "size"}},
        BadScene{"zero_radius", camera_and_light + "[[sphere]]\nradius = 0\n", {"scene.toml:7:", "radius"}},
        BadScene{"negative_radius", camera_and_light + "[[sphere]]\nradius = -2.5\n", {"scene.toml:7:", "radius"}},
        BadScene{"min_above_max", camera_and_light + "[[box]]\nmin = [0, 3, 0]\nmax = [1, 2, 1]\n", {"scene.toml:", "min", "max"}},
        BadScene{"not_a_number", camera_and_light + "[[sphere]]\ncenter = [0, nan, 0]\n", {"scene.toml:7:"}},
        BadScene{"infinite", camera_and_light + "[[sphere]]\nradius = inf\n", {"scene.toml:7:", "radius"}},
        BadScene{"deep_groups", deep_groups(100000), {"scene.toml:", "error"}},
        BadScene{"deep_arrays", nested_arrays(100000), {"scene.toml:", "error"}},
        BadScene{"no_shape", camera_and_light, {"scene.toml", "shape"}},
        BadScene{"no_light", "[camera]\nposition = [0, 1, 5]\n" + sphere, {"scene.toml: error: the scene is dark", "[[light]]"}},
        BadScene{"not_toml", "this is not a scene\n", {"scene.toml:1:"}}, BadScene{"unfinished", "[camera\n", {"scene.toml:1:"}},
        BadScene{"missing_mesh", camera_and_light + "[[mesh]]\nfile = \"none.obj\"\n", {"scene.toml:7:", "none.obj"}},
        BadScene{"missing_image",
                 camera_and_light + sphere + "material = { color = { type = \"image\", file = \"none.png\" } }\n",
                 {"scene.toml:8:", "none.png"}},
        BadScene{"huge_picture", "[render]\nsize = [65536, 65536]\n" + camera_and_light + sphere, {"scene.toml", "million pixels"}},
        BadScene{"too_many_bounces", "[render]\nbounces = 100000\n" + camera_and_light + sphere, {"scene.toml:2:", "bounces"}}),
    [](const auto& case_) { return case_.param.name; });

TEST(BadScene, AnAmbientOrABackgroundIsLightEnough) {
    const Folder folder;
    const std::string dark = "[camera]\nposition = [0, 1, 5]\n" + sphere;
    for (const std::string light : {"ambient = \"gray\"\n", "background = \"#808080\"\n"}) {
        folder.write("scene.toml", light + dark + "[render]\nsize = [40, 30]\n");
        const Finished finished = run_lancer(folder, {"render", "scene.toml", "-o", "picture.png"});
        EXPECT_EQ(finished.status, 0) << finished.err;
        EXPECT_THAT(finished.err, Not(HasSubstr("warning")));
    }
}

TEST(BadScene, SeveralMistakesAreToldAtOnce) {
    const Folder folder;
    folder.write("scene.toml", camera_and_light + "[[sphere]]\nradius = -1\ncolour = 3\n[[box]]\nmn = [0, 0, 0]\n");
    const Finished finished = run_lancer(folder, {"render", "scene.toml", "-o", "none/picture.png"});
    EXPECT_EQ(finished.status, 2);
    EXPECT_THAT(finished.err, HasSubstr("scene.toml:7:"));
    EXPECT_THAT(finished.err, HasSubstr("scene.toml:8:"));
    EXPECT_THAT(finished.err, HasSubstr("scene.toml:10:"));
    EXPECT_THAT(finished.err, HasSubstr("there is no folder none"));
}

TEST(BadScene, BrokenMeshesAreRefused) {
    const Folder folder;
    folder.write("scene.toml", camera_and_light + "[[mesh]]\nfile = \"mesh.ply\"\n");
    folder.write("mesh.ply", "ply\nformat ascii 1.0\nelement vertex 3\n");
    const Finished finished = run_lancer(folder, {"render", "scene.toml", "-o", "picture.png"});
    EXPECT_EQ(finished.status, 2);
    EXPECT_THAT(finished.err, HasSubstr("mesh.ply"));
    EXPECT_FALSE(folder.has("picture.png"));
}

TEST(BadScene, InfoAndViewRefuseItToo) {
    const Folder folder;
    folder.write("scene.toml", camera_and_light + "[[sphere]]\nradius = 0\n");
    for (const char* subcommand : {"info", "view", "bench"}) {
        const Finished finished = run_lancer(folder, {subcommand, "scene.toml"});
        EXPECT_EQ(finished.status, 2) << subcommand;
        EXPECT_THAT(finished.err, HasSubstr("scene.toml:7:"));
    }
    EXPECT_THAT(folder.names(), ElementsAre("scene.toml"));
}

TEST(BadScene, PhysicalScenesNeedPhysicalMaterialsAndLights) {
    const Folder folder;
    const std::string start = "[render]\nsize = [16, 9]\nspp = 1\n[camera]\nposition = [0, 1, 5]\n";
    const std::string metal = "[[sphere]]\nmaterial = { type = \"conductor\", metal = \"gold\" }\n";
    const std::string light = "[[light]]\ntype = \"point\"\nposition = [1, 5, 2]\n";
    folder.write("scene.toml", start + metal + "[[sphere]]\nmaterial = { color = \"red\" }\n" + light + "power = [9, 9, 9]\n");
    Finished finished = run_lancer(folder, {"render", "scene.toml", "-o", "picture.png"});
    EXPECT_EQ(finished.status, 2);
    EXPECT_THAT(finished.err, HasSubstr("scene.toml:9:12: error: this material is for the whitted integrator"));
    folder.write("scene.toml", start + metal + light);
    finished = run_lancer(folder, {"render", "scene.toml", "-o", "picture.png"});
    EXPECT_EQ(finished.status, 2);
    EXPECT_THAT(finished.err, HasSubstr("scene.toml:8:1: error: for the path integrator a light needs \"power\""));
    EXPECT_FALSE(folder.has("picture.png"));
    // A shape without a material is diffuse.
    folder.write("scene.toml", start + metal + "[[sphere]]\n" + light + "power = [9, 9, 9]\n");
    finished = run_lancer(folder, {"render", "scene.toml", "-o", "picture.png"});
    EXPECT_EQ(finished.status, 0) << finished.err;
    EXPECT_TRUE(folder.has("picture.png"));
}

}  // namespace
}  // namespace lancer::test
