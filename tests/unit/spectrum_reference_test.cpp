// Our numbers beside those of others: illuminants as files, and the 24 patches of the ColorChecker.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "lancer/base/file.h"
#include "lancer/spectrum/curve_file.h"
#include "lancer/spectrum/illuminant.h"
#include "lancer/spectrum/observer.h"
#include "lancer/spectrum/sensor.h"
#include "lancer/spectrum/upsample.h"

namespace lancer {
namespace {

namespace fs = std::filesystem;

// A folder of measurements that others published: named by LANCER_REFERENCE, or beside the source folder.
class ReferenceSpectra : public testing::Test {
protected:
    void SetUp() override {
        const char* named = std::getenv("LANCER_REFERENCE");
        folder_ = (named ? fs::path(named) : fs::path(LANCER_SOURCE_FOLDER) / ".." / "shared" / "reference") / "spectra";
        if (!fs::exists(folder_)) {
            GTEST_SKIP() << "no collection of files: set LANCER_REFERENCE";
        }
    }

    SpectralCurve read(const std::string& name, SpectralCurve::Beyond beyond) const {
        Diagnostics diagnostics;
        const auto curve = read_curve((folder_ / name).string(), {}, beyond, diagnostics);
        EXPECT_TRUE(curve) << name;
        return curve.value_or(SpectralCurve(0.0));
    }

    fs::path folder_;
};

TEST_F(ReferenceSpectra, Illuminants) {
    for (const std::string& name : illuminant_names()) {
        const SpectralCurve theirs = read("illuminants/" + name + ".csv", SpectralCurve::Beyond::zero);
        const SpectralCurve ours = find_illuminant(name).value();
        const double scale = theirs.at(560.0) / ours.at(560.0);
        EXPECT_NEAR(scale, 1.0, 1e-9) << name;
        for (double nm = 380.0; nm <= 780.0; nm += 5.0) {
            // Six digits, as the tables have; D60 is no standard, and rounded in the file before it was interpolated.
            EXPECT_NEAR(ours.at(nm), theirs.at(nm), 6e-6 * 100.0 + 6e-6 * theirs.at(nm)) << name << " at " << nm;
        }
        const glm::dvec2 a = chromaticity(to_xyz_by_sums(ours)), b = chromaticity(to_xyz_by_sums(theirs));
        EXPECT_NEAR(a.x, b.x, 2e-6) << name;
        EXPECT_NEAR(a.y, b.y, 2e-6) << name;
    }
}

TEST_F(ReferenceSpectra, Observer) {
    Diagnostics diagnostics;
    const auto bytes = read_file((folder_ / "cie/cie1931_2deg.csv").string(), {}, diagnostics);
    ASSERT_TRUE(bytes);
    const auto curves = parse_curves(bytes->view(), "cie1931_2deg.csv", 3, SpectralCurve::Beyond::zero, diagnostics);
    ASSERT_TRUE(curves);
    for (int nm = 360; nm <= 830; ++nm) {
        for (std::size_t c = 0; c < 3; ++c) {
            const int component = static_cast<int>(c);
            const double expected = (*curves)[c].at(nm);
            EXPECT_NEAR(cie_1931_fine(nm)[component], expected, 5e-4) << nm;
            if (nm % 5 == 0) {
                EXPECT_NEAR(cie_1931(nm)[component], expected, 1.1e-7) << nm;  // some of their last digits differ
                EXPECT_NEAR(cie_1931_fine(nm)[component], expected, 1.1e-7) << nm;
            }
        }
    }
}

struct Patch {
    const char* name;
    int r, g, b;
};

// The maker's colours in sRGB, of other specimens than the measured ones.
const Patch patches[] = {
    {"dark_skin", 115, 82, 68},
    {"light_skin", 194, 150, 130},
    {"blue_sky", 98, 122, 157},
    {"foliage", 87, 108, 67},
    {"blue_flower", 133, 128, 177},
    {"bluish_green", 103, 189, 170},
    {"orange", 214, 126, 44},
    {"purplish_blue", 80, 91, 166},
    {"moderate_red", 193, 90, 99},
    {"purple", 94, 60, 108},
    {"yellow_green", 157, 188, 64},
    {"orange_yellow", 224, 163, 46},
    {"blue", 56, 61, 150},
    {"green", 70, 148, 73},
    {"red", 175, 54, 60},
    {"yellow", 231, 199, 31},
    {"magenta", 187, 86, 149},
    {"cyan", 8, 133, 161},
    {"white_9_5_05_D", 243, 243, 242},
    {"neutral_8_23_D", 200, 200, 200},
    {"neutral_6_5_44_D", 160, 160, 160},
    {"neutral_5_70_D", 122, 122, 121},
    {"neutral_3_5_1_05_D", 85, 85, 85},
    {"black_2_1_5_D", 52, 52, 52},
};

double encoded(double linear) {
    const double c = std::clamp(linear, 0.0, 1.0);
    return 255.0 * (c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055);
}

TEST_F(ReferenceSpectra, ColorCheckerUnderD65) {
    const SpectralCurve d65 = find_illuminant("D65").value();
    double sum = 0.0;
    for (const Patch& patch : patches) {
        const SpectralCurve reflectance = read(std::string("colorchecker-ohta/") + patch.name + ".csv", SpectralCurve::Beyond::constant);
        // XYZ as the CIE sums it, from 380 to 780 nm in steps of 5 nm, and as we integrate it.
        glm::dvec3 by_sums(0.0);
        double white = 0.0;
        for (int nm = 380; nm <= 780; nm += 5) {
            by_sums += reflectance.at(nm) * d65.at(nm) * cie_1931(nm);
            white += d65.at(nm) * cie_1931(nm).y;
        }
        const glm::dvec3 xyz = to_xyz(reflectance, d65), difference = xyz - by_sums / white;
        EXPECT_LT(std::max({std::fabs(difference.x), std::fabs(difference.y), std::fabs(difference.z)}), 5e-4) << patch.name;
        // What it looks like.
        const glm::dvec3 rgb = reflected_rgb(reflectance);
        const glm::dvec3 error(encoded(rgb.r) - patch.r, encoded(rgb.g) - patch.g, encoded(rgb.b) - patch.b);
        for (int c = 0; c < 3; ++c) {
            EXPECT_LT(std::fabs(error[c]), 25.0) << patch.name << " channel " << c;
            sum += std::fabs(error[c]) / 72.0;
        }
        // A smooth spectrum of that colour, where sRGB has it, looks the same.
        if (std::min({rgb.r, rgb.g, rgb.b}) >= 0.0) {
            const SmoothSpectrum smooth = smooth_reflectance(rgb);
            std::vector<double> nm, values;
            for (int l = 360; l <= 830; ++l) {
                nm.push_back(l);
                values.push_back(smooth.at(l));
            }
            const glm::dvec3 again = reflected_rgb({nm, values, SpectralCurve::Beyond::constant}) - rgb;
            EXPECT_LT(std::max({std::fabs(again.r), std::fabs(again.g), std::fabs(again.b)}), 6e-4) << patch.name;
        }
    }
    EXPECT_LT(sum, 5.0);
}

}  // namespace
}  // namespace lancer
