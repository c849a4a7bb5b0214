// Views: what each promises of greys and colours; ACES against its published curves.
#include "lancer/image/view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>

#include <gtest/gtest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "lancer/base/failure.h"
#include "lancer/image/aces/aces_module.h"

namespace lancer {
namespace {

glm::vec3 seen(View view, const glm::vec3& light, double exposure = 0.0) {
    std::array<glm::vec3, 1> color{light};
    ViewTransform(view, exposure).apply(color);
    return color[0];
}

bool is_there(View view) {
    try {
        ViewTransform(view, 0.0);
        return true;
    } catch (const MachineFailure& failure) {
        EXPECT_NE(std::string(failure.what()).find("libopencolorio"), std::string::npos);
        return false;
    }
}

class Views : public testing::TestWithParam<View> {
protected:
    void SetUp() override {
        if (!is_there(GetParam())) {
            GTEST_SKIP() << "built without OpenColorIO";
        }
    }
};

TEST_P(Views, GreyStaysGreyAndBrighterStaysBrighter) {
    float before = -1.0f;
    for (double stops = -9.0; stops <= 6.0; stops += 0.125) {
        const glm::vec3 c = seen(GetParam(), glm::vec3(static_cast<float>(0.18 * std::exp2(stops))));
        EXPECT_NEAR(c.x, c.y, 1e-3f + 1e-3f * c.y) << stops;
        EXPECT_NEAR(c.z, c.y, 1e-3f + 1e-3f * c.y) << stops;
        EXPECT_GE(c.y, before) << stops;
        before = c.y;
    }
    const float white = GetParam() == View::srgb ? 11.52f : 1.0f;
    EXPECT_NEAR(before, white, 0.05f);
    EXPECT_NEAR(seen(GetParam(), glm::vec3(0.0f)).y, 0.0f, 1e-3f);
}

TEST_P(Views, ExposureScalesTheLight) {
    const glm::vec3 a = seen(GetParam(), {0.4f, 0.2f, 0.1f}, -1.0), b = seen(GetParam(), {0.2f, 0.1f, 0.05f});
    EXPECT_LT(glm::length(a - b), 1e-6f);
}

TEST_P(Views, ShowNothingOutOfRange) {
    if (GetParam() == View::srgb) {
        return;  // clipped when it is encoded
    }
    for (const glm::vec3& light : {glm::vec3(100.0f, 0.0f, 0.0f), glm::vec3(0.0f, 3.0f, 0.1f), glm::vec3(0.2f, 0.1f, 50.0f),
                                   glm::vec3(-1.0f, 0.5f, 0.5f), glm::vec3(std::nanf(""), 1.0f, 1.0f)}) {
        const glm::vec3 c = seen(GetParam(), light);
        for (int i = 0; i < 3; ++i) {
            EXPECT_TRUE(c[i] > -0.01f && c[i] < 1.01f) << light.x << " " << light.y << " " << light.z << ": " << c[i];
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, Views, testing::Values(View::srgb, View::pbr_neutral, View::agx, View::aces), [](const auto& case_) {
    std::string name(name_of(case_.param));
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

TEST(ViewNames, ComeBack) {
    for (const std::string& name : view_names()) {
        EXPECT_EQ(name_of(find_view(name).value()), name);
    }
    EXPECT_FALSE(find_view("filmic"));
}

TEST(PbrNeutral, LeavesBaseColorsAlone) {
    // But for the four hundredths that a dielectric surface mirrors.
    for (const glm::vec3& base : {glm::vec3(0.5f, 0.3f, 0.2f), glm::vec3(0.79f, 0.1f, 0.1f), glm::vec3(0.08f, 0.6f, 0.3f)}) {
        EXPECT_LT(glm::length(pbr_neutral(base) - (base - glm::vec3(0.04f))), 1e-6f);
    }
    // Of darker ones, less: x - 6.25 x^2 of the least channel.
    EXPECT_NEAR(pbr_neutral({0.5f, 0.04f, 0.3f}).x, 0.5f - (0.04f - 6.25f * 0.0016f), 1e-6f);
    // 0.76 is where compression begins; from the formula, 2 becomes 1 - 0.24^2 / (1.96 + 0.24 - 0.76).
    EXPECT_NEAR(pbr_neutral(glm::vec3(2.0f)).x, 0.96f, 1e-5f);
    // A bright colour keeps its peak, and goes towards white by 1 - 1 / (0.15 (peak - compressed) + 1).
    const glm::vec3 red = pbr_neutral({10.0f, 0.0f, 0.0f});
    const float compressed = 1.0f - 0.0576f / (10.0f + 0.24f - 0.76f), white = 1.0f - 1.0f / (0.15f * (10.0f - compressed) + 1.0f);
    EXPECT_NEAR(red.x, compressed, 1e-5f);
    EXPECT_NEAR(red.y, compressed * white, 1e-5f);
}

TEST(Agx, KeepsMiddleGreyAndWhitensBrightColors) {
    EXPECT_NEAR(agx(glm::vec3(0.18f)).y, 0.18f, 1e-4f);
    EXPECT_NEAR(agx(glm::vec3(0.18f * std::exp2(6.5f))).y, 1.0f, 1e-3f);
    const glm::vec3 dim = agx({0.3f, 0.01f, 0.01f}), bright = agx({30.0f, 1.0f, 1.0f});
    EXPECT_LT(dim.y / dim.x, 0.25f);
    EXPECT_GT(bright.y / bright.x, 0.5f);
}

// ---- The tone curve of ACES, from the Academy's transforms: quadratic B-splines of the logarithm. --------------------------------------

double spline(double from, double to, std::span<const double> knots, double x) {
    const double place = static_cast<double>(knots.size() - 3) * (x - from) / (to - from);
    const std::size_t j = std::min(static_cast<std::size_t>(place), knots.size() - 4);
    const double t = place - static_cast<double>(j);
    return knots[j] * (0.5 * t * t - t + 0.5) + knots[j + 1] * (-t * t + t + 0.5) + knots[j + 2] * 0.5 * t * t;
}

double reference_curve(double x) {
    constexpr double low[] = {-4.0, -4.0, -3.1573765773, -0.4852499958, 1.8477324706, 1.8477324706};
    constexpr double high[] = {-0.7185482425, 2.0810307172, 3.6681241237, 4.0, 4.0, 4.0};
    const double log_x = std::log10(x), middle = std::log10(0.18);
    const double least = std::log10(0.18 * std::exp2(-15.0)), most = std::log10(0.18 * std::exp2(18.0));
    return std::pow(10.0, log_x <= middle ? spline(least, middle, low, log_x) : spline(middle, most, high, log_x));
}

double output_curve(double x) {
    constexpr double low[] = {-1.6989700043, -1.6989700043, -1.4779,      -1.2291,      -0.8648,
                              -0.448,        0.00518,       0.4511080334, 0.9113744414, 0.9113744414};
    constexpr double high[] = {0.5154386965, 0.8470437783, 1.1358, 1.3802, 1.5197, 1.5985, 1.6467, 1.6746091357, 1.687873339, 1.687873339};
    const double log_x = std::log10(x), middle = std::log10(4.8);
    const double least = std::log10(reference_curve(0.18 * std::exp2(-6.5))), most = std::log10(reference_curve(0.18 * std::exp2(6.5)));
    return std::pow(10.0, log_x <= middle ? spline(least, middle, low, log_x) : spline(middle, most, high, log_x));
}

TEST(Aces, GreysFollowThePublishedCurves) {
    if (!is_there(View::aces)) {
        GTEST_SKIP() << "built without OpenColorIO";
    }
    EXPECT_NEAR(reference_curve(0.18), 4.8, 1e-6);
    EXPECT_NEAR(output_curve(4.8), 4.8, 1e-6);
    for (const double light : {0.005, 0.02, 0.18, 0.5, 1.0, 3.0, 8.0}) {
        // Nits between those of black and white, then the exponent for a dim surround.
        const double nits = output_curve(reference_curve(light));
        const double expected = std::pow((nits - 0.02) / (48.0 - 0.02), 0.9811);
        EXPECT_NEAR(static_cast<double>(seen(View::aces, glm::vec3(static_cast<float>(light))).y), expected, 0.002 + 0.01 * expected)
            << light;
    }
}

TEST(Aces, WithoutItsModuleTheMessageNamesThePackage) {
    try {
        load_aces_module({"/nowhere"});
        SUCCEED() << "the system has one";
    } catch (const MachineFailure& failure) {
        EXPECT_NE(std::string(failure.what()).find("libopencolorio-dev"), std::string::npos) << failure.what();
    }
}

}  // namespace
}  // namespace lancer
