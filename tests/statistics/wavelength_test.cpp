// The wavelengths that a path carries: drawn as their density says, and where the scene's light is.
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "lancer/import/import.h"
#include "lancer/kernel/spectrum.h"
#include "lancer/spectrum/illuminant.h"
#include "lancer/world/compile.h"
#include "lancer/world/wavelengths.h"
#include "statistics/chi_squared.h"

namespace lancer::statistics {
namespace {

using namespace kernel;

std::shared_ptr<const World> world_under(const std::string& light) {
    Diagnostics diagnostics;
    const auto scene = import_toml("background = " + light + "\n[[sphere]]\nmaterial = { type = 'diffuse' }\n", "scene.toml", diagnostics);
    return scene ? compile_world(*scene, scene->cameras.front(), diagnostics) : nullptr;
}

class Wavelengths : public ::testing::TestWithParam<const char*> {};

TEST_P(Wavelengths, FollowTheirDensity) {
    const auto world = world_under(GetParam());
    ASSERT_TRUE(world);
    const WorldRecord record = world->record();
    std::vector<double> expected;
    double sum = 0.0;
    constexpr int draws = 400000;
    for (const float density : world->wavelength_densities) {
        sum += static_cast<double>(density);
        expected.push_back(draws * static_cast<double>(density));
    }
    EXPECT_NEAR(sum, 1.0, 1e-6);
    for (int which = 0; which < 4; ++which) {
        std::mt19937 numbers(3);
        std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
        std::vector<double> counts(expected.size(), 0.0);
        for (int i = 0; i < draws; ++i) {
            const Vec4 w = wavelengths_at(record, std::min(uniform(numbers), 0.99999994f), true);
            const float nanometres = which == 0 ? w.x : which == 1 ? w.y : which == 2 ? w.z : w.w;
            counts[static_cast<std::size_t>(wavelength_entry(nanometres))] += 1.0;
        }
        const Verdict verdict = compare_counts(counts, expected);
        EXPECT_TRUE(verdict.right()) << "wavelength " << which << ": " << verdict.words();
    }
}

INSTANTIATE_TEST_SUITE_P(Lights, Wavelengths,
                         ::testing::Values("[1, 1, 1]", "{ illuminant = 'A' }", "{ illuminant = 'FL11' }",
                                           "{ wavelengths = [588, 589, 590], values = [0, 1, 0] }"));

// Drawn for a lamp, wavelengths leave less noise under it than those drawn for daylight. The bounds are what was measured, and a little more; a
// logistic density around 538 nm would leave 0.39, 0.16 and 4.6.
TEST(WavelengthVariance, IsSmallUnderTheSceneOwnLight) {
    const auto daylight = world_under("[1, 1, 1]");
    ASSERT_TRUE(daylight);
    const struct {
        const char* name;
        double most;
    } cases[] = {{"D65", 0.12}, {"A", 0.2}, {"FL11", 0.25}};
    for (const auto& [name, most] : cases) {
        const auto world = world_under(std::string("{ illuminant = '") + name + "' }");
        ASSERT_TRUE(world);
        const auto light = with_unit_luminance(find_illuminant(name).value()).on(fine_grid);
        const double variance = wavelength_variance(*world, light);
        EXPECT_LT(variance, most) << name;
        EXPECT_LE(variance, wavelength_variance(*daylight, light) + 1e-6) << name;
    }
}

}  // namespace
}  // namespace lancer::statistics
