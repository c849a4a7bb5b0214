#include "lancer/image/flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "lancer/image/separable_filter.h"

namespace {

using namespace lancer;

Image flat(float r, float g, float b, int width = 40, int height = 30) {
    Image image{width, height, 3, {}};
    for (int i = 0; i < width * height; ++i) {
        for (const float value : {r, g, b}) {
            image.pixels.push_back(value);
        }
    }
    return image;
}

// A ramp in red and green and a board in blue; times `scale`, plus `offset`.
Image pattern(float scale = 1.0f, float offset = 0.0f) {
    Image image{48, 32, 3, {}};
    for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < 48; ++x) {
            const float board = (x / 6 + y / 6) % 2 == 1 ? 0.5f : 0.0f;
            for (const float value : {static_cast<float>(x) / 48.0f, static_cast<float>(y) / 32.0f, board}) {
                image.pixels.push_back(value * scale + offset);
            }
        }
    }
    return image;
}

// The same with a red rectangle and two darkened rows.
Image changed_pattern(float scale = 1.0f, float offset = 0.0f) {
    Image image = pattern();
    for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < 48; ++x) {
            float* pixel = image.pixels.data() + 3 * (48 * y + x);
            if (y >= 8 && y < 16 && x >= 10 && x < 30) {
                pixel[0] = 0.9f;
                pixel[1] = 0.1f;
                pixel[2] = 0.2f;
            }
            for (int c = 0; c < 3; ++c) {
                pixel[c] = pixel[c] * (y == 20 || y == 21 ? 0.5f : 1.0f) * scale + offset;
            }
        }
    }
    return image;
}

double at(const FlipMap& map, int x, int y) { return static_cast<double>(map.values[static_cast<std::size_t>(y * map.width + x)]); }

double largest(const FlipMap& map) { return static_cast<double>(*std::max_element(map.values.begin(), map.values.end())); }

// The numbers come from the papers' formulas, evaluated with two-dimensional filters in double precision. Here the arithmetic is in floats:
// six digits, and fewer where the seventh root of small colour differences is taken.
TEST(Flip, FollowsThePaper) {
    const FlipMap map = flip_for_displays(changed_pattern(), pattern());
    EXPECT_EQ(map.width, 48);
    EXPECT_EQ(map.height, 32);
    EXPECT_NEAR(map.mean(), 0.20978222, 2e-5);
    EXPECT_NEAR(largest(map), 0.96091070, 2e-5);
    EXPECT_NEAR(at(map, 20, 12), 0.85381099, 2e-5);
    EXPECT_NEAR(at(map, 40, 21), 0.50633400, 2e-5);
}

TEST(Flip, ForLightFollowsThePaper) {
    const Image picture = changed_pattern(8.0f, 0.01f), reference = pattern(8.0f, 0.01f);
    const FlipExposures exposures = flip_exposures(reference);
    EXPECT_NEAR(exposures.first, -1.78348606, 1e-5);
    EXPECT_NEAR(exposures.last, -0.82426063, 1e-5);
    EXPECT_EQ(exposures.count, 2);
    const FlipMap map = flip_for_light(picture, reference, exposures);
    EXPECT_NEAR(map.mean(), 0.20980235, 2e-5);
    EXPECT_NEAR(largest(map), 0.97015288, 2e-5);
    EXPECT_NEAR(at(map, 20, 12), 0.96552664, 2e-5);
}

// Flat pictures have no features: the colour difference alone, in closed form.
TEST(Flip, OfFlatColorsIsTheirDistance) {
    EXPECT_NEAR(flip_for_displays(flat(0, 1, 0), flat(0, 0, 1)).mean(), 1.0, 1e-5);  // green and blue are furthest apart
    EXPECT_NEAR(flip_for_displays(flat(1, 1, 1), flat(0, 0, 0)).mean(), 0.96737976, 1e-5);
    const auto lightness = [](double y) { return 116.0 * std::cbrt(y) - 16.0; };
    const double most = 41.27609841;  // of green and blue
    const double grey = 0.95 / (0.4 * most) * std::pow(lightness(0.6) - lightness(0.5), 0.7);
    EXPECT_NEAR(flip_for_displays(flat(0.5f, 0.5f, 0.5f), flat(0.6f, 0.6f, 0.6f)).mean(), grey, 1e-4);  // floats: a trace of colour
}

TEST(Flip, IsZeroForTheSameAndSymmetric) {
    const Image a = changed_pattern(), b = pattern();
    EXPECT_EQ(largest(flip_for_displays(a, a)), 0.0);
    EXPECT_EQ(largest(flip_for_light(a, a, flip_exposures(a))), 0.0);
    EXPECT_EQ(flip_for_displays(a, b).values, flip_for_displays(b, a).values);
    const FlipExposures exposures = flip_exposures(b);
    EXPECT_EQ(flip_for_light(a, b, exposures).values, flip_for_light(b, a, exposures).values);
}

TEST(Flip, StaysBetweenZeroAndOneAndGrowsWithContrast) {
    double last = 0.0;
    for (const float contrast : {0.05f, 0.1f, 0.2f, 0.4f, 0.8f}) {
        const FlipMap map = flip_for_displays(pattern(contrast, 0.1f), flat(0.1f, 0.1f, 0.1f, 48, 32));
        for (const float value : map.values) {
            EXPECT_GE(value, 0.0f);
            EXPECT_LE(value, 1.0f);
        }
        EXPECT_GT(map.mean(), last);
        last = map.mean();
    }
}

// At arm's length single pixels are seen; from afar they melt away.
TEST(Flip, ShrinksWithDistance) {
    Image dotted = flat(0.2f, 0.2f, 0.2f);
    dotted.pixels[3 * (40 * 15 + 20)] = 1.0f;
    const Image plain = flat(0.2f, 0.2f, 0.2f);
    EXPECT_GT(largest(flip_for_displays(dotted, plain, 30.0)), largest(flip_for_displays(dotted, plain, 120.0)));
}

TEST(Flip, ExposesBlackAndOddPicturesToo) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    EXPECT_EQ(flip_exposures(flat(0, 0, 0)).count, 1);
    Image mostly_black = flat(0, 0, 0);
    std::fill_n(mostly_black.pixels.begin(), 30, 2.0f);
    const FlipExposures exposures = flip_exposures(mostly_black);
    EXPECT_TRUE(std::isfinite(exposures.first) && std::isfinite(exposures.last));
    const Image odd = flat(nan, -1.0f, infinity);
    for (const FlipMap& map : {flip_for_displays(odd, flat(0, 0, 1)), flip_for_light(odd, flat(0, 0, infinity), flip_exposures(odd))}) {
        for (const float value : map.values) {
            EXPECT_LE(value, 1e-3f);
            EXPECT_GE(value, 0.0f);
        }
    }
}

// A picture smaller than the filters: only repeated edges.
TEST(Flip, TakesSinglePixels) { EXPECT_NEAR(flip_for_displays(flat(0, 1, 0, 1, 1), flat(0, 0, 1, 1, 1)).mean(), 1.0, 1e-5); }

TEST(SeparableFilter, CorrelatesAndRepeatsTheEdge) {
    Plane plane(3, 2);
    plane.values = {1, 2, 3, 10, 20, 30};
    EXPECT_EQ(filter_rows(plane, {1, 0, 100}).values, (std::vector<float>{201, 301, 302, 2010, 3010, 3020}));
    EXPECT_EQ(filter_columns(plane, {1, 0, 100}).values, (std::vector<float>{1001, 2002, 3003, 1001, 2002, 3003}));
}

}  // namespace
