// The scene with the prism shows the spectrum in the order that nature has.
#include <algorithm>
#include <optional>

#include <gtest/gtest.h>

#include "lancer/device/cpu/cpu.h"
#include "lancer/import/import.h"
#include "lancer/render/render.h"
#include "lancer/world/compile.h"

namespace lancer {
namespace {

// The bar of light stands on the left. What is bent least stays nearest to it, so along a row of the picture's right half come red, yellow,
// green, blue and violet.
TEST(Prism, TheSceneShowsRedToVioletFromTheBarOn) {
    Diagnostics diagnostics;
    std::optional<scene::Scene> scene = import_scene(LANCER_SOURCE_FOLDER "/scenes/features/prism.toml", diagnostics);
    ASSERT_TRUE(scene);
    RenderOptions options;
    options.width = scene->settings.width = 240;
    options.height = scene->settings.height = 135;
    Film film(options.width, options.height);
    render(*make_cpu_device(compile_world(*scene, scene->cameras.front(), diagnostics), {}), options, film);

    const auto saturated = [](const glm::vec3& c) { return std::max({c.x, c.y, c.z}) > 0.2f && std::min({c.x, c.y, c.z}) < 0.05f; };
    for (const int y : {30, 40, 50}) {
        double place[3] = {0.0, 0.0, 0.0};
        int count[3] = {0, 0, 0};
        for (int x = options.width / 2; x < options.width; ++x) {
            const glm::vec3 c = film.radiance[film.index(x, y)];
            if (saturated(c)) {
                const int hue = c.x >= c.y && c.x >= c.z ? 0 : c.y >= c.z ? 1 : 2;
                place[hue] += x;
                ++count[hue];
            }
        }
        for (int hue = 0; hue < 3; ++hue) {
            ASSERT_GE(count[hue], 3) << "row " << y;
            place[hue] /= count[hue];
        }
        EXPECT_LT(place[0], place[1]) << "row " << y;
        EXPECT_LT(place[1], place[2]) << "row " << y;
    }
}

}  // namespace
}  // namespace lancer
