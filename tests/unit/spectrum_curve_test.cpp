#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "lancer/spectrum/curve.h"
#include "lancer/spectrum/curve_file.h"
#include "lancer/spectrum/observer.h"

namespace lancer {
namespace {

using Beyond = SpectralCurve::Beyond;

TEST(SpectralCurve, StraightLinesAndEnds) {
    const SpectralCurve curve({400.0, 500.0, 600.0}, {1.0, 2.0, 0.0}, Beyond::zero);
    EXPECT_DOUBLE_EQ(curve.at(400.0), 1.0);
    EXPECT_DOUBLE_EQ(curve.at(425.0), 1.25);
    EXPECT_DOUBLE_EQ(curve.at(550.0), 1.0);
    EXPECT_DOUBLE_EQ(curve.at(600.0), 0.0);
    EXPECT_DOUBLE_EQ(curve.at(399.0), 0.0);
    EXPECT_DOUBLE_EQ(curve.with_ends(Beyond::constant).at(399.0), 1.0);
    EXPECT_DOUBLE_EQ(curve.scaled(3.0).at(500.0), 6.0);
    EXPECT_DOUBLE_EQ(SpectralCurve(0.4).at(-1e9), 0.4);
    const SpectralCurve lamp({450.0, 460.0}, {7.0, 5.0}, Beyond::zero);
    EXPECT_DOUBLE_EQ(lamp.at(460.0), 5.0);  // its ends belong to it
    EXPECT_DOUBLE_EQ(lamp.at(460.1), 0.0);
    const std::vector<double> table = curve.on(fine_grid);
    ASSERT_EQ(table.size(), 471u);
    EXPECT_DOUBLE_EQ(table[40], 1.0);
    EXPECT_DOUBLE_EQ(curve.on(coarse_grid)[28], 2.0);
}

TEST(SpectralCurve, WhatTheObserverSees) {
    const glm::dvec3 equal = to_xyz(SpectralCurve(1.0));
    EXPECT_NEAR(equal.y, 1.0, 1e-14);
    EXPECT_NEAR(equal.x, 1.0, 1e-4);
    EXPECT_NEAR(equal.z, 1.0, 5e-4);
    // A narrow line between two tabulated wavelengths: the observer there, times its width.
    const SpectralCurve line({551.0, 552.0, 553.0}, {0.0, 1.0, 0.0}, Beyond::zero);
    const double area = 106.857;
    EXPECT_NEAR(to_xyz(line).x, cie_1931_fine(552.0).x / area, 1e-6);
    // The same with jumps instead of slopes.
    const SpectralCurve box({551.5, 552.5}, {1.0, 1.0}, Beyond::zero);
    EXPECT_NEAR(to_xyz(box).x, cie_1931_fine(552.0).x / area, 1e-6);
    // Half the reflectance, half of it all; and any light seen in a perfect white has Y = 1.
    const SpectralCurve ramp({400.0, 700.0}, {0.1, 0.9}, Beyond::constant);
    EXPECT_NEAR(to_xyz(SpectralCurve(0.5), ramp).y, 0.5, 1e-14);
    EXPECT_NEAR(to_xyz(SpectralCurve(1.0), ramp).x, to_xyz(ramp).x / to_xyz(ramp).y, 1e-14);
    EXPECT_EQ(to_xyz(ramp, SpectralCurve({900.0, 910.0}, {1.0, 1.0}, Beyond::zero)), glm::dvec3(0.0));
    EXPECT_NEAR(to_xyz(with_unit_luminance(ramp)).y, 1.0, 1e-14);
}

struct Parsed {
    std::optional<std::vector<SpectralCurve>> curves;
    std::vector<std::string> messages;
};

Parsed parse(std::string_view text, int columns = 1) {
    Diagnostics diagnostics;
    Parsed parsed;
    parsed.curves = parse_curves(text, "lamp.csv", columns, Beyond::zero, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.list()) {
        parsed.messages.push_back(to_string(diagnostic));
    }
    return parsed;
}

TEST(CurveFile, SeparatorsCommentsHeadersAndOrder) {
    for (const char* text : {"400,1\n500,2\n600,4\n", "nm;power\r\n400;1\r\n500;2\r\n600;4", "# lamp\n\n600\t4 # last\n500 , 2\n400 1\n",
                             "\xEF\xBB\xBFwavelength value\n 400 +1e0\n500,2,\n500 2\n600 4"}) {
        const Parsed parsed = parse(text);
        ASSERT_TRUE(parsed.curves) << text << parsed.messages.front();
        EXPECT_TRUE(parsed.messages.empty());
        EXPECT_EQ(parsed.curves->front().nanometres(), (std::vector<double>{400.0, 500.0, 600.0})) << text;
        EXPECT_EQ(parsed.curves->front().values(), (std::vector<double>{1.0, 2.0, 4.0})) << text;
    }
    const Parsed metal = parse("nm n k\n400 0.1 2\n500 0.2 3\n", 2);
    ASSERT_TRUE(metal.curves);
    EXPECT_EQ(metal.curves->at(1).at(450.0), 2.5);
}

TEST(CurveFile, SaysWhatIsWrongAndWhere) {
    EXPECT_EQ(parse("400 1\n500 high\n").messages, std::vector<std::string>{"lamp.csv:2:5: error: expected a number, found \"high\""});
    EXPECT_EQ(parse("400 1\n500\n").messages,
              std::vector<std::string>{"lamp.csv:2:1: error: expected a wavelength in nm and a value, found 1 number"});
    EXPECT_EQ(
        parse("400,5;0,25\n").messages,
        std::vector<std::string>{"lamp.csv:1:1: error: expected a wavelength in nm and a value, found 4 numbers (decimals are written "
                                 "with a point)"});
    EXPECT_EQ(parse("400 1\n500 2\n400 3\n").messages,
              std::vector<std::string>{"lamp.csv:3:1: error: this wavelength has another value in line 1: expected each wavelength once"});
    EXPECT_EQ(parse("# nothing\n").messages,
              std::vector<std::string>{"lamp.csv: error: no values: expected lines with a wavelength in nm and a value"});
    EXPECT_EQ(parse("400 nan\n").messages, std::vector<std::string>{"lamp.csv:1:5: error: expected a number, found \"nan\""});
    EXPECT_EQ(parse("400 1e308\n401 -1e308\n").messages.front(), "lamp.csv:1:5: error: expected a number, found \"1e308\"");
    EXPECT_EQ(parse("-400 1\n").messages,
              std::vector<std::string>{"lamp.csv:1:1: error: expected a wavelength above 0 nm, found \"-400\""});
    const Parsed micrometres = parse("0.4 1\n0.5 2\n");
    EXPECT_TRUE(micrometres.curves);
    EXPECT_EQ(micrometres.messages, std::vector<std::string>{"lamp.csv:1:1: warning: no wavelength between 360 and 830 nm: are these "
                                                             "micrometres? Lancer reads nanometres"});
    EXPECT_LE(
        parse(std::string(100000, '\x01') + "\n" + std::string(1000, '\n') + "x\nx\nx\nx\nx\nx\nx\nx\nx\nx\nx\nx\nx\nx\n").messages.size(),
        10u);
}

// Random bytes out of those that matter to the reader: it answers with curves or with messages.
TEST(CurveFile, AnyBytes) {
    std::mt19937 random(7);
    constexpr char all[] = "0123456789.,;- \t\r\n#eE+nanif\0\xEF\xFF";
    const std::string_view bytes(all, sizeof all - 1);
    for (int round = 0; round < 3000; ++round) {
        std::string text;
        for (auto length = random() % 60; length > 0; --length) {
            text += bytes[random() % bytes.size()];
        }
        const Parsed parsed = parse(text);
        EXPECT_TRUE(parsed.curves || !parsed.messages.empty());
        if (parsed.curves) {
            EXPECT_TRUE(std::isfinite(parsed.curves->front().at(555.0)));
        }
    }
}

}  // namespace
}  // namespace lancer
