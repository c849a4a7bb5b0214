#include <glm/geometric.hpp>

#include "reading.h"

namespace lancer {
namespace {

using namespace lancer::testing;

Reading read_pbrt_text(const std::string& text) {
    const TemporaryFolder folder;
    return read_path(folder.write("scene.pbrt", text));
}

const std::string lit = "LightSource \"point\" \"rgb I\" [1 1 1]\n";

TEST(Pbrt, ReadsATriangleWithItsCameraAndSettings) {
    const Reading r = read_pbrt_text(
        "LookAt 0 0 5  0 0 0  0 1 0 # from +z\n"
        "Camera \"perspective\" \"float fov\" 40\n"
        "Film \"rgb\" \"integer xresolution\" 200 \"integer yresolution\" [ 100 ]\n"
        "Sampler \"halton\" \"integer pixelsamples\" 8\n"
        "Integrator \"path\" \"integer maxdepth\" 3\n"
        "WorldBegin\n" +
        lit + "Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0] \"integer indices\" [0 1 2]\n");
    ASSERT_TRUE(r.scene) << r.all();
    EXPECT_EQ(r.all(), "");
    EXPECT_EQ(r.scene->settings.width, 200);
    EXPECT_EQ(r.scene->settings.spp, 8);
    EXPECT_EQ(r.scene->settings.bounces, 3);
    const scene::Camera& camera = r.scene->cameras.at(0);
    EXPECT_NEAR(glm::distance(camera.position, glm::dvec3(0, 0, 5)), 0.0, 1e-12);
    EXPECT_NEAR(glm::distance(camera.direction, glm::dvec3(0, 0, -1)), 0.0, 1e-12);
    EXPECT_NEAR(camera.fov, 40.0, 1e-9);
    EXPECT_EQ(camera.fov_axis, scene::FovAxis::height) << "the shorter side";
    ASSERT_EQ(r.scene->objects.size(), 1u);
    EXPECT_EQ(std::get<scene::Mesh>(r.scene->objects[0].shape).data->triangles.at(0), glm::uvec3(0, 1, 2));
}

TEST(Pbrt, SaysWhereNumbersAreWrong) {
    const Reading r = read_pbrt_text("WorldBegin\nShape \"sphere\"\n  \"float radius\" [ 1.2.3 ]\n");
    ASSERT_FALSE(r.scene);
    EXPECT_NE(r.all().find("scene.pbrt:3:20: error: Shape \"sphere\": \"radius\" needs numbers, found 1.2.3"), std::string::npos)
        << r.all();
}

TEST(Pbrt, AFileMayNotIncludeItself) {
    const TemporaryFolder folder;
    folder.write("b.pbrt", "Include \"a.pbrt\"\n");
    const Reading r = read_path(folder.write("a.pbrt", "WorldBegin\nInclude \"b.pbrt\"\n"));
    ASSERT_FALSE(r.scene);
    EXPECT_NE(r.all().find("includes itself"), std::string::npos) << r.all();
}

TEST(Pbrt, NormalsSayWhichSideShines) {
    const Reading r = read_pbrt_text(
        "WorldBegin\nAreaLightSource \"diffuse\" \"rgb L\" [2 2 2] \"float scale\" 3\n"
        "Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0] \"normal N\" [0 0 -1 0 0 -1 0 0 -1]\n"
        "ReverseOrientation\nShape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0]\n");
    ASSERT_TRUE(r.scene) << r.all();
    const scene::Object& first = r.scene->objects.at(0);
    EXPECT_EQ(std::get<scene::Mesh>(first.shape).data->triangles.at(0), glm::uvec3(0, 2, 1));
    EXPECT_EQ(r.scene->materials.at(static_cast<std::size_t>(first.material)).emission.value().strength, 3.0);
    EXPECT_EQ(std::get<scene::Mesh>(r.scene->objects.at(1).shape).data->triangles.at(0), glm::uvec3(0, 2, 1));
}

}  // namespace
}  // namespace lancer
