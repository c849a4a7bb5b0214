// Smooth spectra of colours: the fit, the table, and the kernel's look-up in single precision.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "lancer/kernel/upsample.h"
#include "lancer/spectrum/curve.h"
#include "lancer/spectrum/illuminant.h"
#include "lancer/spectrum/sensor.h"
#include "lancer/spectrum/upsample.h"
#include "lancer/spectrum/upsample_fit.h"
#include "upsample_simd.h"

namespace lancer {
namespace {

static_assert(kernel::UPSAMPLING_HUES == upsampling_hues && kernel::UPSAMPLING_SATURATIONS == upsampling_saturations &&
              kernel::UPSAMPLING_LIGHTNESSES == upsampling_lightnesses);

double largest(const glm::dvec3& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

SpectralCurve curve_of(const SmoothSpectrum& spectrum) {
    std::vector<double> nm, values;
    for (int l = 360; l <= 830; ++l) {
        nm.push_back(l);
        values.push_back(spectrum.at(l));
    }
    return {nm, values, SpectralCurve::Beyond::constant};
}

class Colors {
public:
    glm::dvec3 any() { return {unit_(random_), unit_(random_), unit_(random_)}; }
    glm::dvec3 on_a_face() {
        glm::dvec3 color = any();
        color[static_cast<int>(random_() % 3)] = static_cast<double>(random_() % 2);
        return color;
    }

private:
    std::mt19937 random_{11};
    std::uniform_real_distribution<double> unit_{0.0, 1.0};
};

// Where the table's errors are told; docs/spectra.md repeats the numbers.
TEST(Upsampling, RoundTripOverTheCube) {
    const SmoothSpectrumFit fit;
    Colors colors;
    constexpr int count = 20000;
    double mean = 0.0, worst = 0.0, worst_on_faces = 0.0, worst_near_white = 0.0;
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 inside = colors.any();
        const double error = largest(fit.rgb_of(smooth_reflectance(inside).coefficients) - inside);
        mean += error / count;
        worst = std::max(worst, error);
        const glm::dvec3 outside = colors.on_a_face();
        worst_on_faces = std::max(worst_on_faces, largest(fit.rgb_of(smooth_reflectance(outside).coefficients) - outside));
    }
    for (int i = 0; i < count / 10; ++i) {
        const glm::dvec3 pale = 1.0 - 0.02 * colors.any();
        worst_near_white = std::max(worst_near_white, largest(fit.rgb_of(smooth_reflectance(pale).coefficients) - pale));
    }
    RecordProperty("worst_near_white", std::to_string(worst_near_white));
    RecordProperty("mean", std::to_string(mean));
    RecordProperty("worst", std::to_string(worst));
    RecordProperty("worst_on_faces", std::to_string(worst_on_faces));
    EXPECT_LT(mean, 2.5e-4);
    EXPECT_LT(worst, 1e-3);
    EXPECT_LT(worst_on_faces, 1.5e-3);
    EXPECT_LT(worst_near_white, 3e-4);
}

// The fit integrates as the rest of the program does, and finds each colour's spectrum.
TEST(Upsampling, FitIsExact) {
    const SmoothSpectrumFit fit;
    Colors colors;
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 color = i % 2 == 0 ? colors.any() : colors.on_a_face();
        SmoothSpectrum spectrum = smooth_reflectance(color);
        EXPECT_LT(fit.fit(color, spectrum.coefficients), 1e-8);
        EXPECT_LT(largest(reflected_rgb(curve_of(spectrum)) - color), 1e-4) << color.x << ' ' << color.y << ' ' << color.z;
    }
}

TEST(Upsampling, GreysAreConstantAndExact) {
    for (int i = 0; i <= 1000; ++i) {
        const double grey = i / 1000.0;
        const SmoothSpectrum spectrum = smooth_reflectance(glm::dvec3(grey));
        EXPECT_EQ(spectrum.coefficients.x, 0.0);
        EXPECT_EQ(spectrum.coefficients.y, 0.0);
        EXPECT_NEAR(spectrum.at(500.0), grey, 1e-15);
        const auto g = static_cast<float>(grey);
        const kernel::Vec3 c = kernel::reflectance_coefficients(upsampling_table().data(), {g, g, g}, true);
        EXPECT_EQ(c.x, 0.0f);
        EXPECT_EQ(c.y, 0.0f);
        EXPECT_NEAR(kernel::sigmoid_polynomial(c, 400.0f), g, 1.2e-7f);
        EXPECT_NEAR(kernel::sigmoid_polynomial(c, 400.0f), g, 4e-7f * g);
    }
    const kernel::Vec3 white = kernel::reflectance_coefficients(upsampling_table().data(), {1.0f, 1.0f, 1.0f}, true);
    const kernel::Vec3 black = kernel::reflectance_coefficients(upsampling_table().data(), {0.0f, 0.0f, 0.0f}, true);
    EXPECT_EQ(kernel::sigmoid_polynomial(white, 555.0f), 1.0f);
    EXPECT_EQ(kernel::sigmoid_polynomial(black, 555.0f), 0.0f);
}

TEST(Upsampling, ReflectancesStayBetweenZeroAndOne) {
    Colors colors;
    for (int i = 0; i < 3000; ++i) {
        const glm::vec3 color(i % 3 == 0 ? colors.any() : colors.on_a_face());
        const kernel::Vec3 c = kernel::reflectance_coefficients(upsampling_table().data(), {color.x, color.y, color.z}, true);
        for (float nm = 360.0f; nm <= 830.0f; nm += 10.0f) {
            const float value = kernel::sigmoid_polynomial(c, nm);
            ASSERT_TRUE(value >= 0.0f && value <= 1.0f) << value;
        }
    }
}

// Opposite colours have opposite spectra: together they are white.
TEST(Upsampling, ComplementsAddUpToWhite) {
    Colors colors;
    for (int i = 0; i < 300; ++i) {
        const glm::dvec3 color = colors.any();
        const SmoothSpectrum one = smooth_reflectance(color), other = smooth_reflectance(1.0 - color);
        for (double nm = 360.0; nm <= 830.0; nm += 47.0) {
            EXPECT_NEAR(one.at(nm) + other.at(nm), 1.0, 1e-12);
        }
    }
}

// Two colours that differ by little have spectra that differ by little: along lines through the cube, which cross its cells, its sixths and
// the middle between black and white.
TEST(Upsampling, Continuous) {
    Colors colors;
    for (int line = 0; line < 60; ++line) {
        const glm::dvec3 from = line % 2 == 0 ? colors.any() : colors.on_a_face(), to = colors.any();
        constexpr int steps = 2000;
        SmoothSpectrum before = smooth_reflectance(from);
        for (int i = 1; i <= steps; ++i) {
            const SmoothSpectrum here = smooth_reflectance(from + (to - from) * (i / static_cast<double>(steps)));
            for (const double nm : {420.0, 470.0, 540.0, 600.0, 680.0}) {
                ASSERT_NEAR(here.at(nm), before.at(nm), 0.03) << "line " << line << " step " << i;
            }
            before = here;
        }
    }
    // Closely around places where the look-up branches: nothing jumps. (At the ends of its axes the table is as steep as a square root.)
    const glm::dvec3 places[] = {{0.5, 0.5, 0.5}, {0.6, 0.6, 0.2}, {0.2, 0.6, 0.6},   {0.6, 0.2, 0.6}, {0.7, 0.2, 0.3}, {0.7, 0.3, 0.2},
                                 {0.9, 0.1, 0.1}, {0.8, 0.4, 0.2}, {0.25, 0.6, 0.75}, {0.4, 0.3, 0.3}, {0.3, 0.3, 0.4}, {0.5, 0.2, 0.2}};
    for (const glm::dvec3& place : places) {
        const SmoothSpectrum there = smooth_reflectance(place);
        for (int i = 0; i < 27; ++i) {
            const glm::dvec3 step(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
            const SmoothSpectrum near = smooth_reflectance(place + 1e-12 * step);
            for (double nm = 360.0; nm <= 830.0; nm += 47.0) {
                EXPECT_NEAR(near.at(nm), there.at(nm), 1e-6);
            }
        }
    }
}

// To what rounding does, which weighs most at the ends of the table's axes.
TEST(Upsampling, KernelIsTheReference) {
    Colors colors;
    double mean = 0.0;
    for (int i = 0; i < 5000; ++i) {
        const glm::vec3 color(i % 2 == 0 ? colors.any() : colors.on_a_face());
        const SmoothSpectrum expected = smooth_reflectance(color);
        const kernel::Vec3 c = kernel::reflectance_coefficients(upsampling_table().data(), {color.x, color.y, color.z}, true);
        for (float nm = 360.0f; nm <= 830.0f; nm += 23.5f) {
            const double value = kernel::sigmoid_polynomial(c, nm);
            ASSERT_NEAR(value, expected.at(nm), 1e-4) << color.x << ' ' << color.y << ' ' << color.z << " at " << nm;
            mean += std::fabs(value - expected.at(nm)) / (5000.0 * 21.0);
        }
    }
    EXPECT_LT(mean, 5e-7);
    const kernel::Vec3 off = kernel::reflectance_coefficients(nullptr, {0.2f, 0.4f, 0.6f}, false);  // reads nothing
    EXPECT_TRUE(std::isfinite(off.x));
}

#if defined(__SSE4_2__)
TEST(Upsampling, FourAtOnceAreFourAlone) {
    Colors colors;
    for (int i = 0; i < 2000; ++i) {
        FourColors four;
        std::array<bool, 4> on{};
        for (std::size_t lane = 0; lane < 4; ++lane) {
            const glm::vec3 color(i % 2 == 0 ? colors.any() : colors.on_a_face());
            four.r[lane] = color.x, four.g[lane] = color.y, four.b[lane] = color.z;
            four.nanometres[lane] = 360.0f + 470.0f * static_cast<float>(colors.any().x);
            on[lane] = (i >> lane) % 2 == 0;
        }
        const std::array<float, 4> values = four_reflectances(four, on);
        for (std::size_t lane = 0; lane < 4; ++lane) {
            const kernel::Vec3 c =
                kernel::reflectance_coefficients(upsampling_table().data(), {four.r[lane], four.g[lane], four.b[lane]}, true);
            ASSERT_EQ(values[lane], on[lane] ? kernel::sigmoid_polynomial(c, four.nanometres[lane]) : 0.0f);
        }
    }
}
#endif

TEST(Upsampling, WhatIsNoColourIsMovedIntoTheCube) {
    const double nan = std::nan("");
    EXPECT_EQ(smooth_reflectance({-1.0, 0.5, 7.0}).coefficients, smooth_reflectance({0.0, 0.5, 1.0}).coefficients);
    EXPECT_EQ(smooth_reflectance({nan, 0.5, 0.25}).coefficients, smooth_reflectance({0.0, 0.5, 0.25}).coefficients);
    const float inf = std::numeric_limits<float>::infinity(), no = std::numeric_limits<float>::quiet_NaN();
    for (const kernel::Vec3& color : {kernel::Vec3{no, no, no}, kernel::Vec3{inf, -inf, no}, kernel::Vec3{-1.0f, 2.0f, 0.5f}}) {
        const kernel::Vec3 c = kernel::reflectance_coefficients(upsampling_table().data(), color, true);
        const float value = kernel::sigmoid_polynomial(c, 500.0f);
        EXPECT_TRUE(value >= 0.0f && value <= 1.0f);
    }
}

// Light of any strength comes back as it was, and grey light has the colour of D65.
TEST(Upsampling, Lights) {
    Colors colors;
    for (int i = 0; i < 100; ++i) {
        const double strength = std::pow(10.0, i % 7 - 3);
        const glm::dvec3 color = strength * colors.any();
        const SmoothLight light = smooth_light(color);
        std::vector<double> nm, values;
        for (int l = 360; l <= 830; ++l) {
            nm.push_back(l);
            values.push_back(light.at(l));
        }
        const glm::dvec3 seen = to_rgb({nm, values, SpectralCurve::Beyond::zero});
        EXPECT_LT(largest(seen - color), 2.5e-3 * largest(color));
    }
    const SmoothLight grey = smooth_light(glm::dvec3(40.0));
    EXPECT_DOUBLE_EQ(grey.at(450.0), 40.0 * unit_d65().at(450.0));
    EXPECT_EQ(smooth_light(glm::dvec3(0.0)).at(500.0), 0.0);
    EXPECT_EQ(smooth_light(glm::dvec3(-1.0)).at(500.0), 0.0);
    EXPECT_EQ(kernel::emission_scale({1.0f, 4.0f, 2.0f}), 8.0f);
}

}  // namespace
}  // namespace lancer
