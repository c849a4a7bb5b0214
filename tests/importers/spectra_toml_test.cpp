// Spectra in the TOML notation, and what is wrong with them.
#include "reading.h"

namespace lancer {
namespace {

using namespace lancer::testing;

const scene::Spectrum& background(const scene::Scene& scene) { return *scene.background.zenith.spectrum; }

scene::Scene read_sky(const std::string& sky) { return read_part(sky + "\n[[sphere]]\n"); }

TEST(TomlSpectra, StandWhereColoursStand) {
    EXPECT_EQ(std::get<scene::IlluminantSpectrum>(background(read_sky("background = { illuminant = 'A', scale = 2 }")).shape).name, "A");
    EXPECT_EQ(background(read_sky("background = { illuminant = 'A', scale = 2 }")).scale, 2.0);
    EXPECT_EQ(std::get<scene::BlackbodySpectrum>(background(read_sky("[background]\ncolor = { blackbody = 2700 }")).shape).kelvin, 2700.0);
    EXPECT_EQ(
        std::get<scene::DaylightSpectrum>(background(read_sky("[background]\nzenith = { daylight = 5000, luminance = 3 }")).shape).kelvin,
        5000.0);
    EXPECT_EQ(background(read_sky("[background]\nzenith = { daylight = 5000, luminance = 3 }")).luminance, 3.0);
    const scene::Scene tinted = read_sky("background = { rgb = '#ffffff', illuminant = 'FL2' }");
    EXPECT_EQ(std::get<scene::TintedSpectrum>(background(tinted).shape).illuminant, "FL2");
    const scene::Scene measured = read_sky("background = { wavelengths = [400, 500], values = [1, 2] }");
    EXPECT_EQ(std::get<scene::MeasuredSpectrum>(background(measured).shape).values, (std::vector<double>{1.0, 2.0}));
    const scene::Scene metal = read_part("[[sphere]]\nmaterial = { type = 'principled', color = { metal = 'Cu' }, metalness = 1 }");
    const auto& model = std::get<scene::PrincipledMaterial>(metal.materials.at(0).model);
    EXPECT_EQ(std::get<scene::MetalSpectrum>(std::get<scene::Color>(model.color).spectrum->shape).name, "Cu");
}

TEST(TomlSpectra, ComeFromFiles) {
    const TemporaryFolder folder;
    folder.write("lamp.csv", "wavelength,power\n400,1\n500,3\n600,2\n");
    folder.write("n.spd", "400 1.6\n700 1.5\n");
    const std::string path = folder.write("scene.toml", R"(
background = { spectrum = "lamp.csv", luminance = 5 }
[[sphere]]
material = { type = "dielectric", refraction = { spectrum = "n.spd" } }
[[sphere]]
material = { type = "conductor", n = "n.spd", k = 2.5 }
)");
    const Reading reading = read_path(path);
    ASSERT_TRUE(reading.scene) << reading.all();
    EXPECT_EQ(std::get<scene::MeasuredSpectrum>(background(*reading.scene).shape).nanometres, (std::vector<double>{400.0, 500.0, 600.0}));
    const auto& glass = std::get<scene::DielectricMaterial>(reading.scene->materials.at(0).model);
    EXPECT_EQ(std::get<scene::MeasuredSpectrum>(glass.refraction).values, (std::vector<double>{1.6, 1.5}));
    const auto& metal = std::get<scene::ConductorMaterial>(reading.scene->materials.at(1).model);
    EXPECT_EQ(std::get<scene::MeasuredSpectrum>(metal.n.value()).values.size(), 2u);
    EXPECT_EQ(std::get<scene::MeasuredSpectrum>(metal.k.value()).values, std::vector<double>{2.5});
    // What the files hold is part of the scene's hash.
    const std::string before = reading.scene->hash;
    folder.write("n.spd", "400 1.6\n700 1.51\n");
    EXPECT_NE(read_path(path).scene.value_or(scene::Scene{}).hash, before);
}

struct Wrong {
    const char* name;
    const char* text;
    const char* message;
};

class WrongSpectrum : public ::testing::TestWithParam<Wrong> {};

TEST_P(WrongSpectrum, IsExplained) {
    const Reading reading = read_text(GetParam().text);
    EXPECT_FALSE(reading.scene);
    EXPECT_EQ(reading.all().substr(0, reading.all().find('\n')), std::string("scene.toml") + GetParam().message);
}

#define COLOR "[material.m]\ntype = 'diffuse'\ncolor = "

INSTANTIATE_TEST_SUITE_P(
    All, WrongSpectrum,
    ::testing::Values(
        Wrong{"NearName", "background = { illuminant = 'DD65' }\n[[sphere]]\n",
              ":1:29: error: there is no illuminant \"DD65\"; did you mean \"D65\"?"},
        Wrong{"NoName", "background = { illuminant = 'neon tube' }\n[[sphere]]\n",
              ":1:29: error: there is no illuminant \"neon tube\"; known are A, C, D50, D55, D60, D65, D75, E, FL1, FL2, "
              "FL3, FL4, FL5, FL6, FL7, FL8, FL9, FL10, FL11, FL12"},
        Wrong{"Metal", COLOR "{ metal = 'goldd' }\n[[sphere]]\n", ":3:19: error: there is no metal \"goldd\"; did you mean \"gold\"?"},
        Wrong{"Two", "background = { illuminant = 'A', blackbody = 2700 }\n",
              ":1:46: error: a spectrum has either \"illuminant\" or \"blackbody\""},
        Wrong{"Cold", "background = { blackbody = 20 }\n", ":1:28: error: \"blackbody\" must be from 500 to 100000 K, not 20"},
        Wrong{"LightAsShare", COLOR "{ blackbody = 2700 }\n[[sphere]]\n",
              ":3:23: error: \"blackbody\" is a light; \"color\" is a share of light, from 0 to 1"},
        Wrong{"MetalAsLight", "background = { metal = 'gold' }\n",
              ":1:24: error: \"metal\" is what a surface mirrors; \"background\" is a light"},
        Wrong{"LuminanceOfShare", COLOR "{ wavelengths = [500], values = [0.5], luminance = 1 }\n[[sphere]]\n",
              ":3:25: error: \"luminance\" is for lights; \"color\" is none"},
        Wrong{"TooBright", COLOR "{ wavelengths = [500, 600], values = [0.5, 1.5] }\n[[sphere]]\n",
              ":3:46: error: \"color\" must be from 0 to 1, not 1.5 as at 600 nm"},
        Wrong{"TooBrightScaled", COLOR "{ wavelengths = [500, 600], values = [0.5, 0.6], scale = 2 }\n[[sphere]]\n",
              ":3:46: error: \"color\" must be from 0 to 1, not 1.2 as at 600 nm"},
        Wrong{"Counts", "background = { wavelengths = [500, 600], values = [1] }\n",
              ":1:51: error: \"wavelengths\" and \"values\" belong together: as many of both, at least one, not 2 and 1"},
        Wrong{"Falls", "background = { wavelengths = [600, 500], values = [1, 1] }\n",
              ":1:30: error: \"wavelengths\" must rise: 500 nm comes after 600 nm"},
        Wrong{"NoFile", "background = { spectrum = 'nowhere.csv' }\n", ":1:27: error: cannot read \"nowhere.csv\": there is no such file"},
        Wrong{"Unknown", "background = { illuminant = 'A', brightness = 2 }\n",
              ":1:34: error: a spectrum has no \"brightness\"; it may have illuminant, blackbody, daylight, spectrum, wavelengths, values, "
              "metal, rgb, "
              "scale, luminance, as_rgb"},
        Wrong{"OnlyOneIndex", "[material.m]\ntype = 'conductor'\nn = 0.2\n[[sphere]]\n", ":3:5: error: \"n\" and \"k\" belong together"},
        Wrong{"IndexAndMetal", "[material.m]\ntype = 'conductor'\nn = 0.2\nk = 3\nmetal = 'gold'\n[[sphere]]\n",
              ":5:9: error: a conductor has either \"n\" and \"k\" or \"metal\""},
        Wrong{"Index", "[material.m]\ntype = 'conductor'\nn = true\nk = 3\n[[sphere]]\n",
              ":3:5: error: \"n\" must be a number, the name of a file, or { wavelengths, values }, not true or false"},
        Wrong{"Refraction", "[material.m]\ntype = 'dielectric'\nrefraction = { wavelengths = [500], values = [0.01] }\n[[sphere]]\n",
              ":3:14: error: \"refraction\" must be from 0.1 to 10, not 0.01 as at 500 nm"},
        Wrong{"AbsorptionByName", "[material.m]\ntype = 'dielectric'\nabsorption = { illuminant = 'A' }\n[[sphere]]\n",
              ":3:29: error: \"illuminant\" is a light; \"absorption\" is an absorption, in 1/m"},
        Wrong{"BetweenSpectra", "[background]\nzenith = { illuminant = 'A' }\nnadir = [1, 1, 1]\n",
              ":1:1: error: between two spectra \"horizon\" must be written"}),
    [](const auto& wrong) { return std::string(wrong.param.name); });

}  // namespace
}  // namespace lancer
