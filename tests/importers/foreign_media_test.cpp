// Media of Mitsuba's and pbrt's scenes.
#include <cstring>

#include "rendered.h"

namespace lancer {
namespace {

using namespace lancer::testing;

std::string vol_of_one(float value) {
    std::string vol("VOL\x03", 4);
    const std::int32_t header[5] = {1, 1, 1, 1, 1};
    const float box[6] = {-1.0f, -1.0f, -1.0f, 1.0f, 1.0f, 1.0f};
    vol.append(reinterpret_cast<const char*>(header), sizeof header).append(reinterpret_cast<const char*>(box), sizeof box);
    return vol.append(reinterpret_cast<const char*>(&value), sizeof value);
}

TEST(ForeignMedia, OfMitsuba) {
    const TemporaryFolder folder;
    folder.write("a.vol", vol_of_one(0.5f));
    const Reading r = read_path(folder.write("scene.xml", R"(<scene version="3.0.0">
        <medium type="homogeneous" id="fog">
            <rgb name="sigma_t" value="1, 2, 3"/><rgb name="albedo" value="0.9, 0.8, 0.7"/><float name="scale" value="5"/>
            <phase type="hg"><float name="g" value="0.4"/></phase>
        </medium>
        <sensor type="perspective"><ref id="fog"/></sensor>
        <shape type="sphere"><bsdf type="null"/>
            <medium name="interior" type="heterogeneous">
                <volume name="sigma_t" type="gridvolume"><string name="filename" value="a.vol"/>
                    <transform name="to_world"><scale value="2"/></transform></volume>
                <volume name="albedo" type="constvolume"><rgb name="value" value="0.1, 0.2, 0.3"/></volume>
                <phase type="rayleigh"/>
            </medium></shape>
        <shape type="sphere"><bsdf type="dielectric"/><ref id="fog" name="exterior"/></shape>
        <shape type="sphere"><bsdf type="null"/></shape>
        <emitter type="constant"/></scene>)"));
    ASSERT_TRUE(r.scene) << r.all();
    EXPECT_EQ(r.all(), "");
    ASSERT_EQ(r.scene->media.size(), 2u);
    const scene::Medium& cloud = r.scene->media[0];
    EXPECT_EQ(cloud.phase, scene::Phase::rayleigh);
    EXPECT_EQ(std::get<scene::ExtinctionAlbedo>(cloud.coefficients).extinction.rgb, scene::Rgb(1.0));
    EXPECT_EQ(std::get<scene::ExtinctionAlbedo>(cloud.coefficients).albedo.rgb, scene::Rgb(0.1, 0.2, 0.3));
    EXPECT_EQ(cloud.density.value().data->values, std::vector<float>({0.5f}));
    EXPECT_EQ(glm::dvec3(cloud.density.value().to_world * glm::dvec4(1, 1, 1, 1)), glm::dvec3(2.0))
        << "the file's box counts where it is asked for";
    EXPECT_EQ(r.scene->medium, 1) << "what is around the camera is everywhere";
    const scene::Medium& fog = r.scene->media[1];
    EXPECT_EQ(fog.scale, 5.0);
    EXPECT_EQ(fog.asymmetry, 0.4);
    EXPECT_EQ(std::get<scene::ExtinctionAlbedo>(fog.coefficients).extinction.rgb, scene::Rgb(1, 2, 3));
    ASSERT_EQ(r.scene->objects.size(), 2u) << "a null border around nothing is nothing";
    const auto material = [&](std::size_t object) {
        return r.scene->materials[static_cast<std::size_t>(r.scene->objects[object].material)];
    };
    EXPECT_TRUE(std::holds_alternative<scene::NullMaterial>(material(0).model));
    EXPECT_EQ(material(0).interior, 0);
    EXPECT_FALSE(material(1).interior);
}

TEST(ForeignMedia, OfPbrt) {
    const TemporaryFolder folder;
    const Reading r = read_path(folder.write("scene.pbrt", R"(MediumInterface "" "haze"
Camera "perspective"
WorldBegin
LightSource "point" "rgb I" [1 1 1]
MakeNamedMedium "haze" "string type" "homogeneous" "rgb sigma_a" [0.1 0.2 0.3] "rgb sigma_s" [1 2 3] "float g" 0.5 "float scale" 2
Translate 10 0 0
MakeNamedMedium "cloud" "string type" "uniformgrid" "integer nx" 2 "integer ny" 1 "integer nz" 1 "float density" [0.25 0.5]
    "point3 p0" [0 0 0] "point3 p1" [2 1 1]
MakeNamedMedium "colors" "string type" "rgbgrid" "rgb sigma_a" [1 0 3] "rgb sigma_s" [1 0 1]
MediumInterface "cloud" "haze"
Material "interface"
Shape "sphere"
MediumInterface "colors" "haze"
Material "dielectric"
Shape "sphere"
Material "diffuse"
Shape "sphere"
)"));
    ASSERT_TRUE(r.scene) << r.all();
    EXPECT_EQ(r.all(), "");
    ASSERT_EQ(r.scene->media.size(), 3u);
    const auto material = [&](std::size_t object) {
        return r.scene->materials[static_cast<std::size_t>(r.scene->objects[object].material)];
    };
    EXPECT_TRUE(std::holds_alternative<scene::NullMaterial>(material(0).model));
    const scene::Medium& cloud = r.scene->media[static_cast<std::size_t>(material(0).interior.value())];
    EXPECT_EQ(cloud.density.value().data->values, std::vector<float>({0.25f, 0.5f}));
    EXPECT_EQ(glm::dvec3(cloud.density.value().to_world * glm::dvec4(1, 1, 1, 1)), glm::dvec3(-12, 1, 1));
    EXPECT_TRUE(cloud.density.value().fades);
    const scene::Medium& colors = r.scene->media[static_cast<std::size_t>(material(1).interior.value())];
    EXPECT_EQ(colors.density.value().data->values, std::vector<float>({2.0f, 0.0f, 4.0f}));
    EXPECT_EQ(colors.albedo.value().data->values, std::vector<float>({0.5f, 0.0f, 0.25f}));
    EXPECT_FALSE(material(2).interior);
    const scene::Medium& haze = r.scene->media[static_cast<std::size_t>(r.scene->medium.value())];
    EXPECT_EQ(std::get<scene::AbsorbingScattering>(haze.coefficients).scattering.rgb, scene::Rgb(1, 2, 3));
    EXPECT_EQ(haze.scale, 2.0);
    EXPECT_EQ(haze.asymmetry, 0.5);
}

// The middle of what is bright in a picture, in parts of its size from the upper left corner.
glm::dvec2 bright_middle(const Film& film) {
    glm::dvec2 middle(0.0);
    double sum = 0.0;
    for (int y = 0; y < film.height; ++y) {
        for (int x = 0; x < film.width; ++x) {
            const double light = static_cast<double>(film.radiance[static_cast<std::size_t>(y * film.width + x)].y);
            middle += light * glm::dvec2((x + 0.5) / film.width, (y + 0.5) / film.height);
            sum += light;
        }
    }
    EXPECT_GT(sum, 0.0);
    return middle / std::max(sum, 1e-9);
}

// A cell of a grid glows where a ball at its place does, whichever hand the file's space has.
TEST(ForeignMedia, PbrtsGridsLieWhereItsShapesDo) {
    const TemporaryFolder folder;
    for (const std::string& camera :
         {std::string("Scale -1 1 1\nTranslate 0 0 9\n"), std::string("Translate 0 0 9\n"), std::string("LookAt 3 4 -7  0 0 0  0 1 0\n")}) {
        const std::string head = camera + R"(Camera "perspective" "float fov" 50
Film "rgb" "integer xresolution" 48 "integer yresolution" 48
Integrator "volpath" "integer maxdepth" 2
WorldBegin
)";
        const std::string cell = "0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 1 0 0 0 0 0 0 0 0 0 0 0 ";  // x 0, y 2, z 1 of three
        const Reading grid = read_path(folder.write("grid.pbrt", head + R"(MakeNamedMedium "glow" "string type" "uniformgrid"
  "integer nx" 3 "integer ny" 3 "integer nz" 3 "float density" [)" + cell +
                                                                     R"(] "point3 p0" [-3 -3 -3] "point3 p1" [3 3 3]
  "rgb sigma_a" [1 1 1] "rgb sigma_s" [0 0 0] "rgb Le" [1 1 1]
MediumInterface "glow" ""
Material "interface"
Shape "sphere" "float radius" 6
)"));
        const Reading ball = read_path(folder.write("ball.pbrt", head + R"(Translate -2 2 0
AreaLightSource "diffuse" "rgb L" [1 1 1]
Shape "sphere" "float radius" 1
)"));
        ASSERT_TRUE(grid.scene && ball.scene) << grid.all() << ball.all();
        const glm::dvec2 glows = bright_middle(film_of(*grid.scene, 48, 48, 16)), shines = bright_middle(film_of(*ball.scene, 48, 48, 16));
        EXPECT_NEAR(glm::distance(glows, shines), 0.0, 0.03) << camera;
        EXPECT_GT(glm::distance(shines, glm::dvec2(0.5)), 0.1) << "off the middle, so that a mirrored one would be seen";
    }
}

}  // namespace
}  // namespace lancer
