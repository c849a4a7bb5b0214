// Scenes in our notation: what is written is read as the same scene, and makes the same picture.
#include <algorithm>
#include <cctype>

#include "lancer/import/mesh/mesh_file.h"
#include "lancer/scene/bounds.h"
#include "rendered.h"

namespace lancer {
namespace {

using namespace lancer::testing;
namespace fs = std::filesystem;

// Without the first line, which names the file that the scene came from.
std::string body(const WrittenScene& written) { return written.toml.substr(written.toml.find('\n')); }

struct Converted {
    WrittenScene first;
    WrittenScene second;  // from what was read back
    scene::Scene read_back;
    bool opened = false;
};

Converted convert(const scene::Scene& scene, const TemporaryFolder& folder) {
    Converted result;
    const std::string path = folder / "converted.toml";
    result.first = write_toml(scene, path);
    folder.write("converted.toml", result.first.toml);
    if (!result.first.mesh_file.empty()) {
        folder.write(result.first.mesh_file, result.first.meshes);
    }
    for (const WrittenScene::Picture& picture : result.first.pictures) {
        folder.write(picture.name, *picture.bytes);
    }
    const Reading reading = read_path(path);
    EXPECT_TRUE(reading.scene) << reading.all();
    if (reading.scene) {
        result.opened = true;
        result.second = write_toml(*reading.scene, path);
        result.read_back = *reading.scene;
    }
    return result;
}

// Our notation has no scenes without shapes.
bool is_empty(const scene::Scene& scene) { return scene::bounds(scene).empty() && scene.objects.empty(); }

void expect_same(const std::string& path) {
    SCOPED_TRACE(path);
    const Reading original = read_path(path);
    ASSERT_TRUE(original.scene) << original.all();
    if (is_empty(*original.scene)) {
        return;
    }
    const TemporaryFolder folder;
    const Converted converted = convert(*original.scene, folder);
    ASSERT_TRUE(converted.opened);
    EXPECT_EQ(body(converted.first), body(converted.second));
    EXPECT_EQ(converted.first.meshes, converted.second.meshes);
    EXPECT_TRUE(same_pixels(film_of(*original.scene, 24, 16, 2), film_of(converted.read_back, 24, 16, 2)));
}

std::vector<std::string> scenes_below(const fs::path& folder) {
    std::vector<std::string> paths;
    const std::vector<std::string> endings = scene_endings();
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file() && std::find(endings.begin(), endings.end(), entry.path().extension()) != endings.end()) {
            paths.push_back(entry.path().string());
        }
    }
    std::sort(paths.begin(), paths.end());
    return paths;
}

class OwnScenes : public ::testing::TestWithParam<std::string> {};

TEST_P(OwnScenes, ConvertToTheSamePicture) { expect_same((source_folder() / "scenes" / GetParam()).string()); }

// One for each reader and each kind of thing that a scene holds; the rest is label `slow`.
INSTANTIATE_TEST_SUITE_P(Some, OwnScenes,
                         ::testing::Values("gltf/still-life.glb", "mitsuba/still-life.xml", "meshes/still-life.obj",
                                           "features/include.toml", "meshes/gem.obj", "meshes/blob.ply", "features/principled.toml",
                                           "features/mixes.toml", "features/lamps.toml", "features/environment.toml",
                                           "features/groups.toml", "features/texture-options.toml", "features/metals.toml",
                                           "features/masks.toml", "features/depth-of-field.toml", "features/dispersion.toml",
                                           "features/vertex-colors.toml", "features/bumps.toml", "features/light-spot.toml",
                                           "features/metamers.toml", "report/figure-1.toml"),
                         [](const auto& param) {
                             std::string name = fs::path(param.param).stem().string() + fs::path(param.param).extension().string();
                             std::replace_if(
                                 name.begin(), name.end(), [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
                             return name;
                         });

TEST(ConvertSlow, EveryScene) {
    for (const std::string& path : scenes_below(source_folder() / "scenes")) {
        expect_same(path);
    }
}

// Every scene that others made and that opens.
TEST(ConvertSlow, EveryReferenceScene) {
    const fs::path reference = source_folder() / "../../shared/reference";
    if (!fs::exists(reference)) {
        GTEST_SKIP() << "no ../../shared/reference";
    }
    std::size_t count = 0;
    for (const std::string& path : scenes_below(reference)) {
        if (path.find("/malformed/") != std::string::npos || fs::file_size(path) > 4'000'000) {
            continue;
        }
        Reading original = read_path(path);
        if (!original.scene || is_empty(*original.scene)) {
            continue;
        }
        SCOPED_TRACE(path);
        const TemporaryFolder folder;
        const Converted converted = convert(*original.scene, folder);
        EXPECT_EQ(body(converted.first), body(converted.second));
        EXPECT_EQ(converted.first.meshes, converted.second.meshes);
        ++count;
    }
    EXPECT_GT(count, 250u) << "of the scenes that were there when this was written 273 opened";
}

TEST(Convert, NumbersAndNamesStayWhatTheyAre) {
    scene::Scene scene;
    scene.file = "a \"b\".toml";
    scene.cameras.emplace_back();
    scene.cameras[0].position = {0.1, 1e-300, -0.0};
    scene.cameras[0].name = "position";  // the name of a key
    scene.cameras.emplace_back(scene.cameras[0]);
    for (const char* name : {"two", "two", "", "ä \"\\ \n\x7f", "wrong \xff"}) {
        scene::Material material;
        material.name = name;
        material.model = scene::DiffuseMaterial{};
        scene.objects.push_back({name, scene::Sphere{}, static_cast<int>(scene.materials.size()), glm::dmat4(1.0), {}});
        scene.materials.push_back(material);
    }
    scene.objects[1].to_parent[1] = glm::dvec4(0.25, 3.0, 1.0 / 3.0, 0.0);  // a shear
    scene.lights.push_back({"", scene::PointLight{}, scene::Rgb(1.0), 1.0, {}});
    const TemporaryFolder folder;
    const Converted converted = convert(scene, folder);
    ASSERT_TRUE(converted.opened);
    const scene::Scene& read = converted.read_back;
    EXPECT_EQ(read.cameras.at(0).position, scene.cameras[0].position);
    EXPECT_TRUE(std::signbit(read.cameras.at(0).position.z));
    EXPECT_EQ(read.cameras.size(), 2u);
    EXPECT_EQ(read.objects.at(1).to_parent, scene.objects[1].to_parent);
    EXPECT_EQ(read.objects.at(3).name, scene.objects[3].name);
    EXPECT_EQ(read.objects.at(4).name, "wrong ?");
    EXPECT_EQ(body(converted.first), body(converted.second));
}

// ---- The file of meshes ---------------------------------------------------------------------------------------------------------

std::string meshes_of_a_triangle() {
    auto mesh = std::make_shared<scene::TriangleMesh>();
    mesh->positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh->triangles = {{0, 1, 2}};
    mesh->tangents.assign(3, glm::vec4(1, 0, 0, -1));
    mesh->second_uvs.assign(3, glm::vec2(0.25f, 0.75f));
    mesh->face_colors = {{0.5f, 0.25f, 0.125f, 1.0f}};
    return write_meshes({mesh, mesh});
}

TEST(MeshFile, HoldsEverything) {
    const std::string bytes = meshes_of_a_triangle();
    Diagnostics diagnostics;
    const auto meshes = read_meshes(bytes, "a.meshes", diagnostics);
    ASSERT_EQ(meshes.size(), 2u);
    EXPECT_EQ(write_meshes(meshes), bytes);
}

TEST(MeshFile, RefusesWhatTheBytesDoNotExplain) {
    const std::string bytes = meshes_of_a_triangle();
    const auto refused = [](const std::string& broken) {
        Diagnostics diagnostics;
        const auto meshes = read_meshes(broken, "a.meshes", diagnostics);
        return meshes.empty() && diagnostics.has_errors();
    };
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        EXPECT_TRUE(refused(bytes.substr(0, size))) << size;
    }
    EXPECT_TRUE(refused(bytes + "x"));
    std::string many = bytes;
    many.replace(16, 8, std::string(8, '\xff'));  // the number of meshes
    EXPECT_TRUE(refused(many));
    many = bytes;
    many.replace(24, 8, std::string("\0\0\0\0\0\0\0\x10", 8));  // positions of the first: 2^60
    EXPECT_TRUE(refused(many));
    std::string endless = bytes;
    const float infinite = HUGE_VALF;
    std::memcpy(&endless[24 + 64], &infinite, sizeof(infinite));
    EXPECT_TRUE(refused(endless));
    std::string corner = bytes;
    corner.back() = '\x7f';
    EXPECT_TRUE(refused(corner));
}

}  // namespace
}  // namespace lancer
