// Meshes that are placed many times are held once.
#include <sys/resource.h>

#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "cli/program.h"

namespace lancer::test {
namespace {

// A ball of 100 x 50 quads.
std::string ball() {
    std::string corners, faces;
    int count = 0;
    for (int i = 0; i <= 100; ++i) {
        for (int j = 0; j <= 50; ++j) {
            const double a = 2.0 * std::numbers::pi * i / 100.0, b = std::numbers::pi * (0.01 + 0.98 * j / 50.0);
            corners += std::to_string(std::sin(b) * std::cos(a)) + ' ' + std::to_string(std::cos(b)) + ' ' +
                       std::to_string(-std::sin(b) * std::sin(a)) + '\n';
            if (i < 100 && j < 50) {
                const int k = i * 51 + j;
                for (const auto& [p, q] : {std::pair(k + 51, k + 52), std::pair(k + 52, k + 1)}) {
                    faces += "3 " + std::to_string(k) + ' ' + std::to_string(p) + ' ' + std::to_string(q) + '\n';
                    ++count;
                }
            }
        }
    }
    return "ply\nformat ascii 1.0\nelement vertex 5151\nproperty float x\nproperty float y\nproperty float z\nelement face " +
           std::to_string(count) + "\nproperty list uchar int vertex_indices\nend_header\n" + corners + faces;
}

TEST(Instances, TenMillionTrianglesFitIntoAGigabyte) {
    const Folder folder;
    folder.write("ball.ply", ball());
    std::string scene =
        "background = [1, 1, 1]\n[render]\nsize = [64, 64]\nspp = 1\n[camera]\nposition = [-20, 40, -20]\nlook_at = [15, 15, 15]\n"
        "[[group]]\nname = 'ball'\n[[group.mesh]]\nfile = 'ball.ply'\nmaterial = { type = 'diffuse' }\n"
        // Groups in groups: ten, ten times, ten times.
        "[[group]]\nname = 'row'\n";
    for (int i = 0; i < 10; ++i) {
        scene += "[[group.place]]\ngroup = 'ball'\ntranslate = [" + std::to_string(3 * i) + ", 0, 0]\n";
    }
    scene += "[[group]]\nname = 'layer'\n";
    for (int i = 0; i < 10; ++i) {
        scene += "[[group.place]]\ngroup = 'row'\ntranslate = [0, 0, " + std::to_string(3 * i) + "]\n";
    }
    for (int i = 0; i < 10; ++i) {
        scene += "[[place]]\ngroup = 'layer'\ntranslate = [0, " + std::to_string(3 * i) + ", 0]\n";
    }
    folder.write("scene.toml", scene);
    const Finished finished = run_lancer(folder, {"render", "scene.toml", "-o", "balls.png"});
    EXPECT_EQ(finished.status, 0) << finished.err;
    EXPECT_TRUE(folder.has("balls.png"));
    rusage used{};
    ASSERT_EQ(getrusage(RUSAGE_CHILDREN, &used), 0);
    EXPECT_LT(used.ru_maxrss, 1000 * 1000) << "kilobytes, of the largest program that was started so far";
}

}  // namespace
}  // namespace lancer::test
