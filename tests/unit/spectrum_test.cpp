#include "lancer/spectrum/glass.h"
#include "lancer/spectrum/observer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {

using namespace lancer;

constexpr double line_g = 435.8343, line_f = 486.1327, line_e = 546.0740, line_d = 587.5618, line_c = 656.2725;  // nm
constexpr double degree = std::numbers::pi / 180.0;

TEST(Observer, TabulatedValuesAndStraightLinesBetween) {
    EXPECT_DOUBLE_EQ(cie_1931(555.0).y, 1.0);
    EXPECT_DOUBLE_EQ(cie_1931(600.0).x, 1.0622);
    EXPECT_DOUBLE_EQ(cie_1931(445.0).z, 1.7826);
    EXPECT_NEAR(cie_1931(552.5).y, (0.99495 + 1.0) / 2.0, 1e-15);
    EXPECT_GT(cie_1931(360.0).z, 0.0);
    EXPECT_GT(cie_1931(830.0).x, 0.0);
    for (const double outside : {359.999, 830.001, -1.0, 1e300, std::nan("")}) {
        EXPECT_EQ(cie_1931(outside), glm::dvec3(0.0)) << outside;
    }
}

// The three curves enclose the same area: equal energy is white.
TEST(Observer, Integrals) {
    glm::dvec3 sum(0.0);
    for (int nm = 360; nm <= 830; ++nm) {
        sum += cie_1931(nm);
    }
    EXPECT_NEAR(sum.y, 106.857, 0.002);
    EXPECT_NEAR(sum.x, 106.865, 0.005);
    EXPECT_NEAR(sum.z, 106.892, 0.02);
}

TEST(Observer, MatricesAreInverseAndAgreeWithTheStandard) {
    const glm::dvec3 color(0.2, 0.7, 0.4);
    const glm::dvec3 back = xyz_to_rgb(rgb_to_xyz(color));
    const glm::dvec3 white = rgb_to_xyz(glm::dvec3(1.0));
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(back[c], color[c], 1e-15);
    }
    EXPECT_NEAR(white.x, 0.3127 / 0.3290, 1e-14);
    EXPECT_NEAR(white.y, 1.0, 1e-14);
    EXPECT_NEAR(white.z, 0.3583 / 0.3290, 1e-14);
    // The four digits that IEC 61966-2-1 prints.
    const glm::dvec3 red = rgb_to_xyz({1, 0, 0}), x = xyz_to_rgb({1, 0, 0});
    EXPECT_NEAR(red.x, 0.4124, 5e-5);
    EXPECT_NEAR(red.y, 0.2126, 5e-5);
    EXPECT_NEAR(red.z, 0.0193, 5e-5);
    EXPECT_NEAR(x.r, 3.2406, 5e-4);
    EXPECT_NEAR(x.g, -0.9689, 5e-4);
    EXPECT_NEAR(x.b, 0.0557, 5e-4);
}

TEST(Observer, BandsAddUpToWhiteExactly) {
    for (int count = 1; count <= 64; ++count) {
        const auto bands = wavelength_bands(count);
        ASSERT_EQ(bands.size(), static_cast<std::size_t>(count));
        glm::dvec3 forwards(0.0), backwards(0.0);
        for (std::size_t i = 0; i < bands.size(); ++i) {
            forwards += bands[i].weight;
            backwards += bands[bands.size() - 1 - i].weight;
        }
        EXPECT_EQ(forwards, glm::dvec3(1.0)) << count;
        EXPECT_EQ(backwards, glm::dvec3(1.0)) << count;
    }
}

TEST(Observer, BandsCoverTheVisibleInOrder) {
    const auto bands = wavelength_bands(32);
    EXPECT_GE(bands.front().nanometres, 380.0);
    EXPECT_LE(bands.back().nanometres, 730.0);
    for (std::size_t i = 0; i < bands.size(); ++i) {
        const double from = 380.0 + 350.0 / 32 * static_cast<double>(i);
        EXPECT_GT(bands[i].nanometres, from);
        EXPECT_LT(bands[i].nanometres, from + 350.0 / 32);
    }
}

TEST(Observer, RainbowHasItsColours) {
    const auto dominant = [](double nm) {
        const glm::dvec3 rgb = xyz_to_rgb(cie_1931(nm));
        return rgb.r > rgb.g && rgb.r > rgb.b ? 'r' : rgb.g > rgb.b ? 'g' : 'b';
    };
    EXPECT_EQ(dominant(650.0), 'r');
    EXPECT_EQ(dominant(530.0), 'g');
    EXPECT_EQ(dominant(450.0), 'b');
    // Some weights are negative: spectral colours lie outside sRGB.
    const auto bands = wavelength_bands(16);
    EXPECT_TRUE(std::any_of(bands.begin(), bands.end(), [](const WavelengthBand& band) { return band.weight.r < 0.0; }));
}

struct Known {
    const char* name;
    double index_d;
    double abbe;
};

// n_d and V_d as the catalogues and papers print them.
TEST(Glass, IndexAndAbbeNumberOfTheCatalogue) {
    const Known known[] = {
        {"N-BK7", 1.51680, 64.17},   {"N-BAK4", 1.56883, 55.98},   {"N-BAF10", 1.67003, 47.11},      {"N-FK51A", 1.48656, 84.47},
        {"N-KZFS2", 1.55836, 54.01}, {"N-LAK33B", 1.75500, 52.30}, {"N-LASF9", 1.85025, 32.17},      {"N-SK16", 1.62041, 60.32},
        {"N-F2", 1.62005, 36.43},    {"F2", 1.62004, 36.37},       {"N-SF10", 1.72828, 28.53},       {"SF10", 1.72825, 28.41},
        {"N-SF11", 1.78472, 25.68},  {"SF11", 1.78472, 25.76},     {"fused silica", 1.45846, 67.82},
    };
    for (const Known& glass : known) {
        const auto found = find_glass(glass.name);
        ASSERT_TRUE(found) << glass.name;
        EXPECT_NEAR(found->index(line_d), glass.index_d, 6e-6) << glass.name;
        EXPECT_NEAR(abbe_number(*found), glass.abbe, 0.011) << glass.name;
    }
}

// The measured tables of water, 20 C [Daimon and Masumura 2007], sapphire, diamond, ice and acrylic at a few lines.
TEST(Glass, OtherMaterialsAgreeWithMeasurements) {
    const auto index = [](const char* name, double nm) { return find_glass(name).value().index(nm); };
    EXPECT_NEAR(index("water", line_g), 1.3405856, 2e-7);
    EXPECT_NEAR(index("water", line_f), 1.3374919, 2e-7);
    EXPECT_NEAR(index("water", line_d), 1.3334033, 2e-7);
    EXPECT_NEAR(index("water", line_c), 1.3315126, 2e-7);
    EXPECT_NEAR(index("fluorite", line_d), 1.4338, 1e-4);
    EXPECT_NEAR(abbe_number(find_glass("fluorite").value()), 95.2, 0.1);
    EXPECT_NEAR(index("sapphire", 589.3), 1.7681, 1e-4);
    EXPECT_NEAR(index("sapphire", 404.66), 1.7858, 1e-4);
    EXPECT_NEAR(index("diamond", 589.3), 2.4173, 3e-4);
    EXPECT_NEAR(index("diamond", line_f), 2.4356, 5e-4);
    EXPECT_NEAR(index("diamond", line_c), 2.4099, 5e-4);
    EXPECT_NEAR(index("ice", 400.0), 1.3194, 1.1e-4);
    EXPECT_NEAR(index("ice", 550.0), 1.3110, 1.1e-4);
    EXPECT_NEAR(index("ice", 700.0), 1.3069, 1.1e-4);
    EXPECT_NEAR(index("acrylic", line_f), 1.497, 1e-3);
    EXPECT_NEAR(index("acrylic", line_d), 1.491, 1e-3);
    EXPECT_NEAR(index("acrylic", 703.0), 1.486, 1e-3);
}

TEST(Glass, NamesAreForgiving) {
    for (const std::string& name : glass_names()) {
        EXPECT_TRUE(find_glass(name)) << name;
    }
    EXPECT_EQ(find_glass("n-bk7")->b, find_glass("N-BK7")->b);
    EXPECT_EQ(find_glass("Fused_Silica")->b, find_glass("fused silica")->b);
    EXPECT_EQ(find_glass("pmma")->b, find_glass("acrylic")->b);
    EXPECT_NE(find_glass("SF11")->b, find_glass("N-SF11")->b);
    EXPECT_FALSE(find_glass("unobtainium"));
    EXPECT_FALSE(find_glass(""));
}

// Normal dispersion: blue is bent more than red, everywhere in the visible.
TEST(Glass, IndexFallsWithWavelength) {
    for (const std::string& name : glass_names()) {
        const Sellmeier glass = find_glass(name).value();
        for (double nm = 380.0; nm < 780.0; nm += 10.0) {
            EXPECT_GT(glass.index(nm), glass.index(nm + 10.0)) << name << " at " << nm;
        }
    }
}

TEST(Glass, AbbeNumberGivesCauchy) {
    EXPECT_DOUBLE_EQ(abbe_index(1.5168, 64.17, line_d), 1.5168);
    EXPECT_NEAR((1.5168 - 1.0) / (abbe_index(1.5168, 64.17, line_f) - abbe_index(1.5168, 64.17, line_c)), 64.17, 1e-9);
    // Two numbers describe an ordinary glass well.
    const Sellmeier bk7 = find_glass("N-BK7").value();
    for (double nm = 420.0; nm <= 700.0; nm += 20.0) {
        EXPECT_NEAR(abbe_index(1.5168, 64.17, nm), bk7.index(nm), 6e-4) << nm;
    }
}

// Snell's law at both faces of a prism in the plane of incidence.
double prism_deviation(double index, double apex, double incidence) {
    const double inside = std::asin(std::sin(incidence) / index);
    return incidence + std::asin(index * std::sin(apex - inside)) - apex;
}

TEST(Glass, DeviationByAnEquilateralPrism) {
    const Sellmeier bk7 = find_glass("N-BK7").value();
    const double lines[][2] = {{line_g, 39.52249}, {line_f, 39.13905}, {line_e, 38.81590}, {line_d, 38.64670}, {line_c, 38.42932}};
    for (const auto& line : lines) {
        EXPECT_NEAR(prism_deviation(bk7.index(line[0]), 60.0 * degree, 49.32335 * degree) / degree, line[1], 2e-5) << line[0];
    }
}

}  // namespace
