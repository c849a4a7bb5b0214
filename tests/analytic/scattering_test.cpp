// Media that scatter, where the answer is known: fog that swallows nothing can't be seen in an even light, one scattering has a closed form, and a
// layer is held against adding and doubling.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "analytic/dice.h"
#include "analytic/fog.h"
#include "analytic/slab.h"

namespace lancer::tests {
namespace {

constexpr double pi = std::numbers::pi;
const glm::dvec3 none(0.0);

void expect_mean(const Mean& seen, double expected, double rounding) {
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(seen.value[i], expected, deviations * seen.error[i] + rounding * expected) << "channel " << i;
    }
}

std::vector<float> strewn(std::size_t count, std::uint64_t seed) {
    Dice dice(seed);
    std::vector<float> values;
    for (std::size_t i = 0; i < count; ++i) {
        values.push_back(static_cast<float>(std::max(dice.between(-0.5, 2.0), 0.0)));
    }
    return values;
}

// ---- The furnace ---------------------------------------------------------------------------------------------------------------------------

struct Fog {
    const char* name;
    scene::Color scattering;
    double asymmetry = 0.0;
    scene::Phase phase = scene::Phase::henyey_greenstein;
    int grid = 0;  // channels of one
};

class Furnace : public testing::TestWithParam<bool> {};  // whether as RGB

TEST_P(Furnace, HidesFogThatSwallowsNothing) {
    const scene::Spectrum steep{scene::MeasuredSpectrum{{400.0, 700.0}, {3.0, 0.05}}, 1.0, std::nullopt};
    const Fog fogs[] = {{"thin", scene::Rgb(0.3)},
                        {"thick", scene::Rgb(4.0)},
                        {"colored", scene::Rgb(0.1, 1.0, 4.0)},
                        {"of a steep spectrum", scene::Color(steep)},
                        {"clear to red", scene::Rgb(0.0, 0.5, 3.0)},
                        {"forwards", scene::Rgb(3.0), 0.9},
                        {"backwards", scene::Rgb(1.0, 2.0, 3.0), -0.6},
                        {"of air", scene::Rgb(0.4, 1.0, 2.5), 0.0, scene::Phase::rayleigh},
                        {"in a grid", scene::Rgb(3.0), 0.3, scene::Phase::henyey_greenstein, 1},
                        {"colored in a grid", scene::Rgb(0.1, 1.0, 4.0), 0.0, scene::Phase::henyey_greenstein, 1},
                        {"in a grid of colors", scene::Rgb(1.0), 0.0, scene::Phase::henyey_greenstein, 3}};
    for (const Fog& fog : fogs) {
        SCOPED_TRACE(fog.name);
        for (const bool glass : {false, true}) {
            SCOPED_TRACE(glass ? "in glass" : "in a null border");
            FogWorld world(1000);
            world.scene.settings.rgb = GetParam();
            world.set_background(1.0, 1.0, 1.0);
            scene::Medium medium = medium_of(none, fog.scattering, fog.asymmetry);
            medium.phase = fog.phase;
            if (fog.grid > 0) {
                medium.density = grid_of({11, 12, 13}, strewn(11u * 12u * 13u * static_cast<std::size_t>(fog.grid), 7), glm::dvec3(-1.1),
                                         glm::dvec3(1.0, 1.1, 1.2), fog.grid);
            }
            int border = world.border(medium);
            if (glass) {
                scene::Material body;
                body.model = scene::DielectricMaterial{.refraction = 1.3};
                body.interior = world.scene.materials[static_cast<std::size_t>(border)].interior;
                border = world.material(body);
            }
            world.add(scene::Sphere{}, border);
            const Mean seen = world.see(150);
            // Rounding of the media's exponentials, some hundred scatterings long. A wavelength's light is not a colour's: wavelengths that are
            // drawn together are only even together, and the picture is as noisy as they are few.
            expect_mean(seen, 1.0, GetParam() ? 2e-4 : 1e-3);
            EXPECT_LT(seen.error.y, 0.05);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Media, Furnace, testing::Values(true, false), [](const auto& one) { return one.param ? "Rgb" : "Spectral"; });

// A lamp that is asked for, and met by itself, from within fog: both ways together are right for each. A wall all around that shines evenly.
TEST(Scattering, FindsLampsBothWays) {
    const double radiance = 2.0;
    for (const bool everywhere : {false, true}) {
        for (const scene::DirectSamples ways : {scene::DirectSamples::mis, scene::DirectSamples::emitter, scene::DirectSamples::bsdf}) {
            FogWorld world(1);
            world.scene.settings.integrator = "direct";
            world.scene.settings.direct_samples = ways;
            scene::Material lamp;
            lamp.model = scene::DiffuseMaterial{scene::Rgb(0.0), 0.0};
            lamp.emission = scene::Emission{scene::Color(scene::Rgb(radiance))};
            world.look({0.0, 0.0, 5.0}, {0.0, 0.0, -1.0});
            world.add(scene::Sphere{{0.0, 3.0, 0.0}, 1.5}, world.material(lamp));
            const scene::Medium medium = medium_of(scene::Rgb(0.1, 0.2, 0.3), scene::Rgb(0.4, 0.3, 0.2), 0.4);
            if (everywhere) {
                world.scene.medium = world.medium(medium);
            } else {
                world.add(scene::Sphere{{0.0, 1.0, 0.0}, 9.0}, world.border(medium));
            }
            // By quadrature: along the view, over the lamp's cone.
            const double extinction = 0.5;
            double expected = 0.0;
            constexpr int along = 4000, rings = 60, turns = 60;
            const double end = everywhere ? 40.0 : 5.0 + std::sqrt(81.0 - 1.0);
            for (int i = 0; i < along; ++i) {
                const double t = end * (i + 0.5) / along;
                const glm::dvec3 p(0.0, 0.0, 5.0 - t), way = glm::dvec3(0.0, 3.0, 0.0) - p;
                const double distance = glm::length(way), cos_most = std::sqrt(1.0 - 2.25 / (distance * distance));
                const glm::dvec3 axis = way / distance, side = glm::normalize(glm::cross(axis, glm::dvec3(1.0, 0.2, 0.1)));
                const glm::dvec3 other = glm::cross(axis, side);
                double light = 0.0;
                for (int j = 0; j < rings; ++j) {
                    const double cosine = 1.0 - (1.0 - cos_most) * (j + 0.5) / rings, sine = std::sqrt(1.0 - cosine * cosine);
                    const double near = distance * cosine - std::sqrt(std::max(2.25 - distance * distance * sine * sine, 0.0));
                    for (int k = 0; k < turns; ++k) {
                        const double around = 2.0 * pi * (k + 0.5) / turns;
                        const double z = axis.z * cosine + (side.z * std::cos(around) + other.z * std::sin(around)) * sine;
                        const double g = 0.4, d = 1.0 + g * g - 2.0 * g * -z;
                        light += (1.0 - g * g) / (4.0 * pi * d * std::sqrt(d)) * std::exp(-extinction * near);
                    }
                }
                light *= radiance * 2.0 * pi * (1.0 - cos_most) / (rings * turns);
                expected += std::exp(-extinction * t) * light * end / along;
            }
            const Mean seen = world.see(6000);
            for (int i = 0; i < 3; ++i) {
                const double scattering = 0.4 - 0.1 * i;
                EXPECT_NEAR(seen.value[i], scattering * expected, deviations * seen.error[i] + 5e-4 * scattering * expected)
                    << "channel " << i << ", ways " << int(ways) << (everywhere ? ", everywhere" : "");
            }
        }
    }
}

// ---- Layers ----------------------------------------------------------------------------------------------------------------------------------

// 1 m thick from y = -1 to 0 and very wide, lit straight from above, seen under a cosine from above or from below.
FogWorld layer(const scene::Medium& medium, double cosine, bool from_above, int bounces) {
    FogWorld world(bounces);
    world.add(scene::Box{{-1000.0, -1.0, -1000.0}, {1000.0, 0.0, 1000.0}}, world.border(medium));
    world.add_light(scene::DirectionalLight{{0.0, -1.0, 0.0}}, 1.0);
    world.scene.lights[0].power = scene::Color(scene::Rgb(1.0));
    const double sine = std::sqrt(1.0 - cosine * cosine), up = from_above ? 1.0 : -1.0;
    world.look({0.0, -0.5 + 3.0 * cosine * up, 3.0 * sine}, {0.0, -cosine * up, -sine}, {0.0, 1.0, 0.3});
    return world;
}

scene::Medium even_grid(scene::Medium medium) {
    medium.density = grid_of({2, 2, 2}, std::vector<float>(8, 1.0f), {-1000.0, -1.0, -1000.0}, {1000.0, 0.0, 1000.0});
    return medium;
}

// Of light that is scattered once.
TEST(Scattering, OnceIsAsTheClosedFormSays) {
    const glm::dvec3 extinction(0.3, 1.0, 3.0), albedo(0.9, 0.6, 0.4);
    for (const double cosine : {0.3, 0.8}) {
        for (const int kind : {0, 1, 2, 3}) {
            scene::Medium medium = medium_of(extinction * (1.0 - albedo), extinction * albedo, kind == 1 ? 0.6 : 0.0);
            medium.phase = kind == 2 ? scene::Phase::rayleigh : scene::Phase::henyey_greenstein;
            medium = kind == 3 ? even_grid(medium) : medium;
            for (const bool above : {true, false}) {
                const double turn = above ? -cosine : cosine;  // straight down, then up or down to the eye
                const double g = 0.6, d = 1.0 + g * g - 2.0 * g * turn;
                const double phase = kind == 1   ? (1.0 - g * g) / (4.0 * pi * d * std::sqrt(d))
                                     : kind == 2 ? 3.0 / (16.0 * pi) * (1.0 + turn * turn)
                                                 : 1.0 / (4.0 * pi);
                const Mean seen = layer(medium, cosine, above, 1).see(kind == 3 ? 4000 : 2000);
                for (int i = 0; i < 3; ++i) {
                    const double t = extinction[i];
                    const double above_all = (1.0 - std::exp(-t * (1.0 + 1.0 / cosine))) / (1.0 + cosine);
                    const double below_all = (std::exp(-t) - std::exp(-t / cosine)) / (1.0 - cosine);
                    const double expected = albedo[i] * phase * (above ? above_all : below_all);
                    EXPECT_NEAR(seen.value[i], expected, deviations * seen.error[i] + 2e-4 * expected)
                        << "cosine " << cosine << ", kind " << kind << (above ? ", above" : ", below") << ", channel " << i;
                }
            }
        }
    }
}

TEST(Scattering, AnyNumberOfTimesIsAsAddingAndDoublingSays) {
    for (const double asymmetry : {0.0, 0.6}) {
        for (const double cosine : {0.25, 0.9}) {
            for (const bool grid : {false, true}) {
                const glm::dvec3 extinction(0.5, 2.0, 6.0), albedo(0.95, 0.8, 0.99);
                scene::Medium medium = medium_of(extinction * (1.0 - albedo), extinction * albedo, asymmetry);
                medium = grid ? even_grid(medium) : medium;
                const Mean above = layer(medium, cosine, true, 400).see(600), below = layer(medium, cosine, false, 400).see(600);
                for (int i = 0; i < 3; ++i) {
                    const SlabLight light = light_of_slab({extinction[i], albedo[i], asymmetry}, cosine);
                    EXPECT_NEAR(above.value[i], light.reflected, deviations * above.error[i] + 1e-3 * light.reflected)
                        << asymmetry << " " << cosine << " " << grid << " " << i;
                    EXPECT_NEAR(below.value[i], light.transmitted, deviations * below.error[i] + 1e-3 * light.transmitted)
                        << asymmetry << " " << cosine << " " << grid << " " << i;
                }
            }
        }
    }
}

// The comparison's own: a layer that swallows nothing sends all light on.
TEST(Slab, LosesNothing) {
    const SlabLight thin = light_of_slab({1e-3, 1.0, 0.0}, 0.5);
    EXPECT_NEAR(thin.reflected, 1e-3 / (4.0 * pi) / 0.5, 1e-6);
    EXPECT_NEAR(thin.transmitted, 1e-3 / (4.0 * pi) / 0.5, 1e-6);
    // By Simpson's rule over the cosines, for irradiance 1.
    double sum = std::exp(-2.0);
    constexpr int steps = 40;
    for (int i = 0; i <= steps; ++i) {
        const double cosine = std::max(1.0 * i / steps, 1e-3);
        const SlabLight light = light_of_slab({2.0, 1.0, 0.5}, cosine);
        const double weight = (i == 0 || i == steps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) / (3.0 * steps);
        sum += weight * 2.0 * pi * cosine * (light.reflected + light.transmitted);
    }
    EXPECT_NEAR(sum, 1.0, 1e-3);
}

// ---- Grids and even media ----------------------------------------------------------------------------------------------------------------------

// The same fog, evenly and in a grid with blocks that say little: by chance the same picture.
TEST(Scattering, GridsAreAsEvenMedia) {
    const auto scene = [](bool grid, bool rgb) {
        FogWorld world(50);
        world.scene.settings.rgb = rgb;
        scene::Medium medium = medium_of(scene::Rgb(0.3, 0.2, 0.1), scene::Rgb(1.0, 2.0, 3.0), 0.5);
        if (grid) {
            // One cell far away from the ball, in its block, is denser.
            std::vector<float> values(8 * 8 * 8, 1.0f);
            values[0] = 4.0f;
            medium.density = grid_of({8, 8, 8}, values, glm::dvec3(-6.0), glm::dvec3(6.0));
        }
        world.add(scene::Sphere{}, world.border(medium));
        world.add_light(scene::PointLight{{3.0, 2.0, 1.0}}, 1.0);
        world.scene.lights[0].power = scene::Color(scene::Rgb(10.0));
        world.set_background(0.2, 0.1, 0.0);
        return world.see(1500);
    };
    for (const bool rgb : {true, false}) {
        const Mean even = scene(false, rgb), grid = scene(true, rgb);
        for (int i = 0; i < 3; ++i) {
            EXPECT_NEAR(even.value[i], grid.value[i], deviations * std::hypot(even.error[i], grid.error[i])) << rgb << " " << i;
            EXPECT_LT(even.error[i], 0.02 * even.value[i]);
        }
    }
}

// Grids of the albedo: half white, half black, along the view.
TEST(Scattering, AlbedoMayBeAGrid) {
    FogWorld world(1);
    scene::Medium medium;
    medium.coefficients = scene::ExtinctionAlbedo{scene::Rgb(1.0), scene::Rgb(0.0)};
    medium.density = grid_of({1, 1, 1}, {1.0f}, {-1000.0, -1.0, -1000.0}, {1000.0, 0.0, 1000.0});
    medium.albedo = grid_of({1, 2, 1}, {0.2f, 0.4f, 0.6f, 0.2f, 0.4f, 0.6f}, {-1000.0, -1.0, -1000.0}, {1000.0, 0.0, 1000.0}, 3);
    for (const bool rgb : {true, false}) {
        world = layer(medium, 0.5, true, 1);
        world.scene.settings.rgb = rgb;
        const Mean seen = world.see(4000);
        for (int i = 0; i < 3; ++i) {
            const double expected = (0.2 + 0.2 * i) / (4.0 * pi) * (1.0 - std::exp(-3.0)) / 1.5;
            EXPECT_NEAR(seen.value[i], expected, deviations * seen.error[i] + 1e-3 * expected) << rgb << " " << i;
        }
    }
}

}  // namespace
}  // namespace lancer::tests
