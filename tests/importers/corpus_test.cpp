// Files that others made, where there is a collection of them: named by LANCER_REFERENCE, or beside the source folder.
#include <algorithm>

#include "reading.h"

namespace lancer {
namespace {

using namespace lancer::testing;
namespace fs = std::filesystem;

std::optional<fs::path> reference_folder() {
    if (const char* named = std::getenv("LANCER_REFERENCE")) {
        return fs::path(named);
    }
    const fs::path beside = source_folder() / ".." / "shared" / "reference";
    return fs::exists(beside) ? std::optional(beside) : std::nullopt;
}

std::vector<fs::path> meshes_below(const fs::path& folder) {
    std::vector<fs::path> found;
    if (fs::exists(folder)) {
        for (const auto& entry : fs::recursive_directory_iterator(folder)) {
            const std::string ending = entry.path().extension().string();
            if (ending == ".obj" || ending == ".ply") {
                found.push_back(entry.path());
            }
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

TEST(Corpus, ValidMeshesOpen) {
    const auto folder = reference_folder();
    if (!folder) {
        GTEST_SKIP() << "no collection of files: set LANCER_REFERENCE";
    }
    // Valid for their format, but with nothing that could be seen or with a mistake that their makers test for.
    const std::vector<std::string> no_faces = {"points.ply", "testpoints.obj", "issue623.ply", "invalid-face-definition.obj",
                                               "invalid-relative-vertex-index.obj"};
    for (const char* part : {"meshes", "obj-ply"}) {
        for (const fs::path& path : meshes_below(*folder / part)) {
            ImportOptions options;
            options.magenta_textures = true;  // the pictures of these materials are not in the collection
            Diagnostics diagnostics;
            ImportReport report;
            auto scene = import_scene(path.string(), options, report, diagnostics);
            const Reading reading = gather(std::move(scene), diagnostics);
            const bool expected = std::find(no_faces.begin(), no_faces.end(), path.filename()) == no_faces.end();
            EXPECT_EQ(reading.scene.has_value(), expected) << reading.all();
            EXPECT_TRUE(reading.scene || !reading.messages.empty()) << path;
        }
    }
}

TEST(Corpus, MalformedFilesAreRefusedOrRepairedWithAMessage) {
    const auto folder = reference_folder();
    if (!folder) {
        GTEST_SKIP() << "no collection of files: set LANCER_REFERENCE";
    }
    for (const fs::path& path : meshes_below(*folder / "malformed")) {
        EXPECT_FALSE(read_path(path.string()).messages.empty()) << path;
    }
    // Broken files of other kinds, read as if they were ours.
    if (fs::exists(*folder / "malformed")) {
        for (const auto& entry : fs::recursive_directory_iterator(*folder / "malformed")) {
            if (entry.is_regular_file() && entry.file_size() < 200'000) {
                std::ifstream file(entry.path(), std::ios::binary);
                const std::string bytes{std::istreambuf_iterator<char>(file), {}};
                const TemporaryFolder copy;
                for (const char* name : {"a.toml", "a.obj", "a.ply"}) {
                    const Reading reading = read_path(copy.write(name, bytes));
                    EXPECT_TRUE(reading.scene || !reading.messages.empty()) << entry.path() << " as " << name;
                }
            }
        }
    }
}

}  // namespace
}  // namespace lancer
