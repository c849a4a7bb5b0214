// Pixel filters: drawn from, they weigh the film as their formulas say.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "lancer/kernel/pixel_filter.h"
#include "lancer/world/filters.h"

namespace lancer {
namespace {

class Filters : public testing::TestWithParam<scene::PixelFilter> {};

TEST_P(Filters, AreDrawnAsTheirFormulaSays) {
    World world;
    scene::RenderSettings settings;
    settings.filter = GetParam();
    compile_filter(settings, world);
    const kernel::WorldRecord record = world.record();
    const double radius = usual_radius(GetParam());
    // Weighted shares of the samples in cells of the filter, against its integral over them.
    constexpr int cells = 24, draws = 200000;
    double drawn[cells] = {}, exact[cells] = {};
    double total = 0.0;
    for (int i = 0; i < draws; ++i) {
        const kernel::FilterSample s = kernel::sample_filter(record, (static_cast<float>(i) + 0.5f) / draws, true);
        const int cell = std::clamp(static_cast<int>((static_cast<double>(s.place) / radius + 1.0) / 2.0 * cells), 0, cells - 1);
        drawn[cell] += static_cast<double>(s.weight) / draws;
        ASSERT_LE(std::abs(static_cast<double>(s.place)), radius * 1.0001);
    }
    constexpr int steps = 24000;
    for (int i = 0; i < steps; ++i) {
        const double value = filter_value(GetParam(), radius, radius * (2.0 * (i + 0.5) / steps - 1.0));
        exact[i * cells / steps] += value;
        total += value;
    }
    double sum = 0.0;
    for (int i = 0; i < cells; ++i) {
        EXPECT_NEAR(drawn[i], exact[i] / total, 0.002) << "cell " << i;
        sum += drawn[i];
    }
    EXPECT_NEAR(sum, 1.0, 0.001);
}

INSTANTIATE_TEST_SUITE_P(All, Filters,
                         testing::Values(scene::PixelFilter::box, scene::PixelFilter::tent, scene::PixelFilter::gaussian,
                                         scene::PixelFilter::mitchell, scene::PixelFilter::blackman_harris));

}  // namespace
}  // namespace lancer
