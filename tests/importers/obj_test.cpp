#include "lancer/import/obj/obj.h"

#include <glm/geometric.hpp>

#include "reading.h"

namespace lancer {
namespace {

using namespace lancer::testing;

struct MeshReading {
    std::optional<scene::TriangleMesh> mesh;
    std::string messages;
};

MeshReading read(std::string_view text) {
    Diagnostics diagnostics;
    MeshReading reading{read_obj(text, "m.obj", diagnostics), {}};
    for (const Diagnostic& diagnostic : diagnostics.list()) {
        reading.messages += to_string(diagnostic) + "\n";
    }
    return reading;
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

double area(const scene::TriangleMesh& mesh) {
    double sum = 0.0;
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
        sum += 0.5 * glm::cross(b - a, c - a).z;  // counter-clockwise ones count, clockwise ones are taken off
    }
    return sum;
}

TEST(Obj, ReadsColors) {
    Diagnostics diagnostics;
    const auto mesh = read_obj("v 0 0 0 1 0.5 0\nv 1 0 0\nv 0 1 0 1.0 0 0 1\nvt 0 0\nf 1/1 2/1 3/1\n", "m.obj", diagnostics);
    ASSERT_TRUE(mesh);
    ASSERT_EQ(mesh->colors.size(), 3u);
    EXPECT_NEAR(mesh->colors[0].y, 0.21404114f, 1e-6f) << "they are sRGB";
    EXPECT_EQ(mesh->colors[1], glm::vec4(1.0f)) << "white where there is none";
    EXPECT_EQ(mesh->colors[2], glm::vec4(0.0f, 0.0f, 1.0f, 1.0f)) << "after a weight";
}

TEST(Obj, ReadsPositionsOnly) {
    const MeshReading r = read(square + "f 1 2 3 4\n");
    ASSERT_TRUE(r.mesh) << r.messages;
    EXPECT_EQ(r.mesh->positions.size(), 4u);
    EXPECT_EQ(r.mesh->triangles, (std::vector<glm::uvec3>{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_TRUE(r.mesh->normals.empty());
    EXPECT_TRUE(r.mesh->uvs.empty());
    EXPECT_EQ(r.messages, "");
}

TEST(Obj, WeldsEqualCorners) {
    const MeshReading r = read(square + "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 2\nf 1/1/1 2/2/1 3/3/1\nf 1/1/1 3/3/1 4/4/1\n");
    ASSERT_TRUE(r.mesh) << r.messages;
    EXPECT_EQ(r.mesh->positions.size(), 4u);
    EXPECT_EQ(r.mesh->uvs.at(2), glm::vec2(1, 1));
    EXPECT_EQ(r.mesh->normals.at(0), glm::vec3(0, 0, 1)) << "of length 1";
    EXPECT_EQ(r.mesh->triangles.at(1), glm::uvec3(0, 2, 3));
}

TEST(Obj, SplitsVerticesThatDifferInUv) {
    const MeshReading r = read(square + "vt 0 0\nvt 1 0\nvt 1 1\nvt 0.5 0.5\nf 1/1 2/2 3/3\nf 1/4 3/3 4/2\n");
    ASSERT_TRUE(r.mesh) << r.messages;
    EXPECT_EQ(r.mesh->positions.size(), 5u);
    EXPECT_EQ(r.mesh->positions[r.mesh->triangles[1].x], glm::vec3(0, 0, 0));
    EXPECT_EQ(r.mesh->uvs[r.mesh->triangles[1].x], glm::vec2(0.5, 0.5));
}

TEST(Obj, WeldsAMillionCornersOfOneVertexQuickly) {
    std::string text = square;
    for (int i = 1; i <= 20'000; ++i) {
        text += "vt " + std::to_string(i) + " 0\nf 1/" + std::to_string(i) + " 2/1 3/1\n";
    }
    const MeshReading r = read(text);
    ASSERT_TRUE(r.mesh) << r.messages;
    EXPECT_EQ(r.mesh->positions.size(), 20'002u);
}

TEST(Obj, CountsBackwardsAndForwards) {
    EXPECT_EQ(read(square + "f -4 -3 -2\n").mesh.value().triangles.at(0), glm::uvec3(0, 1, 2));
    // Vertices that come after the face that names them.
    EXPECT_EQ(read("f 1 2 3\n" + square).mesh.value().triangles.at(0), glm::uvec3(0, 1, 2));
}

TEST(Obj, ReadsEveryFormOfCorner) {
    const std::string lists = square + "vt 0 0\nvn 0 0 1\n";
    for (const char* face :
         {"f 1 2 3", "f 1/1 2/1 3/1", "f 1//1 2//1 3//1", "f 1/1/1 2/1/1 3/1/1", "f 1/ 2/ 3/", "f 1// 2// 3//", "f 1/1/ 2/1/ 3/1/"}) {
        const MeshReading r = read(lists + face);
        ASSERT_TRUE(r.mesh) << face << "\n" << r.messages;
        EXPECT_EQ(r.mesh->triangles.size(), 1u) << face;
    }
}

TEST(Obj, GivesMissingNormalsThatOfTheFace) {
    const MeshReading r = read(square + "v 0 0 1\nvn 1 0 0\nf 1//1 2//1 3//1\nf 1 2 5\n");
    ASSERT_TRUE(r.mesh) << r.messages;
    const glm::uvec3& second = r.mesh->triangles.at(1);
    EXPECT_EQ(r.mesh->normals.at(second.x), glm::vec3(0, -1, 0));
    EXPECT_EQ(r.mesh->normals.at(r.mesh->triangles[0].x), glm::vec3(1, 0, 0));
}

TEST(Obj, CutsConcavePolygons) {
    // An arrowhead whose first diagonal lies outside; an L of six corners; a comb.
    const MeshReading arrow = read("v 0 0 0\nv 2 1 0\nv 0 2 0\nv 1 1 0\nf 2 3 4 1\nf 3 4 1 2\n");
    ASSERT_TRUE(arrow.mesh) << arrow.messages;
    EXPECT_NEAR(area(*arrow.mesh), 2.0, 1e-12);
    for (const glm::uvec3& t : arrow.mesh->triangles) {
        EXPECT_GT(area({arrow.mesh->positions, {}, {}, {t}}), 0.0) << "every triangle faces the same way";
    }
    const MeshReading l = read("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf 5 6 1 2 3 4\n");
    ASSERT_TRUE(l.mesh) << l.messages;
    EXPECT_NEAR(area(*l.mesh), 3.0, 1e-12);
    EXPECT_EQ(l.mesh->triangles.size(), 4u);
    std::string comb;
    std::string face = "f";
    for (int i = 0; i < 20; ++i) {
        comb += "v " + std::to_string(i) + " " + (i % 2 ? "1" : "3") + " 0\n";
        face += " " + std::to_string(20 - i);
    }
    comb += "v 0 0 0\nv 19 0 0\n";
    const MeshReading c = read(comb + face + " 21 22\n");
    ASSERT_TRUE(c.mesh) << c.messages;
    EXPECT_NEAR(area(*c.mesh), 38.0, 1e-9);
    for (const glm::uvec3& t : c.mesh->triangles) {
        EXPECT_GT(area({c.mesh->positions, {}, {}, {t}}), 0.0);
    }
}

TEST(Obj, TakesUnusualText) {
    for (const std::string& text : {
             std::string("v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n"),              // Windows
             std::string("v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3"),                        // old Macintosh, no end of line at the end
             std::string("\xef\xbb\xbfv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3"),            // byte order mark
             std::string("v\t0  0 0 \n  v +1 .0 0.e0\nv 0 1e0 -0\nf 1 2 3 # end\n"),   // blanks and forms of numbers
             std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 \\\n 2 \\\r\n3\n"),           // joined lines
             std::string("# C:\\folder\\\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),      // a comment is not joined
             std::string("v 0 0 0 1\nv 1 0 0 1 0 0\nv 0 1 0 0.5 0.5 0.5\nf 1 2 3\n"),  // weights and colours
             std::string("v 1e-400 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),                 // too small for a number
             std::string("mtllib a b.mtl\no x\ng y z\ns off\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
         }) {
        const MeshReading r = read(text);
        ASSERT_TRUE(r.mesh) << text << r.messages;
        EXPECT_EQ(r.mesh->triangles.size(), 1u) << text;
        EXPECT_EQ(r.mesh->positions.at(1), glm::vec3(1, 0, 0)) << text;
        EXPECT_EQ(r.messages, "") << text;
    }
}

TEST(Obj, TellsWhatItLeavesOut) {
    const MeshReading r = read(square + "usemtl red\nl 1 2\np 1\nf 1 2 3\nf 1 1 2\nf 1 2\ncurv 0 1 2\n");
    ASSERT_TRUE(r.mesh);
    EXPECT_EQ(r.messages,
              "m.obj:10:1: warning: a face needs three corners, not 2; left out\n"
              "m.obj:11:1: warning: unknown statement \"curv\"; left out\n"
              "m.obj: note: 2 statements for lines and points are left out\n"
              "m.obj: note: materials (usemtl) are left out; the mesh has the material that the scene gives it\n"
              "m.obj: warning: 1 of 2 triangles have no area and are left out\n");
}

TEST(Obj, RepairsNormalsWithoutDirection) {
    const MeshReading r = read(square + "vn 0 0 0\nf 1//1 2//1 3//1\n");
    ASSERT_TRUE(r.mesh);
    EXPECT_EQ(r.mesh->normals.at(0), glm::vec3(0, 0, 1));
    EXPECT_EQ(r.messages, "m.obj: warning: 3 of 3 normals have no direction; the mean of the faces around is used\n");
}

TEST(Obj, ExplainsMistakes) {
    const struct {
        std::string text, message;
    } mistakes[] = {
        {"", "m.obj: error: this mesh has no triangles\n"},
        {square, "m.obj: error: this mesh has no triangles\n"},
        {"v 0 zero 0\n", "m.obj:1:5: error: a vertex needs finite numbers, not \"zero\"\n"},
        {"v 0 0 1x\n", "m.obj:1:7: error: a vertex needs finite numbers, not \"1x\"\n"},
        {"v nan 0 0\n", "m.obj:1:3: error: a vertex needs finite numbers, not \"nan\"\n"},
        {"v 0 1e99 0\n", "m.obj:1:5: error: a vertex needs finite numbers, not \"1e99\"\n"},
        {"v 0 1e999 0\n", "m.obj:1:5: error: a vertex needs finite numbers, not \"1e999\"\n"},
        {"v 1 2\n", "m.obj:1:6: error: a vertex needs 3 numbers, but the line ends after 2\n"},
        {"vn 1 2\n", "m.obj:1:7: error: a normal needs 3 numbers, but the line ends after 2\n"},
        {"vt\n", "m.obj:1:3: error: a texture coordinate needs 1 numbers, but the line ends after 0\n"},
        {square + "f 1 2 5\n", "m.obj:5:7: error: there is no vertex 5: the file has 4\n"},
        {square + "f 0 1 2\n", "m.obj:5:3: error: there is no vertex 0: they are counted from 1\n"},
        {square + "f 1 2 -5\n", "m.obj:5:7: error: there is no vertex -5: 4 came before\n"},
        {square + "f 1 2 99999999999\n", "m.obj:5:7: error: there is no vertex 99999999999: 4 came before\n"},
        {square + "f 1/1 2/1 3/1\n",
         "m.obj:5:5: error: there is no texture coordinate 1: the file has 0\n"
         "m.obj:5:9: error: there is no texture coordinate 1: the file has 0\n"
         "m.obj:5:13: error: there is no texture coordinate 1: the file has 0\n"},
        {square + "f 1 2 3//1\n", "m.obj:5:10: error: there is no normal 1: the file has 0\n"},
        {square + "f 1 2 x\n", "m.obj:5:7: error: the number of a vertex is missing here, found \"x\"\n"},
        {square + "f 1 2 3x\n",
         "m.obj:5:7: error: a corner is written as vertex, vertex/uv, vertex//normal or vertex/uv/normal, not \"3x\"\n"},
        {square + "f 1 2 3/1/1/1\nvt 0 0\nvn 0 0 1\n",
         "m.obj:5:7: error: a corner is written as vertex, vertex/uv, vertex//normal or vertex/uv/normal, not \"3/1/1/1\"\n"},
        {"v 1e20 0 0\nv 0 0 0\nv 0 1 0\nf 1 2 3\n",
         "m.obj: error: vertex 0 at (1e+20, 0, 0) is out of reach: coordinates must be finite and at most 1e+15 m\n"},
        {std::string("\xff\xfev\0", 4), "m.obj:1:1: error: this is UTF-16 text; save the file as UTF-8\n"},
    };
    for (const auto& mistake : mistakes) {
        const MeshReading r = read(mistake.text);
        EXPECT_FALSE(r.mesh) << mistake.text;
        EXPECT_EQ(r.messages, mistake.message) << mistake.text;
    }
}

TEST(Obj, StopsAfterManyMistakes) {
    std::string text;
    for (int i = 0; i < 1000; ++i) {
        text += "v a b c\n";
    }
    const MeshReading r = read(text);
    EXPECT_FALSE(r.mesh);
    EXPECT_EQ(std::count(r.messages.begin(), r.messages.end(), '\n'), 21);
}

TEST(Obj, AloneMakesAWholeScene) {
    const TemporaryFolder folder;
    const Reading reading = read_path(folder.write("m.OBJ", square + "f 1 2 3 4\n"));
    ASSERT_TRUE(reading.scene) << reading.all();
    EXPECT_EQ(reading.scene->objects.size(), 1u);
    EXPECT_EQ(reading.scene->cameras.size(), 1u);
    EXPECT_FALSE(reading.scene->lights.empty());
    double sum = 0.0;
    for (const scene::Light& light : reading.scene->lights) {
        sum += light.intensity;
    }
    EXPECT_DOUBLE_EQ(sum, 1.0);
}

}  // namespace
}  // namespace lancer
