// The computed sky: against published values, conservation of energy, and single photons followed through flat layers.
#include "lancer/spectrum/atmosphere.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "lancer/scene/sun_position.h"
#include "lancer/spectrum/atmosphere_layers.h"
#include "lancer/spectrum/curve.h"
#include "lancer/spectrum/sun.h"

namespace lancer {
namespace {

using std::numbers::pi;

constexpr double degree = pi / 180.0;

// ---- The sun's place -----------------------------------------------------------------------------------------------------------------------

// The example of [Reda and Andreas 2004, table A4.1]: 17 October 2003, 12:30:30 local time, 7 hours behind, at 39.742476 N, 105.1786 W. Its elevation is
// without refraction 39.872046; the formulas here are good for 0.01 degrees.
TEST(SunPosition, AgreesWithThePublishedExample) {
    const auto days = scene::days_since_2000("2003-10-17T12:30:30-07:00");
    ASSERT_TRUE(days);
    const scene::SunPosition sun = scene::sun_position(*days, 39.742476, -105.1786);
    EXPECT_NEAR(sun.elevation, 39.872046, 0.012);
    EXPECT_NEAR(sun.azimuth, 194.340241, 0.012);
    EXPECT_NEAR(sun.distance, 0.9965422974, 2e-4);
}

TEST(SunPosition, FollowsTheYear) {
    // At the equinox on the equator overhead at noon, at the solstices 23.44 degrees off: noon by the sun is some minutes off the clock's.
    double highest = 0.0;
    for (int minute = 0; minute < 60; ++minute) {
        const auto days = scene::days_since_2000("2025-06-21T11:30:00Z");
        highest = std::max(highest, scene::sun_position(*days + minute / 1440.0, 0.0, 0.0).elevation);
    }
    EXPECT_NEAR(highest, 90.0 - 23.44, 0.02);
    // In the north it rises in the east and sets in the west.
    EXPECT_NEAR(scene::sun_position(*scene::days_since_2000("2025-03-20T06:07:00Z"), 40.0, 0.0).azimuth, 90.0, 1.0);
    EXPECT_NEAR(scene::sun_position(*scene::days_since_2000("2025-03-20T18:07:00Z"), 40.0, 0.0).azimuth, 270.0, 1.0);
}

TEST(SunPosition, ReadsTimes) {
    EXPECT_EQ(scene::days_since_2000("2000-01-01T12:00:00Z"), 0.0);
    EXPECT_EQ(scene::days_since_2000("2000-01-01 12:00"), 0.0);
    EXPECT_EQ(scene::days_since_2000("2000-03-01T14:00:00+02:00"), 60.0);
    EXPECT_EQ(scene::days_since_2000("1999-12-31T12:00Z"), -1.0);
    for (const char* wrong : {"", "today", "2000-13-01T12:00Z", "2001-02-29T12:00Z", "2000-01-01T24:00Z", "2000-01-01", "1900-01-01T12:00Z",
                              "2000-01-01T12:00+2", "2000-01-01T12:00Zx"}) {
        EXPECT_FALSE(scene::days_since_2000(wrong)) << wrong;
    }
}

TEST(SunPosition, PointsWhereTheCompassDoes) {
    const glm::dvec3 east = scene::sun_direction(0.0, 90.0, 0.0);  // -z looks north, +x east
    EXPECT_NEAR(east.x, 1.0, 1e-12);
    const glm::dvec3 turned = scene::sun_direction(0.0, 90.0, 90.0);  // -z looks east
    EXPECT_NEAR(turned.z, -1.0, 1e-12);
    EXPECT_NEAR(scene::sun_direction(30.0, 200.0, 10.0).y, 0.5, 1e-12);
}

// ---- The air -------------------------------------------------------------------------------------------------------------------------------

// [Bodhaine et al. 1999, table 3]: optical depths of air at sea level; the formula used here is within 2 % of them.
TEST(Atmosphere, MoleculesAreAsDenseAsPublished) {
    EXPECT_NEAR(molecular_depth(400.0), 0.36022, 0.02 * 0.36022);
    EXPECT_NEAR(molecular_depth(550.0), 0.09719, 0.02 * 0.09719);
    EXPECT_NEAR(molecular_depth(700.0), 0.03647, 0.02 * 0.03647);
}

// Through flat layers the sun at 30 degrees goes twice the way: there its light is exp(-2 depth). At the horizon, round the earth, about 38 times
// [Kasten and Young 1989].
TEST(Atmosphere, SunComesThroughAsMuchAirAsPublished) {
    const Atmosphere pure(1.0, 0.0, 0.0, {550.0});
    const double depth = molecular_depth(550.0) + haze_depth(1.0, 550.0);
    for (const double elevation : {90.0, 30.0, 10.0, 5.0, 1.0, 0.0}) {
        const double mass = -std::log(pure.sun_transmittance(elevation * degree)[0]) / depth;
        const double published = 1.0 / (std::sin(elevation * degree) + 0.50572 * std::pow(elevation + 6.07995, -1.6364));
        // Theirs is with refraction, which bends light into less air near the horizon: up to 8 % there.
        EXPECT_NEAR(mass / published, 1.0, elevation < 5.0 ? 0.08 : elevation < 10.0 ? 0.02 : 0.01) << elevation;
    }
}

// [Bird and Riordan 1984, eq. 2-1], written down again: direct light at an air mass of 2.
TEST(Atmosphere, DirectLightIsThatOfTheReport) {
    const std::vector<double> nanometres = {400.0, 500.0, 600.0};
    const Atmosphere air(3.0, 0.3, 0.2, nanometres);
    const std::vector<double> left = air.sun_transmittance(30.0 * degree);
    const double ozone[] = {0.0, 0.03, 0.12};
    for (std::size_t i = 0; i < nanometres.size(); ++i) {
        const double um = nanometres[i] * 1e-3;
        const double rayleigh = std::exp(-2.0 / (std::pow(um, 4.0) * (115.6406 - 1.335 / (um * um))));
        const double haze = std::exp(-2.0 * (0.04608 * 3.0 - 0.04586) * std::pow(um, -1.3));
        EXPECT_NEAR(left[i], rayleigh * haze * std::exp(-2.0 * 0.3 * ozone[i]), 0.01 * left[i]) << nanometres[i];
    }
}

// ---- Light that is scattered many times ------------------------------------------------------------------------------------------------------

AirLayers some_layers(double sun_cosine, double ground, double albedo) {
    AirLayers air;
    air.sun_cosine = sun_cosine;
    air.ground = ground;
    double above = 0.0;
    air.sunlight.push_back(1.0);
    for (int i = 0; i < 24; ++i) {
        air.depth.push_back(0.03);
        air.scattered.push_back(albedo);
        air.molecular.push_back(i < 8 ? 0.4 : 0.9);
    }
    for (int i = 24; i-- > 0;) {
        above += 0.03 / sun_cosine;
        air.sunlight.insert(air.sunlight.begin(), std::exp(-above));
    }
    return air;
}

// Nothing is absorbed: what comes in leaves at the top or stays in a ground that scatters only part of it back.
TEST(AtmosphereLayers, KeepEnergy) {
    for (const double sun : {1.0, 0.5, 0.2}) {
        for (const double ground : {0.0, 0.5, 1.0}) {
            const ScatteringModes modes(sun, 0.65, {0.5});
            const ManyTimesScattered light = modes.scatter(some_layers(sun, ground, 1.0));
            const double swallowed = (1.0 - ground) * (light.down + light.direct_down);
            // Of the trapezoid rule over layers of depth 0.03, seen at low angles.
            EXPECT_NEAR((light.up + swallowed) / sun, 1.0, 4e-3) << sun << ", " << ground;
        }
    }
}

// The same by single photons: a z-test at 5 standard errors, six of them.
TEST(AtmosphereLayers, AgreeWithPhotons) {
    std::mt19937 numbers(5);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (const double sun : {0.9, 0.3}) {
        for (const double ground : {0.0, 0.3, 0.8}) {
            const AirLayers air = some_layers(sun, ground, 0.95);
            const double all = 24 * 0.03;
            constexpr int photons = 200000;
            int landed = 0, left = 0, landed_unscattered = 0;
            for (int i = 0; i < photons; ++i) {
                double place = all;  // optical depth above the ground
                double x = std::sqrt(1.0 - sun * sun), y = 0.0, z = -sun;
                int events = 0;
                for (;;) {
                    place += -std::log(1.0 - uniform(numbers)) * z;
                    if (place >= all) {
                        ++left;
                        break;
                    }
                    double cosine = 0.0;
                    if (place <= 0.0) {
                        landed += events > 0 ? 1 : 0;
                        landed_unscattered += events == 0 ? 1 : 0;
                        ++events;
                        if (uniform(numbers) >= ground) {
                            break;
                        }
                        place = 0.0;
                        z = std::sqrt(uniform(numbers));
                        const double turn = 2.0 * pi * uniform(numbers);
                        x = std::sqrt(1.0 - z * z) * std::cos(turn);
                        y = std::sqrt(1.0 - z * z) * std::sin(turn);
                        continue;
                    }
                    ++events;
                    const auto layer = std::min(static_cast<std::size_t>(place / 0.03), std::size_t{23});
                    if (uniform(numbers) >= air.scattered[layer]) {
                        break;
                    }
                    if (uniform(numbers) < air.molecular[layer]) {
                        do {
                            cosine = 2.0 * uniform(numbers) - 1.0;
                        } while (2.0 * uniform(numbers) > 1.0 + cosine * cosine);
                    } else {
                        const double g = 0.65, t = (1.0 - g * g) / (1.0 - g + 2.0 * g * uniform(numbers));
                        cosine = (1.0 + g * g - t * t) / (2.0 * g);
                    }
                    const double sine = std::sqrt(std::max(1.0 - cosine * cosine, 0.0)), turn = 2.0 * pi * uniform(numbers);
                    const double ring = std::sqrt(std::max(x * x + y * y, 1e-18));
                    const double a = sine * std::cos(turn), b = sine * std::sin(turn);
                    const double nx = cosine * x + a * x * z / ring - b * y / ring, ny = cosine * y + a * y * z / ring + b * x / ring;
                    z = cosine * z - a * ring;
                    x = nx;
                    y = ny;
                }
            }
            const ScatteringModes modes(sun, 0.65, {0.5});
            const ManyTimesScattered light = modes.scatter(air);
            const double n = photons;
            const double out = left / n, down = landed / n;
            // Photons may land more often than once; their number's variance is at most about twice that of single events.
            EXPECT_NEAR(light.up / sun, out, 5.0 * std::sqrt(out * (1.0 - out) / n) + 4e-3 * out) << sun << ", " << ground;
            EXPECT_NEAR(light.down / sun, down, 5.0 * std::sqrt(2.0 * down / n) + 4e-3 * down) << sun << ", " << ground;
            EXPECT_NEAR(light.direct_down / sun, landed_unscattered / n, 5.0 * std::sqrt(0.25 / n));
        }
    }
}

// ---- The whole sky -------------------------------------------------------------------------------------------------------------------------

constexpr double lux = 683.0 * 106.857;  // of a light of 1 W/(m^2 nm) at each wavelength: luminous efficacy times the integral of V

struct Seen {
    double direct = 0.0;    // at right angles to the sun
    double sky = 0.0;       // on level ground, by flat layers
    double gathered = 0.0;  // and by what is seen of the sky
    double zenith = 0.0;    // cd/m^2
    double away = 0.0;      // at 45 degrees, away from the sun
    glm::dvec2 white{0.0};  // the zenith's chromaticity
};

Seen look(double elevation, double turbidity, double ground = 0.2) {
    std::vector<double> nanometres;
    for (int i = 0; i < 9; ++i) {
        nanometres.push_back(360.0 + 60.0 * i);
    }
    const Atmosphere air(turbidity, 0.3, ground, nanometres);
    constexpr int azimuths = 13, elevations = 21;
    const SkyShares shares = air.sky(elevation * degree, azimuths, elevations);
    const auto light = [&](const double* share) {
        std::vector<double> values;
        for (std::size_t i = 0; i < nanometres.size(); ++i) {
            values.push_back(share[i] * sun_outside_air().at(nanometres[i]));
        }
        return SpectralCurve(nanometres, values, SpectralCurve::Beyond::constant);
    };
    const auto luminance = [&](const double* share) { return to_xyz(light(share)).y * lux; };
    const auto at = [&](int a, int e) { return &shares.radiance[static_cast<std::size_t>(a * elevations + e) * nanometres.size()]; };
    Seen seen;
    const std::vector<double> left = air.sun_transmittance(elevation * degree);
    seen.direct = luminance(left.data());
    seen.sky = luminance(shares.sky.data());
    seen.zenith = luminance(at(0, elevations - 1));
    seen.away = luminance(at(azimuths - 1, 14));
    seen.white = chromaticity(to_xyz(light(at(0, elevations - 1))));
    // By the trapezoid rule in both.
    for (int a = 0; a < azimuths; ++a) {
        for (int e = 0; e < elevations; ++e) {
            const auto angle = [&](double i) { return 0.5 * pi * std::pow(i / (elevations - 1), 2.0); };
            const double from = angle(std::max(e - 0.5, 0.0)), to = angle(std::min(e + 0.5, elevations - 1.0));
            const double rises = 0.5 * (std::pow(std::sin(to), 2.0) - std::pow(std::sin(from), 2.0));
            const double turns = 2.0 * pi / (azimuths - 1) * (a == 0 || a == azimuths - 1 ? 0.5 : 1.0);
            seen.gathered += luminance(at(a, e)) * rises * turns;
        }
    }
    return seen;
}

// What is seen of the sky lights the ground as much as the flat layers say: round and flat air agree where the sun stands high.
TEST(Atmosphere, WhatIsSeenLightsTheGround) {
    for (const double elevation : {60.0, 25.0}) {
        const Seen seen = look(elevation, 3.0);
        EXPECT_NEAR(seen.gathered / seen.sky, 1.0, 0.03) << elevation;
    }
}

// Illuminances under the clear sky of lighting engineers [IES 1984], a mean of measurements that scatter by a factor of two; the sky here has the turbidity at
// which the sun is as bright as theirs. And the zenith's luminance [Krochmann and Seidl 1974].
TEST(Atmosphere, ClearSkyIsAsBrightAsMeasured) {
    EXPECT_NEAR(to_xyz(sun_outside_air()).y * lux, 127.5e3, 0.05 * 127.5e3);
    for (const double elevation : {20.0, 35.0, 50.0, 65.0}) {
        const Seen seen = look(elevation, 2.2);
        const double rises = std::sin(elevation * degree);
        EXPECT_NEAR(seen.direct / (127.5e3 * std::exp(-0.21 / rises)), 1.0, 0.07) << elevation;
        EXPECT_NEAR(seen.sky / (800.0 + 15500.0 * std::sqrt(rises)), 1.0, 0.3) << elevation;
        if (elevation < 60.0) {
            const double zenith = 100.0 + 63.0 * elevation + elevation * (elevation - 30.0) * std::exp(0.0346 * (elevation - 68.0));
            EXPECT_NEAR(seen.zenith / zenith, 1.0, 0.3) << elevation;
        }
    }
}

// Clear zeniths are blue: correlated colour temperatures of 10 000 K and far more, x and y below daylight's of 10 000 K. Haze makes them paler.
TEST(Atmosphere, ClearSkiesAreBlue) {
    const Seen clear = look(45.0, 2.0), hazy = look(45.0, 8.0);
    EXPECT_LT(clear.white.x, 0.279);
    EXPECT_LT(clear.white.y, 0.292);
    EXPECT_GT(clear.white.x, 0.22);
    EXPECT_GT(hazy.white.x, clear.white.x + 0.01);
    EXPECT_GT(hazy.zenith, clear.zenith);
}

// Brighter ground lights the sky; after sunset there is light left, of which each degree takes more than a third.
TEST(Atmosphere, GroundAndTwilightCount) {
    EXPECT_GT(look(40.0, 3.0, 0.8).zenith, 1.05 * look(40.0, 3.0, 0.0).zenith);
    const double sunset = look(0.0, 3.0).zenith, later = look(-3.0, 3.0).zenith, last = look(-6.0, 3.0).zenith;
    EXPECT_GT(sunset, 50.0);  // measured: some 100 to 700 cd/m^2
    EXPECT_LT(sunset, 2000.0);
    EXPECT_LT(later, 0.6 * sunset);
    EXPECT_GT(later, 0.0);
    EXPECT_LT(last, 0.6 * later);
    EXPECT_GT(last, 0.0);
}

}  // namespace
}  // namespace lancer
