// Media and their grids in TOML, and the files that grids come from.
#include <cstring>

#include "reading.h"

namespace lancer {
namespace {

using namespace lancer::testing;

const char* const rest = "[[sphere]]\nmaterial = 'm'\n[[light]]\ntype = 'point'\nposition = [0, 0, 9]\n";

scene::Scene read_whole(const std::string& text) {
    const Reading reading = read_text(text + rest);
    EXPECT_TRUE(reading.scene) << reading.all();
    return reading.scene.value_or(scene::Scene{});
}

TEST(MediaToml, ReadsMediaAndWhoHasThem) {
    const scene::Scene s = read_whole(R"(
[medium.fog]
absorption = [0.1, 0.2, 0.3]
scattering = { wavelengths = [400, 700], values = [3, 1] }
scale = 2
asymmetry = 0.4
emission = [1, 0.5, 0.25]
emission_strength = 3
everywhere = true
[medium.air]
extinction = [1, 2, 3]
albedo = [0.5, 0.6, 0.7]
phase = "rayleigh"
[medium.clear]
[material.m]
type = "null"
interior = "air"
priority = -2
[material.glass]
type = "dielectric"
interior = "fog"
priority = 4
[material.both]
type = "mix"
first = "glass"
second = { type = "principled", interior = "clear" }
[[sphere]]
material = "both"
)");
    ASSERT_EQ(s.media.size(), 3u);
    EXPECT_EQ(s.medium, 0);
    const scene::Medium& fog = s.media[0];
    EXPECT_EQ(fog.name, "fog");
    const auto& parts = std::get<scene::AbsorbingScattering>(fog.coefficients);
    EXPECT_EQ(parts.absorption.rgb, scene::Rgb(0.1, 0.2, 0.3));
    EXPECT_TRUE(parts.scattering.spectrum);
    EXPECT_EQ(fog.scale, 2.0);
    EXPECT_EQ(fog.phase, scene::Phase::henyey_greenstein);
    EXPECT_EQ(fog.asymmetry, 0.4);
    EXPECT_EQ(fog.emission.rgb, scene::Rgb(1.0, 0.5, 0.25));
    EXPECT_EQ(fog.emission_strength, 3.0);
    const scene::Medium& air = s.media[1];
    EXPECT_EQ(std::get<scene::ExtinctionAlbedo>(air.coefficients).extinction.rgb, scene::Rgb(1, 2, 3));
    EXPECT_EQ(std::get<scene::ExtinctionAlbedo>(air.coefficients).albedo.rgb, scene::Rgb(0.5, 0.6, 0.7));
    EXPECT_EQ(air.phase, scene::Phase::rayleigh);
    EXPECT_FALSE(air.density || air.albedo || air.temperature);
    EXPECT_TRUE(std::holds_alternative<scene::NullMaterial>(s.materials[0].model));
    EXPECT_EQ(s.materials[0].interior, 1);
    EXPECT_EQ(s.materials[0].priority, -2);
    EXPECT_EQ(s.materials[1].interior, 0);
    EXPECT_EQ(s.materials[1].priority, 4);
}

TEST(MediaToml, ReadsGrids) {
    const TemporaryFolder folder;
    const float raw[6] = {0.0f, 1.0f, 2.0f, 3.0f, 4.0f, 5.0f};
    folder.write("a.raw", std::string(reinterpret_cast<const char*>(raw), sizeof raw));
    std::string vol("VOL\x03", 4);
    const std::int32_t header[5] = {1, 1, 2, 1, 3};
    const float box[6] = {-1.0f, 0.0f, 2.0f, 1.0f, 3.0f, 4.0f};
    vol.append(reinterpret_cast<const char*>(header), sizeof header).append(reinterpret_cast<const char*>(box), sizeof box);
    vol.append(reinterpret_cast<const char*>(raw), sizeof raw);
    folder.write("b.vol", vol);
    const Reading reading = read_text(std::string(R"(
[medium.a]
extinction = [1, 1, 1]
density = { file = "a.raw", cells = [3, 2, 1], min = [1, 2, 3], max = [2, 4, 6], fades = true }
albedo_grid = { file = "b.vol", translate = [10, 0, 0] }
temperature = { cells = [1, 1, 2], values = [1000, 2000] }
[material.m]
type = "null"
interior = "a"
)") + rest,
                                      folder / "scene.toml");
    ASSERT_TRUE(reading.scene) << reading.all();
    const scene::Medium& medium = reading.scene->media.at(0);
    const scene::Grid& density = medium.density.value();
    EXPECT_EQ(density.data->size, glm::ivec3(3, 2, 1));
    EXPECT_EQ(density.data->channels, 1);
    EXPECT_EQ(density.data->values, std::vector<float>(raw, raw + 6));
    EXPECT_EQ(glm::dvec3(density.to_world * glm::dvec4(0, 0, 0, 1)), glm::dvec3(1, 2, 3));
    EXPECT_EQ(glm::dvec3(density.to_world * glm::dvec4(1, 1, 1, 1)), glm::dvec3(2, 4, 6));
    EXPECT_TRUE(density.fades);
    const scene::Grid& albedo = medium.albedo.value();
    EXPECT_EQ(albedo.data->size, glm::ivec3(1, 2, 1));
    EXPECT_EQ(albedo.data->channels, 3);
    EXPECT_EQ(glm::dvec3(albedo.to_world * glm::dvec4(0, 0, 0, 1)), glm::dvec3(9, 0, 2));
    EXPECT_EQ(glm::dvec3(albedo.to_world * glm::dvec4(1, 1, 1, 1)), glm::dvec3(11, 3, 4));
    EXPECT_FALSE(albedo.fades);
    const scene::Grid& temperature = medium.temperature.value();
    EXPECT_EQ(temperature.data->values, std::vector<float>({1000.0f, 2000.0f}));
    EXPECT_EQ(medium.emission.rgb, scene::Rgb(1.0)) << "a factor of the black body";
}

// grids/tiny.vdb holds whole numbers "whole", which are not read; "density", three cells 0.5 m wide; and "color".
TEST(MediaToml, ReadsOpenVdb) {
    const auto read = [](const std::string& name) {
        return read_text("[medium.a]\nscattering = [1, 1, 1]\ndensity = { file = '" + source_folder().string() +
                         "/tests/importers/grids/tiny.vdb'" + name + " }\n[material.m]\ntype = 'null'\ninterior = 'a'\n" + rest);
    };
    const Reading first = read("");
    if (first.all().find("libopenvdb-dev") != std::string::npos) {
        GTEST_SKIP() << "lancer was built without OpenVDB: " << first.all();
    }
    ASSERT_TRUE(first.scene) << first.all();
    const scene::Grid& density = first.scene->media.at(0).density.value();
    EXPECT_EQ(density.data->size, glm::ivec3(2, 1, 3));
    EXPECT_EQ(density.data->channels, 1);
    EXPECT_EQ(density.data->values, std::vector<float>({0.25f, 0.5f, 0.0f, 0.0f, 0.0f, 0.0f})) << "what is below 0 is 0";
    EXPECT_EQ(glm::dvec3(density.to_world * glm::dvec4(0, 0, 0, 1)), glm::dvec3(0.25, 0.75, 1.25));
    EXPECT_EQ(glm::dvec3(density.to_world * glm::dvec4(1, 1, 1, 1)), glm::dvec3(1.25, 1.25, 2.75));
    EXPECT_TRUE(density.fades);
    const Reading color = read(", name = 'color', fades = false");
    ASSERT_TRUE(color.scene) << color.all();
    EXPECT_EQ(color.scene->media.at(0).density.value().data->values, std::vector<float>({1.0f, 0.5f, 0.25f}));
    EXPECT_FALSE(color.scene->media.at(0).density.value().fades);
    EXPECT_NE(read(", name = 'smoke'").all().find("has no grid \"smoke\"; there are whole, density, color"), std::string::npos);
    EXPECT_NE(read(", name = 'whole'").all().find("which is not read"), std::string::npos);
}

TEST(MediaToml, SaysWhatIsWrong) {
    const TemporaryFolder folder;
    folder.write("short.raw", "1234");
    folder.write("other.vol", std::string(60, 'x'));
    const std::pair<std::string, std::string> mistakes[] = {
        {"[medium.a]\nabsorption = [1, 1, 1]\nalbedo = 'red'\n", "a medium has either \"extinction\" and \"albedo\" or \"absorption\""},
        {"[medium.a]\nextinction = [1, 1, 1]\n", "\"extinction\" needs \"albedo\" beside it"},
        {"[medium.a]\nalbedo = 'red'\n", "an albedo needs \"extinction\" beside it"},
        {"[medium.a]\nscattering = [-1, 0, 0]\n", "\"scattering\" must be at least 0 1/m, not -1"},
        {"[medium.a]\nasymmetry = 1\n", "\"asymmetry\" must be from -0.999 to 0.999, not 1"},
        {"[medium.a]\nphase = 'rayleigh'\nasymmetry = 0.5\n", "\"asymmetry\" belongs to the phase henyey-greenstein"},
        {"[medium.a]\nabsorbtion = [1, 1, 1]\n", "did you mean \"absorption\"?"},
        {"[medium.a]\neverywhere = true\n[medium.b]\neverywhere = true\n", "only one medium can be everywhere, and \"a\" is already"},
        {"[medium]\nscattering = [1, 1, 1]\n", "a medium needs a name: [medium.NAME]; \"scattering\" stands in none"},
        {"[[medium]]\n", "media are written as [medium.NAME], not as [[medium]]"},
        {"[medium.a]\ndensity = 3\n", "\"density\" must be a table, { file } or { cells, values }, not a number"},
        {"[medium.a]\ndensity = { cells = [2, 2, 2], values = [1, 2] }\n", "8 cells of 1 channel have 8 values, not 2"},
        {"[medium.a]\ndensity = { cells = [2.5, 2, 2], values = [1] }\n", "\"cells\" must be whole numbers"},
        {"[medium.a]\ndensity = { cells = [1, 1, 1], channels = 2, values = [1, 1] }\n", "\"channels\" must be 1 or 3"},
        {"[medium.a]\ndensity = { values = [1] }\n", "a grid needs \"file\", or \"cells\" and \"values\""},
        {"[medium.a]\ndensity = { cells = [1, 1, 1], values = [1], min = [0, 0, 0] }\n", "\"min\" and \"max\" belong together"},
        {"[medium.a]\ndensity = { cells = [1, 1, 1], values = [1], min = [0, 0, 0], max = [1, 0, 1] }\n", "along y they are 0 and 0"},
        {"[medium.a]\ndensity = { file = 'short.raw' }\n", "a .raw file needs \"cells\" beside it"},
        {"[medium.a]\ndensity = { file = 'short.raw', cells = [2, 1, 1] }\n",
         "should have 8 bytes for 2 x 1 x 1 cells of 1 channel, and has 4"},
        {"[medium.a]\ndensity = { file = 'other.vol' }\n", "is no .vol file"},
        {"[medium.a]\ndensity = { file = 'short.txt' }\n", "short.txt"},
        {"[medium.a]\ntemperature = { cells = [1, 1, 1], values = [1] }\n", "this needs a \"density\" that is a grid, too"},
        {"[material.n]\ntype = 'null'\ninterior = 'fgo'\n[medium.fog]\n", "there is no medium \"fgo\"; did you mean \"fog\"?"},
        {"[material.n]\ntype = 'dielectric'\ninterior = 'fog'\nabsorption = 'red'\n[medium.fog]\n",
         "a material has either an \"interior\" or \"absorption\""},
        {"[material.n]\ntype = 'null'\ncolor = 'red'\n", "a material has no \"color\""},
    };
    for (const auto& [text, message] : mistakes) {
        const Reading reading = read_text(text + "[material.m]\n" + rest, folder / "scene.toml");
        EXPECT_FALSE(reading.scene) << text;
        EXPECT_NE(reading.all().find(message), std::string::npos) << text << "\n" << reading.all();
    }
}

TEST(MediaToml, WarnsOfWhatIsNotUsed) {
    const Reading reading = read_text(std::string("[medium.fog]\nscattering = [1, 1, 1]\n[material.m]\n") + rest);
    ASSERT_TRUE(reading.scene) << reading.all();
    EXPECT_NE(reading.all().find("medium \"fog\" is not used"), std::string::npos) << reading.all();
}

}  // namespace
}  // namespace lancer
