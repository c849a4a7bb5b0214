// Spectra through the whole path integrator: what is known of a light or of a colour comes out of the picture again.
#include <array>
#include <cmath>
#include <memory>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "lancer/device/cpu/cpu.h"
#include "lancer/import/import.h"
#include "lancer/spectrum/glass.h"
#include "lancer/spectrum/illuminant.h"
#include "lancer/spectrum/metal.h"
#include "lancer/spectrum/sensor.h"
#include "lancer/world/compile.h"

namespace lancer::tests {
namespace {

// The mean colour of a scene in TOML over all its pixels.
glm::dvec3 mean_of(const std::string& text, int spp, bool rgb = false) {
    Diagnostics diagnostics;
    auto scene =
        import_toml(text + "\n[render]\nsize = [16, 16]\nfilter = 'box'\nintegrator = 'path'\nbounces = 64\n", "scene.toml", diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.list()) {
        EXPECT_EQ(diagnostic.severity, Severity::note) << to_string(diagnostic);
    }
    if (!scene) {
        return glm::dvec3(0.0);
    }
    scene->settings.rgb = rgb;
    const auto world = compile_world(*scene, scene->cameras.front(), diagnostics);
    const auto device = make_cpu_device(world, {});
    const PathRange range{0, 0, 16, 16, 0, spp};
    std::vector<glm::vec3> radiance(range.paths());
    RayCounts counts;
    device->follow_paths(range, radiance, counts);
    glm::dvec3 sum(0.0);
    for (const glm::vec3& c : radiance) {
        sum += glm::dvec3(c);
    }
    return sum / static_cast<double>(radiance.size());
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double relative) {
    const double tolerance = relative * std::max({b.x, b.y, b.z});
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(a[i], b[i], tolerance) << "component " << i;
    }
}

// A white ball in a white sky of `light` can't be seen, whatever the light.
std::string furnace(const std::string& light) {
    return "[background]\ncolor = " + light + "\n[[sphere]]\nmaterial = { type = 'diffuse', color = [1, 1, 1] }\n";
}

// A plate of `color` fills the picture, lit along its normal so that it is as bright as its albedo.
std::string plate(const std::string& color, const std::string& light) {
    return "[[light]]\ntype = 'directional'\ndirection = [0, 0, -1]\npower = " + light + "\n[camera]\nposition = [0, 0, 1]\nfov = 10\n" +
           "[[plane]]\nnormal = [0, 0, 1]\nmaterial = { type = 'diffuse', color = " + color + " }\n";
}

// 256 pixels of 4096 samples: what four wavelengths leave of the variance is below 1e-4 of the mean at the third standard error.
constexpr int many = 4096;

TEST(Spectra, WhiteInAFurnaceHasTheColourOfItsLight) {
    for (const char* name : {"A", "D65", "FL11"}) {
        const glm::dvec3 expected = to_rgb(with_unit_luminance(*find_illuminant(name)));
        const std::string light = std::string("{ illuminant = '") + name + "', scale = 3 }";
        expect_near(mean_of(furnace(light), many), 3.0 * expected, 3e-4);
        expect_near(mean_of(furnace(light), many, true), 3.0 * expected, 3e-4);
    }
}

TEST(Spectra, LightsAreAsBrightAsTheyAreSaidToBe) {
    const glm::dvec3 weights(0.2126729, 0.7151522, 0.0721750);
    for (const char* light :
         {"{ blackbody = 2700, scale = 100 }", "{ daylight = 5000, scale = 100 }", "{ illuminant = 'FL2', luminance = 100 }",
          "{ wavelengths = [500, 600], values = [7, 1], luminance = 50, scale = 2 }"}) {
        const std::string scene =
            std::string("background = ") + light +
            "\n[camera]\nposition = [0, 0, 0]\nlook_at = [0, 0, -1]\n[[sphere]]\ncenter = [0, 0, 100]\nmaterial = { type = 'diffuse' }\n";
        EXPECT_NEAR(glm::dot(weights, mean_of(scene, many)), 100.0, 0.05) << light;
    }
    // 1 at every wavelength has luminance 1.
    expect_near(mean_of("background = { wavelengths = [300, 900], values = [1, 1] }\n[camera]\nposition = [0, 0, 0]\nlook_at = [0, 0, "
                        "-1]\n[[sphere]]\ncenter = [0, 0, 100]\n",
                        many),
                to_rgb(SpectralCurve(1.0)), 3e-4);
}

TEST(Spectra, MeasuredColoursComeOutAgain) {
    const SpectralCurve curve({450.0, 500.0, 560.0, 640.0}, {0.1, 0.7, 0.2, 0.9}, SpectralCurve::Beyond::constant);
    const std::string color = "{ wavelengths = [450, 500, 560, 640], values = [0.2, 1.4, 0.4, 1.8], scale = 0.5 }";
    const std::string d65 = "{ illuminant = 'D65', scale = 3.14159265358979 }", a = "{ illuminant = 'A', scale = 3.14159265358979 }";
    expect_near(mean_of(plate(color, d65), many), reflected_rgb(curve), 3e-4);
    expect_near(mean_of(plate(color, d65), 64, true), reflected_rgb(curve), 3e-4);
    std::vector<double> nm, values;
    const SpectralCurve lamp = with_unit_luminance(*find_illuminant("A"));
    for (int i = 360; i <= 830; ++i) {
        nm.push_back(i);
        values.push_back(curve.at(i) * lamp.at(i));
    }
    expect_near(mean_of(plate(color, a), many), to_rgb(SpectralCurve(nm, values, SpectralCurve::Beyond::zero)), 3e-4);
    // A metal's colour, too.
    const glm::dvec3 gold = mean_of(plate("{ metal = 'gold' }", d65), many);
    EXPECT_GT(gold.x, 0.95);
    EXPECT_NEAR(gold.z, 0.34, 0.05);
}

TEST(Spectra, ColoursUnderALampAreTintedByIt) {
    // A smooth spectrum under D65 is the colour itself.
    expect_near(mean_of("background = { rgb = [0.8, 0.4, 0.1], scale = 2 }\n[camera]\nposition = [0, 0, 0]\nlook_at = [0, 0, "
                        "-1]\n[[sphere]]\ncenter = [0, 0, 100]\n",
                        many),
                {1.6, 0.8, 0.2}, 1e-3);
    const std::string under_a =
        "background = { rgb = [1, 1, 1], illuminant = 'A' }\n[camera]\nposition = [0, 0, 0]\nlook_at = [0, 0, -1]\n[[sphere]]\ncenter = "
        "[0, 0, 100]\n";
    expect_near(mean_of(under_a, many), to_rgb(with_unit_luminance(*find_illuminant("A"))), 3e-4);
}

TEST(Spectra, MetamersDifferWhereTheyMust) {
    Diagnostics diagnostics;
    const auto scene = import_scene(LANCER_SOURCE_FOLDER "/scenes/features/metamers.toml", diagnostics);
    ASSERT_TRUE(scene);
    std::array<std::string, 2> color;
    for (const scene::Material& material : scene->materials) {
        if (material.name == "first" || material.name == "second") {
            const auto& model = std::get<scene::DiffuseMaterial>(material.model);
            const auto& measured = std::get<scene::MeasuredSpectrum>(std::get<scene::Color>(model.color).spectrum->shape);
            std::string nm, values;
            for (std::size_t i = 0; i < measured.values.size(); ++i) {
                nm += std::to_string(measured.nanometres[i]) + ", ";
                values += std::to_string(measured.values[i]) + ", ";
            }
            color[material.name == "first" ? 0 : 1] = "{ wavelengths = [" + nm + "], values = [" + values + "] }";
        }
    }
    const auto difference = [&](const std::string& light, bool rgb) {
        const glm::dvec3 first = mean_of(plate(color[0], light), rgb ? 16 : many, rgb);
        const glm::dvec3 second = mean_of(plate(color[1], light), rgb ? 16 : many, rgb);
        return glm::length(first - second) / glm::length(first);
    };
    EXPECT_LT(difference("{ illuminant = 'D65' }", false), 1e-3);
    EXPECT_GT(difference("{ illuminant = 'A' }", false), 0.1);
    EXPECT_GT(difference("{ illuminant = 'FL11' }", false), 0.1);
    // Red, green and blue can't tell them apart under any lamp.
    EXPECT_LT(difference("{ illuminant = 'D65' }", true), 1e-4);
    EXPECT_LT(difference("{ illuminant = 'A' }", true), 1e-4);
}

TEST(Spectra, GreyScenesAreTheSameInRgb) {
    const std::string grey =
        "background = [0.4, 0.4, 0.4]\n[[plane]]\npoint = [0, -1, 0]\nmaterial = { type = 'diffuse', color = [0.3, 0.3, 0.3] }\n"
        "[[sphere]]\nmaterial = { type = 'plastic', color = [0.6, 0.6, 0.6], roughness = 0.3 }\n"
        "[[sphere]]\ncenter = [2, 0, 0]\nmaterial = { type = 'dielectric', refraction = 1.5, absorption = [0.5, 0.5, 0.5] }\n"
        "[[light]]\ntype = 'point'\nposition = [0, 4, 3]\npower = [20, 20, 20]\n";
    const glm::dvec3 spectral = mean_of(grey, many), rgb = mean_of(grey, many, true);
    expect_near(spectral, rgb, 2e-3);
}

TEST(Spectra, IndicesFromCurvesAreThoseOfTheNames) {
    // Gold by its name and by its tables at every 5 nm; glass by its name and by a table of its own index.
    const auto curve = [](const auto& value) {
        std::string nm, values;
        for (int l = 360; l <= 830; l += 5) {
            nm += std::to_string(l) + ", ";
            values += std::to_string(value(static_cast<double>(l))) + ", ";
        }
        return "{ wavelengths = [" + nm + "], values = [" + values + "] }";
    };
    const Metal gold = *find_metal("gold");
    const std::string light =
        "[[sphere]]\nradius = 50\nmaterial = { type = 'diffuse', color = 'black', emission = { illuminant = 'E' }, "
        "emission_sides = 'both' }\n[camera]\nposition = [0, 0, 4]\nfov = 25\n";
    const std::string named = light + "[[sphere]]\nmaterial = { type = 'conductor', metal = 'gold' }\n";
    const std::string tabulated = light +
                                  "[[sphere]]\nmaterial = { type = 'conductor', n = " + curve([&](double l) { return gold.n.at(l); }) +
                                  ", k = " + curve([&](double l) { return gold.k.at(l); }) + " }\n";
    expect_near(mean_of(tabulated, many), mean_of(named, many), 1e-3);
    expect_near(mean_of(tabulated, many, true), mean_of(named, many, true), 1e-3);

    const Sellmeier glass = *find_glass("SF11");
    const std::string lit =
        "[background]\nzenith = [1, 1, 1]\nhorizon = [0.5, 0.5, 0.5]\nnadir = [0, 0, 0]\n[camera]\nposition = [0, 0, 4]\nfov = 25\n";
    const std::string named_glass = lit + "[[sphere]]\nmaterial = { type = 'dielectric', refraction = 'SF11' }\n";
    const std::string tabulated_glass =
        lit + "[[sphere]]\nmaterial = { type = 'dielectric', refraction = " + curve([&](double l) { return glass.index(l); }) + " }\n";
    expect_near(mean_of(tabulated_glass, many), mean_of(named_glass, many), 2e-3);
}

TEST(Spectra, AbsorptionFadesEachWavelength) {
    // A plate of 2 m, without borders, in front of a white light: exp(-a d).
    const std::string scene =
        "background = { wavelengths = [300, 900], values = [1, 1] }\n[camera]\nprojection = 'orthographic'\nextent = 1\n"
        "[[box]]\nmin = [-9, -9, -1]\nmax = [9, 9, 1]\nmaterial = { type = 'dielectric', refraction = 1, "
        "absorption = { wavelengths = [400, 550, 700], values = [0.1, 1.2, 0.3] } }\n";
    const SpectralCurve absorption({400.0, 550.0, 700.0}, {0.1, 1.2, 0.3}, SpectralCurve::Beyond::constant);
    std::vector<double> nm, values;
    for (int i = 360; i <= 830; ++i) {
        nm.push_back(i);
        values.push_back(std::exp(-2.0 * absorption.at(i)));
    }
    expect_near(mean_of(scene, many), to_rgb(SpectralCurve(nm, values, SpectralCurve::Beyond::zero)), 5e-4);
}

}  // namespace
}  // namespace lancer::tests
