#include <gtest/gtest.h>

#include <cmath>

#include "lancer/spectrum/illuminant.h"
#include "lancer/spectrum/sensor.h"

namespace lancer {
namespace {

struct White {
    const char* name;
    double x, y;
};

// [CIE 15:2004, tables T.3 and T.8] print five digits and four.
TEST(Illuminant, WhitePointsToFiveDigits) {
    const White whites[] = {
        {"A", 0.44758, 0.40745},   {"C", 0.31006, 0.31616},   {"D50", 0.34567, 0.35851},
        {"D55", 0.33243, 0.34744}, {"D65", 0.31272, 0.32903}, {"D75", 0.29903, 0.31488},
    };
    for (const White& white : whites) {
        const glm::dvec2 xy = chromaticity(to_xyz_by_sums(find_illuminant(white.name).value()));
        EXPECT_NEAR(xy.x, white.x, 6e-6) << white.name;
        EXPECT_NEAR(xy.y, white.y, 6e-6) << white.name;
    }
    const White fluorescents[] = {
        {"FL1", 0.3131, 0.3371}, {"FL2", 0.3721, 0.3751}, {"FL3", 0.4091, 0.3941},  {"FL4", 0.4402, 0.4031},
        {"FL5", 0.3138, 0.3452}, {"FL6", 0.3779, 0.3882}, {"FL7", 0.3129, 0.3292},  {"FL8", 0.3458, 0.3586},
        {"FL9", 0.3741, 0.3727}, {"F10", 0.3458, 0.3588}, {"FL11", 0.3805, 0.3769}, {"FL12", 0.4370, 0.4042},
    };
    for (const White& white : fluorescents) {
        const glm::dvec2 xy = chromaticity(to_xyz_by_sums(find_illuminant(white.name).value()));
        EXPECT_NEAR(xy.x, white.x, 6e-5) << white.name;
        EXPECT_NEAR(xy.y, white.y, 6e-5) << white.name;
    }
}

// Values of the tables that the standards print, to half of their last digit.
TEST(Illuminant, FormulasGiveTheTables) {
    const SpectralCurve a = find_illuminant("A").value(), d50 = find_illuminant("D50").value(), d65 = find_illuminant("CIE D65").value();
    EXPECT_NEAR(a.at(300), 0.930483, 5e-7);
    EXPECT_NEAR(a.at(560), 100.0, 1e-12);
    EXPECT_NEAR(a.at(780), 241.675, 5e-4);
    EXPECT_NEAR(d65.at(300), 0.0341, 5e-5);
    EXPECT_NEAR(d65.at(395), 68.7015, 5.1e-5);
    EXPECT_NEAR(d65.at(460), 117.812, 5e-4);
    EXPECT_NEAR(d65.at(780), 63.3828, 5e-5);
    EXPECT_NEAR(d50.at(380), 24.488, 5.1e-4);
    EXPECT_NEAR(d50.at(700), 91.604, 5.1e-4);
}

// Wien's law for where a black body is brightest, and Stefan and Boltzmann's for all of it.
TEST(Illuminant, BlackbodyRadiatesAsThermodynamicsAsks) {
    for (const double kelvin : {3000.0, 5778.0, 9000.0}) {
        const double peak = 2.897771955e6 / kelvin;
        EXPECT_GT(blackbody_radiance(kelvin, peak), blackbody_radiance(kelvin, peak * 1.01));
        EXPECT_GT(blackbody_radiance(kelvin, peak), blackbody_radiance(kelvin, peak / 1.01));
        // Over the logarithm of the wavelength, from a hundredth to a thousand times that of the peak.
        double sum = 0.0;
        const double step = 1e-3;
        for (double u = std::log(0.01); u < std::log(1000.0); u += step) {
            const double nm = peak * std::exp(u);
            sum += blackbody_radiance(kelvin, nm) * nm * step;
        }
        EXPECT_NEAR(sum * 3.14159265358979 / (5.670374419e-8 * std::pow(kelvin, 4.0)), 1.0, 1e-6);
    }
    EXPECT_NEAR(chromaticity(to_xyz(blackbody(2856.0))).x, 0.4476, 1e-4);  // illuminant A's
    EXPECT_NEAR(chromaticity(to_xyz(blackbody(2856.0))).y, 0.4074, 1e-4);
    EXPECT_EQ(blackbody_radiance(10.0, 300.0), 0.0);  // too little for a double
    for (double kelvin = 1.0; kelvin < 1e6; kelvin *= 1.1) {
        EXPECT_TRUE(std::isfinite(with_unit_luminance(blackbody(kelvin)).highest())) << kelvin;
    }
}

TEST(Illuminant, DaylightFollowsItsLocus) {
    for (const double kelvin : {4000.0, 5500.0, 6999.0, 7001.0, 15000.0, 25000.0}) {
        const glm::dvec2 xy = chromaticity(to_xyz(daylight(kelvin)));
        EXPECT_NEAR(xy.y, (-3.0 * xy.x + 2.870) * xy.x - 0.275, 3e-4) << kelvin;
        EXPECT_GE(daylight(kelvin).lowest(), 0.0) << kelvin;
    }
    EXPECT_EQ(daylight(100.0).values(), daylight(4000.0).values());
    EXPECT_EQ(daylight(1e9).values(), daylight(25000.0).values());
    EXPECT_NEAR(daylight(7000.0).at(400), daylight(7000.5).at(400), 0.2);
}

TEST(Sensor, D65IsWhiteAndGreyStaysGrey) {
    const glm::dvec3 white = to_rgb(unit_d65()), grey = reflected_rgb(SpectralCurve(0.18));
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(white[c], 1.0, 1e-13);
        EXPECT_NEAR(grey[c], 0.18, 1e-13);
    }
    // By the trapezoidal rule at each nanometre.
    glm::dvec3 sum(0.0);
    for (int nm = 360; nm <= 830; ++nm) {
        sum += unit_d65().at(nm) * sensor_weight(nm) * (nm == 360 || nm == 830 ? 0.5 : 1.0);
    }
    const glm::dvec2 xy = chromaticity(to_xyz(unit_d65()));
    EXPECT_NEAR(xy.x, 0.3127, 1e-4);
    EXPECT_NEAR(xy.y, 0.3290, 1e-4);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(sum[c], 1.0, 2e-5);  // the product of two straight lines is none
    }
}

TEST(Illuminant, Names) {
    for (const std::string& name : illuminant_names()) {
        EXPECT_TRUE(find_illuminant(name)) << name;
    }
    EXPECT_EQ(find_illuminant("cie d-65")->values(), find_illuminant("D65")->values());
    for (const char* unknown : {"", "G", "D", "D65x", "D9", "D251", "FL0", "FL13", "F", "D99999999999999"}) {
        EXPECT_FALSE(find_illuminant(unknown)) << unknown;
    }
    EXPECT_NEAR(to_xyz(unit_d65()).y, 1.0, 1e-14);
}

}  // namespace
}  // namespace lancer
