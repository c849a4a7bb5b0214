// Mitsuba's scenes: what is read, and what is said about mistakes.
#include <fstream>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "lancer/image/image.h"
#include "lancer/import/import.h"
#include "rendered.h"

namespace lancer {
namespace {

using namespace lancer::testing;

struct Import : Reading {
    ImportReport report;

    const ImportEntry* entry(const std::string& feature) const {
        for (const ImportEntry& e : report.entries()) {
            if (e.feature == feature) {
                return &e;
            }
        }
        return nullptr;
    }
};

class Mitsuba : public ::testing::Test {
protected:
    Import read(const std::string& inside, const ImportOptions& options = {}, const std::string& version = "3.0.0") {
        const std::string path = folder_.write("scene.xml", "<scene version=\"" + version + "\">\n" + inside + "\n</scene>\n");
        Diagnostics diagnostics;
        Import import;
        auto scene = import_scene(path, options, import.report, diagnostics);
        static_cast<Reading&>(import) = gather(std::move(scene), diagnostics);
        return import;
    }
    scene::Scene good(const std::string& inside, const ImportOptions& options = {}) {
        Import import = read(inside, options);
        EXPECT_TRUE(import.scene) << import.all();
        return import.scene.value_or(scene::Scene{});
    }
    void expect_error(const std::string& inside, const std::string& message) {
        const Import import = read(inside);
        EXPECT_FALSE(import.scene);
        EXPECT_NE(import.all().find(message), std::string::npos) << import.all();
    }

    TemporaryFolder folder_;
};

// ---- The language -----------------------------------------------------------------------------------------------------------------

TEST_F(Mitsuba, DefaultsAndParameters) {
    const std::string text = R"(<default name="r" value="2"/><default name="r" value="3"/>
        <shape type="sphere"><float name="radius" value="$r"/></shape>)";
    EXPECT_EQ(std::get<scene::Sphere>(good(text).objects.at(0).shape).radius, 2.0);
    ImportOptions options;
    options.defines["r"] = "5";
    EXPECT_EQ(std::get<scene::Sphere>(good(text, options).objects.at(0).shape).radius, 5.0);
    expect_error(R"(<default name="radius" value="1"/><shape type="sphere"><float name="radius" value="$radus"/></shape>)",
                 R"(scene.xml:2:56: error: the parameter "$radus" has no value: give it one with -D radus=VALUE; did you mean "radius"?)");
}

TEST_F(Mitsuba, IncludesShareDefaultsAndFolders) {
    std::filesystem::create_directory(folder_ / "parts");
    folder_.write("parts/ball.xml", R"(<scene version="3.0.0"><default name="r" value="4"/>
        <shape type="sphere"><float name="radius" value="$r"/></shape></scene>)");
    const scene::Scene scene =
        good(R"(<path value="parts"/><include filename="ball.xml"/><shape type="sphere"><float name="radius" value="$r"/></shape>)");
    ASSERT_EQ(scene.objects.size(), 2u);
    EXPECT_EQ(std::get<scene::Sphere>(scene.objects[1].shape).radius, 4.0);
}

TEST_F(Mitsuba, IncludesNeverGoRound) {
    folder_.write("other.xml", R"(<scene version="3.0.0"><include filename="scene.xml"/></scene>)");
    expect_error(R"(<include filename="other.xml"/>)", "includes itself");
}

TEST_F(Mitsuba, IncludesAreCounted) {
    // Each file includes the next one ten times: 10^9 files without a limit.
    for (int i = 0; i < 9; ++i) {
        std::string text = "<scene version=\"3.0.0\">";
        for (int k = 0; k < 10; ++k) {
            text += "<include filename=\"f" + std::to_string(i + 1) + ".xml\"/>";
        }
        folder_.write("f" + std::to_string(i) + ".xml", text + "</scene>");
    }
    folder_.write("f9.xml", "<scene version=\"3.0.0\"/>");
    expect_error(R"(<include filename="f0.xml"/>)", "far too many files");
}

TEST_F(Mitsuba, EntitiesAreNotExpanded) {
    const std::string path =
        folder_.write("laughs.xml", R"(<!DOCTYPE scene [<!ENTITY a "ha"><!ENTITY b "&a;&a;&a;&a;"><!ENTITY c SYSTEM "/etc/passwd">]>
        <scene version="3.0.0"><shape type="sphere" id="&b;&c;"/></scene>)");
    const Reading reading = read_path(path);
    ASSERT_TRUE(reading.scene) << reading.all();
    EXPECT_EQ(reading.scene->objects.at(0).name, "&b;&c;");
}

TEST_F(Mitsuba, DepthIsBounded) {
    std::string deep;
    for (int i = 0; i < 100000; ++i) {
        deep += "<bsdf>";
    }
    for (int i = 0; i < 100000; ++i) {
        deep += "</bsdf>";
    }
    expect_error(deep, "nested too deeply");
}

TEST_F(Mitsuba, ReferencesByIdAndAlias) {
    const scene::Scene scene = good(R"(
        <bsdf type="diffuse" id="red"><rgb name="reflectance" value="0.5, 0, 0"/></bsdf><alias id="red" as="paint"/>
        <shape type="sphere"><ref id="red"/></shape><shape type="sphere"><ref id="paint"/></shape>)");
    ASSERT_EQ(scene.materials.size(), 1u);
    EXPECT_EQ(scene.objects.at(1).material, 0);
    expect_error(R"(<bsdf type="diffuse" id="green"/><shape type="sphere"><ref id="grean"/></shape>)",
                 R"(scene.xml:2:55: error: nothing has the id "grean"; did you mean "green"?)");
    expect_error(R"(<bsdf type="twosided" id="a"><ref id="a"/></bsdf><shape type="sphere"><ref id="a"/></shape>)", "circle");
}

TEST_F(Mitsuba, MistakesHavePlaces) {
    expect_error("<shape type=\"sphere\">\n  <float name=\"radius\" value=\"big\"/></shape>",
                 "scene.xml:3:3: error: \"radius\": expected a number, found \"big\"");
    expect_error("<shape type=\"sphere\">", "no well-formed XML");
    const Import import = read(R"(<shape type="sphere"><float name="raduis" value="1"/></shape>)");
    EXPECT_TRUE(import.scene);
    EXPECT_NE(import.all().find("\"raduis\" means nothing here"), std::string::npos) << import.all();
    EXPECT_NE(import.entry("shape \"sphere\": \"raduis\""), nullptr);
}

TEST_F(Mitsuba, NamesOfVersionZero) {
    const Import import = read(R"(<shape type="sphere"><transform name="toWorld"><translate x="3"/></transform></shape>
        <sensor type="perspective"><transform name="toWorld"><lookAt origin="0,0,5" target="0,0,0" up="0,1,0"/></transform></sensor>)",
                               {}, "0.6.0");
    ASSERT_TRUE(import.scene) << import.all();
    EXPECT_EQ(import.scene->objects.at(0).to_parent[3].x, 3.0);
    EXPECT_EQ(import.scene->cameras.at(0).direction.z, -1.0);
}

// ---- What the words mean ------------------------------------------------------------------------------------------------------------

TEST_F(Mitsuba, TransformsApplyInTheOrderOfWriting) {
    const scene::Scene scene = good(R"(<shape type="rectangle"><transform name="to_world">
        <translate x="1"/><rotate z="1" angle="90"/><scale value="2"/></transform></shape>)");
    const glm::dvec4 origin = scene.objects.at(0).to_parent * glm::dvec4(0, 0, 0, 1);
    EXPECT_NEAR(glm::distance(glm::dvec3(origin), glm::dvec3(0, 2, 0)), 0.0, 1e-12);
}

TEST_F(Mitsuba, CamerasFieldOfView) {
    const auto camera = [&](const std::string& inside) {
        return good(
                   "<sensor type=\"perspective\">" + inside +
                   "<film type=\"hdrfilm\"><integer name=\"width\" value=\"400\"/><integer name=\"height\" value=\"300\"/></film></sensor>")
            .cameras.at(0);
    };
    EXPECT_EQ(camera(R"(<float name="fov" value="40"/>)").fov_axis, scene::FovAxis::width);
    EXPECT_EQ(camera(R"(<float name="fov" value="40"/><string name="fov_axis" value="smaller"/>)").fov_axis, scene::FovAxis::height);
    // Across the diagonal of 5, the width is 4.
    const double half = std::atan(0.8 * std::tan(glm::radians(20.0)));
    EXPECT_NEAR(camera(R"(<float name="fov" value="40"/><string name="fov_axis" value="diagonal"/>)").fov, glm::degrees(2.0 * half), 1e-9);
}

TEST_F(Mitsuba, DepthCountsEmission) {
    EXPECT_EQ(good(R"(<integrator type="path"><integer name="max_depth" value="2"/></integrator>)").settings.bounces, 1);
    EXPECT_EQ(good(R"(<integrator type="moment"><integrator type="direct"/></integrator>)").settings.bounces, 1);
}

TEST_F(Mitsuba, UnknownPluginsAreSaid) {
    const Import import = read(R"(<shape type="spere"/><emitter type="constnt"/><shape type="sphere"><bsdf type="velvet"/></shape>)");
    EXPECT_TRUE(import.scene);
    EXPECT_NE(import.all().find("did you mean \"sphere\"?"), std::string::npos) << import.all();
    ASSERT_NE(import.entry("shape \"spere\""), nullptr);
    EXPECT_EQ(import.entry("shape \"spere\"")->treatment, Treatment::dropped);
    ASSERT_NE(import.entry("bsdf \"velvet\""), nullptr);
    EXPECT_EQ(import.entry("bsdf \"velvet\"")->treatment, Treatment::approximated);
}

TEST_F(Mitsuba, InstancesShareTheirGroup) {
    const scene::Scene scene = good(R"(<shape type="shapegroup" id="g"><shape type="cube"/><shape type="disk"/></shape>
        <shape type="instance"><ref id="g"/></shape>
        <shape type="instance"><ref id="g"/><transform name="to_world"><translate z="2"/></transform></shape>)");
    ASSERT_EQ(scene.groups.size(), 1u);
    EXPECT_EQ(scene.groups[0].objects.size(), 2u);
    ASSERT_EQ(scene.placements.size(), 2u);
    EXPECT_EQ(scene.placements[1].to_parent[3].z, 2.0);
}

TEST_F(Mitsuba, CubesPointOutwards) {
    const scene::Scene scene = good(R"(<shape type="cube"/>)");
    const scene::TriangleMesh& mesh = *std::get<scene::Mesh>(scene.objects.at(0).shape).data;
    ASSERT_EQ(mesh.triangles.size(), 12u);
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::vec3 middle = (mesh.positions[t.x] + mesh.positions[t.y] + mesh.positions[t.z]) / 3.0f;
        const glm::vec3 normal = glm::cross(mesh.positions[t.y] - mesh.positions[t.x], mesh.positions[t.z] - mesh.positions[t.x]);
        EXPECT_GT(glm::dot(normal, middle), 0.0f);
        EXPECT_GT(glm::dot(normal, mesh.normals[t.x]), 0.0f);
    }
}

// ---- Surfaces and light -------------------------------------------------------------------------------------------------------------

TEST_F(Mitsuba, RoughSurfacesHaveMitsubasFacets) {
    const scene::Scene scene = good(R"(<shape type="sphere"><bsdf type="roughconductor"><float name="alpha_u" value="0.25"/>
        <float name="alpha_v" value="0.05"/><string name="distribution" value="ggx"/><spectrum name="eta" value="0.5"/>
        <rgb name="k" value="1, 2, 3"/></bsdf></shape>
        <shape type="sphere"><bsdf type="roughplastic"/></shape>)");
    const auto& metal = std::get<scene::ConductorMaterial>(scene.materials.at(0).model);
    EXPECT_EQ(metal.facets, (scene::Facets{scene::Facets::Distribution::ggx, true, true}));
    // What the world makes of it: alpha = r^2 sqrt(1 - 0.9 a) along u.
    const double r_2 = metal.roughness.number * metal.roughness.number, aspect = std::sqrt(1.0 - 0.9 * metal.anisotropy.number);
    EXPECT_NEAR(r_2 * aspect, 0.25, 1e-12);
    EXPECT_NEAR(r_2 / aspect, 0.05, 1e-12);
    EXPECT_EQ(std::get<scene::Rgb>(metal.n.value()), scene::Rgb(0.5));
    EXPECT_EQ(std::get<scene::Rgb>(metal.k.value()), scene::Rgb(1, 2, 3));
    const auto& plastic = std::get<scene::PlasticMaterial>(scene.materials.at(1).model);
    EXPECT_EQ(plastic.facets, (scene::Facets{scene::Facets::Distribution::beckmann, true, true}));
    EXPECT_NEAR(plastic.roughness.number, std::sqrt(0.1), 1e-12);
}

TEST_F(Mitsuba, ThePrincipledPairIsBurleys) {
    const scene::Scene scene = good(R"(<shape type="sphere"><bsdf type="principled"><float name="specular" value="0.7"/>
        <float name="sheen" value="0.4"/><texture name="clearcoat" type="checkerboard"/></bsdf></shape>
        <shape type="sphere"><bsdf type="principledthin"><float name="diff_trans" value="1.4"/></bsdf></shape>)");
    const auto& thick = std::get<scene::BurleyMaterial>(scene.materials.at(0).model);
    EXPECT_NEAR(thick.refraction, 2.0 / (1.0 - std::sqrt(0.056)) - 1.0, 1e-12);
    EXPECT_EQ(thick.sheen.number, 0.4);
    EXPECT_TRUE(thick.coat.texture);
    const auto& thin = std::get<scene::BurleyMaterial>(scene.materials.at(1).model);
    EXPECT_TRUE(thin.thin);
    EXPECT_EQ(thin.passes.number, 0.7);
    EXPECT_EQ(thin.refraction, 1.5);
}

TEST_F(Mitsuba, SpectraStaySpectra) {
    const scene::Scene scene =
        good(R"(<shape type="sphere"><bsdf type="diffuse"><spectrum name="reflectance" value="400:0.2, 700:0.8"/></bsdf>
        <emitter type="area"><spectrum name="radiance" value="2"/></emitter></shape>)");
    const auto& color = std::get<scene::Color>(std::get<scene::DiffuseMaterial>(scene.materials.at(0).model).color);
    ASSERT_TRUE(color.spectrum);
    EXPECT_EQ(std::get<scene::MeasuredSpectrum>(color.spectrum->shape).values, (std::vector<double>{0.0, 0.2, 0.8, 0.0}));
    const auto& light = std::get<scene::Color>(scene.materials.at(0).emission.value().radiance);
    ASSERT_TRUE(light.spectrum);
    EXPECT_EQ(std::get<scene::MeasuredSpectrum>(light.spectrum->shape).values, (std::vector<double>{1.0, 1.0}));
    EXPECT_EQ(light.spectrum->scale, 2.0);
    EXPECT_EQ(light.spectrum->as_rgb.value(), scene::Rgb(1.0)) << "white where light is red, green and blue";
}

TEST_F(Mitsuba, SkiesAreTurnedAndMirrored) {
    folder_.write("sky.pfm", std::string("PF\n2 1\n-1.0\n") + std::string(24, '\0'));
    const std::string text = R"(<emitter type="envmap"><string name="filename" value="sky.pfm"/><float name="scale" value="3"/>
        <transform name="to_world">)";
    const scene::Scene scene = good(text + R"(<rotate x="1" angle="90"/><scale x="-2" y="2" z="2"/></transform></emitter>)");
    ASSERT_TRUE(scene.background.image);
    EXPECT_EQ(scene.background.rotation, 180.0);
    EXPECT_EQ(scene.background.strength, 3.0);
    EXPECT_NEAR(glm::distance(scene.background.axes[0], glm::dvec3(-1, 0, 0)), 0.0, 1e-12);
    EXPECT_NEAR(glm::distance(scene.background.axes[1], glm::dvec3(0, 0, 1)), 0.0, 1e-12);
    EXPECT_NEAR(glm::distance(scene.background.axes[2], glm::dvec3(0, -1, 0)), 0.0, 1e-12);
    expect_error(text + R"(<rotate z="1" angle="45"/><scale x="3"/><rotate z="1" angle="20"/></transform></emitter>)", "not squeezed");
}

TEST_F(Mitsuba, CheckersOfAnyShape) {
    const scene::Scene scene = good(R"(<shape type="sphere"><bsdf type="diffuse"><texture name="reflectance" type="checkerboard">
        <transform name="to_uv"><scale x="4" y="2"/><translate x="0.25"/></transform></texture></bsdf></shape>)");
    const auto& image = std::get<scene::ImageTexture>(std::get<scene::DiffuseMaterial>(scene.materials.at(0).model).color);
    EXPECT_EQ(image.filter, scene::Filter::nearest);
    EXPECT_EQ(image.scale, glm::dvec2(4, -2)) << "pictures are stored from the top";
    ASSERT_TRUE(image.bytes);
    const Image squares = read_image(*image.bytes, image.file, Encoding::linear);
    EXPECT_NEAR(double(squares.pixels.at(0)), 0.4, 1e-6);
    EXPECT_NEAR(double(squares.pixels.at(3)), 0.2, 1e-6);
}

// By its definition: the first colour where both coordinates lie in the same half of a unit.
TEST_F(Mitsuba, CheckersLieWhereMitsubaHasThem) {
    scene::Scene scene = good(R"(<sensor type="orthographic"><transform name="to_world"><lookat origin="0 0 5" target="0 0 0" up="0 1 0"/>
            </transform><film type="hdrfilm"><rfilter type="box"/></film></sensor>
        <shape type="rectangle"><emitter type="area"><texture name="radiance" type="checkerboard"><rgb name="color0" value="1"/>
        <rgb name="color1" value="0.25"/><transform name="to_uv"><scale x="2" y="1"/><translate x="0.125" y="0.25"/></transform></texture>
        </emitter></shape>)");
    constexpr int size = 32;
    scene.settings.rgb = true;
    const Film film = film_of(scene, size, size, 4);
    ASSERT_EQ(film.width, size);
    const auto half = [](double x) { return x - std::floor(x) > 0.5; };
    int bright = 0;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const double u = (x + 0.5) / size, v = 1.0 - (y + 0.5) / size;  // v grows upwards on a rectangle
            const double expected = half(2.0 * u + 0.125) == half(v + 0.25) ? 1.0 : 0.25;
            EXPECT_NEAR(double(film.radiance[static_cast<std::size_t>(y * size + x)].y), expected, 1e-3) << x << " " << y;
            bright += expected == 1.0 ? 1 : 0;
        }
    }
    EXPECT_GT(bright, 0);
    EXPECT_LT(bright, size * size);
}

TEST_F(Mitsuba, ProjectorsAndSpotsThrowPictures) {
    folder_.write("two.ppm", std::string("P6\n3 2\n255\n") + std::string(18, '\x7f'));
    const std::string projector =
        R"(<emitter type="projector"><texture type="bitmap" name="irradiance"><string name="filename" value="two.ppm"/>
        </texture></emitter><emitter type="spot"><float name="cutoff_angle" value="30"/><float name="beam_width" value="10"/>
        <texture type="bitmap" name="texture"><string name="filename" value="two.ppm"/></texture></emitter>)";
    const scene::Scene scene = good(projector);
    const auto& thrown = std::get<scene::ProjectorLight>(scene.lights.at(0).model);
    // A lens of 50 mm before a film of 36 x 24 mm, along the diagonal of a picture of 3 x 2.
    EXPECT_NEAR(thrown.fov, glm::degrees(2.0 * std::atan(18.0 / 50.0)), 1e-9);
    EXPECT_EQ(thrown.fov_axis, scene::ProjectorFov::width);
    EXPECT_EQ(thrown.image.value().wrap, scene::Wrap::repeat);
    EXPECT_FALSE(scene.lights[0].power.value().spectrum) << "under daylight";
    const auto& spot = std::get<scene::SpotLight>(scene.lights.at(1).model);
    EXPECT_EQ(spot.fade, scene::SpotFade::even);
    EXPECT_EQ(spot.falloff, 20.0);
    EXPECT_EQ(spot.up, glm::dvec3(0, -1, 0)) << "its picture stands on its head";
    const Import old = read(projector, {}, "2.1.0");
    ASSERT_TRUE(old.scene) << old.all();
    const auto& light = old.scene->lights.at(0).power.value().spectrum;
    ASSERT_TRUE(light) << "under no illuminant";
    EXPECT_TRUE(std::holds_alternative<scene::MeasuredSpectrum>(light->shape));
    EXPECT_EQ(light->as_rgb.value(), scene::Rgb(1.0));
}

// A window of the film shows what the whole film shows there.
TEST_F(Mitsuba, WindowsOfTheFilm) {
    const auto text = [](const std::string& crop, const std::string& offset) {
        return R"(<sensor type="perspective"><float name="fov" value="70"/>)" + offset +
               R"(<transform name="to_world"><lookat origin="0 0 2" target="0.3 0.2 0" up="0 1 0"/></transform>
                <film type="hdrfilm"><integer name="width" value="40"/><integer name="height" value="30"/>)" +
               crop + R"(<rfilter type="box"/></film></sensor>
            <shape type="rectangle"><transform name="to_world"><scale value="9"/></transform><emitter type="area">
            <texture name="radiance" type="checkerboard"><transform name="to_uv"><scale value="7"/></transform></texture></emitter></shape>)";
    };
    const scene::Scene whole = good(text("", ""));
    const scene::Scene part = good(text(R"(<integer name="crop_offset_x" value="21"/><integer name="crop_offset_y" value="4"/>
        <integer name="crop_width" value="13"/><integer name="crop_height" value="9"/>)",
                                        ""));
    const scene::Scene moved = good(text("", R"(<float name="principal_point_offset_x" value="0.25"/>
        <float name="principal_point_offset_y" value="0.1"/>)"));
    EXPECT_EQ(part.settings.width, 13);
    EXPECT_EQ(part.settings.height, 9);
    const Film all = film_of(whole, 40, 30, 64), window = film_of(part, 13, 9, 64), shifted = film_of(moved, 40, 30, 64);
    int same = 0, same_shifted = 0;
    for (int y = 0; y < 9; ++y) {
        for (int x = 0; x < 13; ++x) {
            const float there = all.radiance[static_cast<std::size_t>((y + 4) * 40 + x + 21)].y;
            same += std::abs(window.radiance[static_cast<std::size_t>(y * 13 + x)].y - there) < 0.02f ? 1 : 0;
            // A quarter of 40 pixels to the left, a tenth of 30 upwards.
            const float here = shifted.radiance[static_cast<std::size_t>((y + 4 - 3) * 40 + x + 21 - 10)].y;
            same_shifted += std::abs(here - there) < 0.02f ? 1 : 0;
        }
    }
    EXPECT_GT(same, 100) << "of 117, but for noise";
    EXPECT_GT(same_shifted, 100);
}

TEST_F(Mitsuba, SkiesStandAsTheyAreTurned) {
    const scene::Scene scene = good(R"(<emitter type="sunsky"><float name="latitude" value="0"/><float name="longitude" value="0"/>
        <float name="timezone" value="0"/><integer name="year" value="2020"/><integer name="month" value="3"/><integer name="day" value="20"/>
        <float name="hour" value="15"/><float name="turbidity" value="4"/></emitter>)");
    ASSERT_TRUE(scene.background.sky);
    const scene::ClearSky& sky = *scene.background.sky;
    EXPECT_EQ(sky.up, glm::dvec3(0, 0, 1));
    EXPECT_EQ(sky.turbidity, 4.0);
    // The afternoon of an equinox on the equator: half way down to the west, where x shrinks.
    EXPECT_NEAR(glm::distance(sky.sun, glm::normalize(glm::dvec3(-1, 0, 1))), 0.0, 0.05);
    const scene::Scene turned = good(R"(<emitter type="sky"><vector name="sun_direction" value="0 1 1"/>
        <transform name="to_world"><rotate x="1" angle="-90"/></transform></emitter>)");
    EXPECT_NEAR(glm::distance(turned.background.sky->up, glm::dvec3(0, 1, 0)), 0.0, 1e-12);
    EXPECT_NEAR(glm::distance(turned.background.sky->sun, glm::normalize(glm::dvec3(0, 1, 1))), 0.0, 1e-12);
    EXPECT_FALSE(turned.background.sky->has_sun);
}

TEST_F(Mitsuba, WidthsOfFacetsFromATexture) {
    const scene::Scene scene = good(R"(<shape type="sphere"><bsdf type="roughconductor"><texture name="alpha" type="checkerboard">
        <float name="color0" value="0.04"/><float name="color1" value="0.25"/></texture></bsdf></shape>)");
    const auto& roughness = std::get<scene::ConductorMaterial>(scene.materials.at(0).model).roughness;
    ASSERT_TRUE(roughness.texture);
    const auto& checker = std::get<scene::Checker>(*roughness.texture);
    EXPECT_NEAR(checker.first.x, 0.5, 1e-12) << "numbers the other way round than colours, as Mitsuba has it";
    EXPECT_NEAR(checker.second.x, 0.2, 1e-12);
}

}  // namespace
}  // namespace lancer
