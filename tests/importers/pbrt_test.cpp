#include <algorithm>

#include <glm/geometric.hpp>

#include "lancer/image/image.h"
#include "lancer/spectrum/observer.h"
#include "rendered.h"

namespace lancer {
namespace {

using namespace lancer::testing;

Reading read_pbrt_text(const std::string& text) {
    const TemporaryFolder folder;
    return read_path(folder.write("scene.pbrt", text));
}

const std::string lit = "LightSource \"point\" \"rgb I\" [1 1 1]\n";

TEST(Pbrt, ReadsATriangleWithItsCameraAndSettings) {
    const Reading r = read_pbrt_text(
        "LookAt 0 0 5  0 0 0  0 1 0 # from +z\n"
        "Camera \"perspective\" \"float fov\" 40\n"
        "Film \"rgb\" \"integer xresolution\" 200 \"integer yresolution\" [ 100 ]\n"
        "Sampler \"halton\" \"integer pixelsamples\" 8\n"
        "Integrator \"path\" \"integer maxdepth\" 3\n"
        "WorldBegin\n" +
        lit + "Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0] \"integer indices\" [0 1 2]\n");
    ASSERT_TRUE(r.scene) << r.all();
    EXPECT_EQ(r.all(), "");
    EXPECT_EQ(r.scene->settings.width, 200);
    EXPECT_EQ(r.scene->settings.spp, 8);
    EXPECT_EQ(r.scene->settings.bounces, 3);
    const scene::Camera& camera = r.scene->cameras.at(0);
    EXPECT_NEAR(glm::distance(camera.position, glm::dvec3(0, 0, 5)), 0.0, 1e-12);
    EXPECT_NEAR(glm::distance(camera.direction, glm::dvec3(0, 0, -1)), 0.0, 1e-12);
    EXPECT_NEAR(camera.fov, 40.0, 1e-9);
    EXPECT_EQ(camera.fov_axis, scene::FovAxis::height) << "the shorter side";
    ASSERT_EQ(r.scene->objects.size(), 1u);
    EXPECT_EQ(std::get<scene::Mesh>(r.scene->objects[0].shape).data->triangles.at(0), glm::uvec3(0, 1, 2));
}

TEST(Pbrt, SaysWhereNumbersAreWrong) {
    const Reading r = read_pbrt_text("WorldBegin\nShape \"sphere\"\n  \"float radius\" [ 1.2.3 ]\n");
    ASSERT_FALSE(r.scene);
    EXPECT_NE(r.all().find("scene.pbrt:3:20: error: Shape \"sphere\": \"radius\" needs numbers, found 1.2.3"), std::string::npos)
        << r.all();
}

TEST(Pbrt, AFileMayNotIncludeItself) {
    const TemporaryFolder folder;
    folder.write("b.pbrt", "Include \"a.pbrt\"\n");
    const Reading r = read_path(folder.write("a.pbrt", "WorldBegin\nInclude \"b.pbrt\"\n"));
    ASSERT_FALSE(r.scene);
    EXPECT_NE(r.all().find("includes itself"), std::string::npos) << r.all();
}

TEST(Pbrt, NormalsSayWhichSideShines) {
    const Reading r = read_pbrt_text(
        "WorldBegin\nAreaLightSource \"diffuse\" \"rgb L\" [2 2 2] \"float scale\" 3\n"
        "Shape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0] \"normal N\" [0 0 -1 0 0 -1 0 0 -1]\n"
        "ReverseOrientation\nShape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0]\n");
    ASSERT_TRUE(r.scene) << r.all();
    const scene::Object& first = r.scene->objects.at(0);
    EXPECT_EQ(std::get<scene::Mesh>(first.shape).data->triangles.at(0), glm::uvec3(0, 2, 1));
    EXPECT_EQ(r.scene->materials.at(static_cast<std::size_t>(first.material)).emission.value().strength, 3.0);
    EXPECT_EQ(std::get<scene::Mesh>(r.scene->objects.at(1).shape).data->triangles.at(0), glm::uvec3(0, 2, 1));
}

// After LookAt, +x of the world is to the right of the picture where it would be to the left in a right-handed one.
TEST(Pbrt, TurnsLeftHandedWorldsRound) {
    const std::string world = "WorldBegin\n" + lit + "Translate 3 2 1 Shape \"sphere\"\n";
    const Reading left = read_pbrt_text("LookAt 0 0 5  0 0 0  0 1 0 Camera \"perspective\"\n" + world);
    const Reading right = read_pbrt_text("Scale -1 1 1 LookAt 0 0 5  0 0 0  0 1 0 Camera \"perspective\"\n" + world);
    ASSERT_TRUE(left.scene && right.scene) << left.all() << right.all();
    const auto right_of_picture = [](const scene::Scene& scene) {
        const scene::Camera& camera = scene.cameras.at(0);
        return glm::dot(glm::cross(camera.direction, camera.up), glm::dvec3(scene.objects.at(0).to_parent[3]) - camera.position);
    };
    EXPECT_NEAR(right_of_picture(*left.scene), -3.0, 1e-9) << "LookAt's +x is up x forward";
    EXPECT_NEAR(right_of_picture(*right.scene), 3.0, 1e-9);
    EXPECT_NEAR(left.scene->objects.at(0).to_parent[3].y, 2.0, 1e-9);
}

TEST(Pbrt, PlacesObjectsWithBothTransforms) {
    const Reading r = read_pbrt_text("Scale -1 1 1\nCamera \"perspective\"\nWorldBegin\n" + lit +
                                     "ObjectBegin \"o\" Translate 0 0 2 Shape \"sphere\" ObjectEnd\n"
                                     "AttributeBegin Translate 5 0 0 ObjectInstance \"o\" AttributeEnd\nObjectInstance \"o\"\n");
    ASSERT_TRUE(r.scene) << r.all();
    ASSERT_EQ(r.scene->placements.size(), 2u);
    EXPECT_EQ(r.scene->placements[0].to_parent[3].x, 5.0);
    EXPECT_EQ(r.scene->placements[1].to_parent[3].x, 0.0);
    EXPECT_EQ(r.scene->groups.at(0).objects.at(0).to_parent[3].z, 2.0);
}

TEST(Pbrt, LightsAreAsBrightAsPbrtMakesThem) {
    const Reading r = read_pbrt_text(
        "Camera \"perspective\" \"float shutterclose\" 0.5\nFilm \"rgb\" \"float iso\" 400\nWorldBegin\n"
        "LightSource \"point\" \"rgb I\" [1 2 3] \"float scale\" 2\n"
        "LightSource \"point\" \"float power\" 12.566370614359172\n"
        "LightSource \"distant\" \"blackbody L\" 5000 \"float illuminance\" 7\n");
    ASSERT_TRUE(r.scene) << r.all();
    const double sensitivity = 400.0 / 100.0 * 0.5;
    EXPECT_EQ(*r.scene->lights.at(0).power, scene::Rgb(2, 4, 6) * sensitivity);
    EXPECT_NEAR(r.scene->lights.at(1).power->rgb.y, sensitivity, 1e-9);
    const auto& sun = r.scene->lights.at(2).power->spectrum;
    ASSERT_TRUE(sun);
    const auto* measured = std::get_if<scene::MeasuredSpectrum>(&sun->shape);
    ASSERT_TRUE(measured);
    EXPECT_LT(measured->values.front(), measured->values.back()) << "at 5000 kelvin there is less violet than deep red";
    double seen = 0.0;  // by steps of a nanometre
    for (int nm = 360; nm < 830; ++nm) {
        const auto& at = measured->nanometres;
        const auto next = std::clamp<std::ptrdiff_t>(std::upper_bound(at.begin(), at.end(), nm + 0.5) - at.begin(), 1, std::ssize(at) - 1);
        const auto i = static_cast<std::size_t>(next);
        const double part = (nm + 0.5 - at[i - 1]) / (at[i] - at[i - 1]);
        seen += (measured->values[i - 1] * (1.0 - part) + measured->values[i] * part) * cie_1931_fine(nm + 0.5).y / cie_1931_area();
    }
    EXPECT_NEAR(sun->luminance.value_or(seen) * sun->scale, 7.0 * sensitivity, 1e-2 * 7.0);
    EXPECT_FALSE(r.scene->settings.rgb) << "a black body is a spectrum";
}

TEST(Pbrt, TheLastDefaultsOfAttributeCount) {
    const Reading r = read_pbrt_text("WorldBegin\n" + lit +
                                     "Attribute \"shape\" \"float radius\" 3\nShape \"sphere\"\nShape \"sphere\" \"float radius\" 2\n");
    ASSERT_TRUE(r.scene) << r.all();
    EXPECT_EQ(std::get<scene::Sphere>(r.scene->objects.at(0).shape).radius, 3.0);
    EXPECT_EQ(std::get<scene::Sphere>(r.scene->objects.at(1).shape).radius, 2.0);
}

TEST(Pbrt, TessellatesPartsOfSpheres) {
    const Reading r = read_pbrt_text("WorldBegin\n" + lit + "Shape \"sphere\" \"float zmin\" 0 \"float phimax\" 90\n");
    ASSERT_TRUE(r.scene) << r.all();
    EXPECT_EQ(r.all(), "");
    const scene::TriangleMesh& mesh = *std::get<scene::Mesh>(r.scene->objects.at(0).shape).data;
    double area = 0.0;
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
        const glm::dvec3 across = glm::cross(b - a, c - a);
        area += 0.5 * glm::length(across);
        EXPECT_GT(glm::dot(across, a + b + c), 0.0) << "outwards";
    }
    EXPECT_NEAR(area, 3.14159265 / 2.0, 2e-3) << "an eighth of 4 pi";
}

// A cage of an octahedron becomes round: its corners move to the half, its faces' middles, at 0.577, to 0.42, and the normals with them.
TEST(Pbrt, SubdividesToASmoothSurface) {
    const Reading r = read_pbrt_text("WorldBegin\n" + lit +
                                     "Shape \"loopsubdiv\" \"integer levels\" 4 \"point3 P\" [1 0 0 -1 0 0 0 1 0 0 -1 0 0 0 1 0 0 -1]\n"
                                     "\"integer indices\" [0 2 4 2 1 4 1 3 4 3 0 4 2 0 5 1 2 5 3 1 5 0 3 5]\n");
    ASSERT_TRUE(r.scene) << r.all();
    const scene::TriangleMesh& mesh = *std::get<scene::Mesh>(r.scene->objects.at(0).shape).data;
    EXPECT_EQ(mesh.triangles.size(), 8u * 256u);
    const double middle = double(glm::length(mesh.positions.at(0)));
    EXPECT_NEAR(middle, 0.5, 1e-5);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        EXPECT_LE(double(glm::length(mesh.positions[i])), 1.0001 * middle);
        EXPECT_GT(double(glm::length(mesh.positions[i])), 0.8 * middle);
        EXPECT_GT(glm::dot(mesh.normals[i], glm::normalize(mesh.positions[i])), 0.95f);
    }
}

TEST(Pbrt, TakesOverWhatVersion3Says) {
    const Reading r = read_pbrt_text(
        "Film \"image\" \"integer xresolution\" [70] \"integer yresolution\" [50]\nWorldBegin\n"
        "Material \"matte\" \"color Kd\" [.1 .2 .3]\nShape \"sphere\"\n"
        "LightSource \"point\" \"color I\" [1 1 1]\nWorldEnd\n");
    ASSERT_TRUE(r.scene) << r.all();
    EXPECT_NE(r.all().find("version 3"), std::string::npos) << r.all();
    const auto& matte = std::get<scene::DiffuseMaterial>(r.scene->materials.at(0).model);
    EXPECT_EQ(std::get<scene::Color>(matte.color), scene::Color(0.1, 0.2, 0.3));
}

TEST(Pbrt, TexturesThatNeedThemselvesAreErrors) {
    const Reading r = read_pbrt_text(
        "WorldBegin\n" + lit +
        "Texture \"a\" \"spectrum\" \"scale\" \"texture tex\" \"b\"\nTexture \"b\" \"spectrum\" \"scale\" \"texture tex\" \"a\"\n"
        "Material \"diffuse\" \"texture reflectance\" \"a\"\nShape \"sphere\"\n");
    ASSERT_FALSE(r.scene);
    EXPECT_NE(r.all().find("needs itself"), std::string::npos) << r.all();
}

// Each file includes the next one twice: 2^40 shapes.
TEST(Pbrt, FilesThatMultiplyAreStopped) {
    const TemporaryFolder folder;
    std::string first;
    for (int i = 0; i < 40; ++i) {
        const std::string next = "Include \"" + std::to_string(i + 1) + ".pbrt\"\n";
        const std::string path = folder.write(std::to_string(i) + ".pbrt", (i == 0 ? "WorldBegin\n" : "") + next + next);
        first = i == 0 ? path : first;
    }
    folder.write("40.pbrt", "Identity\n");
    const Reading r = read_path(first);
    ASSERT_FALSE(r.scene);
    EXPECT_NE(r.all().find("directives"), std::string::npos) << r.all();
}

TEST(Pbrt, BlocksThatAreClosedWronglyAreErrors) {
    const Reading r = read_pbrt_text("WorldBegin\nAttributeBegin\nTransformEnd\nAttributeEnd\nAttributeEnd\n");
    ASSERT_FALSE(r.scene);
    EXPECT_NE(r.all().find(":3:1: error: TransformEnd: what is open was begun at"), std::string::npos) << r.all();
    EXPECT_NE(r.all().find(":5:1: error: AttributeEnd: nothing is open here"), std::string::npos) << r.all();
}

TEST(Pbrt, MetalsKeepTheirIndices) {
    const Reading r = read_pbrt_text("WorldBegin\n" + lit +
                                     "Material \"conductor\" \"rgb eta\" [.2 .9 1.1] \"spectrum k\" [400 2 700 3] \"float roughness\" .09 "
                                     "\"bool remaproughness\" false\nShape \"sphere\"\n");
    ASSERT_TRUE(r.scene) << r.all();
    const auto& metal = std::get<scene::ConductorMaterial>(r.scene->materials.at(0).model);
    EXPECT_NEAR(glm::distance(std::get<scene::Rgb>(metal.n.value()), scene::Rgb(0.2, 0.9, 1.1)), 0.0, 1e-9);
    EXPECT_EQ(std::get<scene::MeasuredSpectrum>(metal.k.value()).values, (std::vector<double>{2.0, 3.0}));
    EXPECT_NEAR(metal.roughness.number, 0.3, 1e-12);
    EXPECT_EQ(metal.facets, (scene::Facets{scene::Facets::Distribution::ggx, false, true})) << "pbrt loses light, with correlated heights";
}

TEST(Pbrt, MixesAndCutOutShapes) {
    const Reading r = read_pbrt_text("WorldBegin\n" + lit +
                                     "MakeNamedMaterial \"a\" \"string type\" \"diffuse\"\nMakeNamedMaterial \"b\" \"string type\" \"mix\" "
                                     "\"string materials\" [\"a\" \"c\"] \"float amount\" .25\n"
                                     "MakeNamedMaterial \"c\" \"string type\" \"conductor\"\n"
                                     "NamedMaterial \"b\"\nShape \"sphere\" \"float alpha\" .5\n");
    ASSERT_TRUE(r.scene) << r.all();
    const scene::Material& mixed = r.scene->materials.at(0);
    const auto& mix = std::get<scene::MixMaterial>(mixed.model);
    EXPECT_EQ(mix.share.number, 0.25);
    EXPECT_EQ(mixed.opacity.number, 0.5);
    EXPECT_TRUE(std::holds_alternative<scene::ConductorMaterial>(r.scene->materials.at(static_cast<std::size_t>(mix.second)).model));
    const Reading circle = read_pbrt_text("WorldBegin\n" + lit +
                                          "MakeNamedMaterial \"b\" \"string type\" \"mix\" \"string materials\" [\"b\" \"b\"]\n"
                                          "NamedMaterial \"b\"\nShape \"sphere\"\n");
    EXPECT_FALSE(circle.scene);
}

TEST(Pbrt, TexturesOfTexturesBecomePictures) {
    const TemporaryFolder folder;
    const float half[12] = {0.5f, 0.5f, 0.5f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f};
    folder.write("p.pfm", std::string("PF\n2 2\n-1.0\n") + std::string(reinterpret_cast<const char*>(half), sizeof half));
    const Reading r = read_path(
        folder.write("scene.pbrt", "WorldBegin\n" + lit +
                                       "Texture \"p\" \"spectrum\" \"imagemap\" \"string filename\" \"p.pfm\" \"float uscale\" 3\n"
                                       "Texture \"q\" \"spectrum\" \"scale\" \"texture tex\" \"p\" \"float scale\" .5\n"
                                       "Material \"diffuse\" \"texture reflectance\" \"q\"\nShape \"sphere\"\n"));
    ASSERT_TRUE(r.scene) << r.all();
    const auto& texture = std::get<scene::ImageTexture>(std::get<scene::DiffuseMaterial>(r.scene->materials.at(0).model).color);
    ASSERT_TRUE(texture.bytes);
    EXPECT_EQ(texture.scale, glm::dvec2(3, 1));
    const Image picture = read_image(*texture.bytes, texture.file, Encoding::linear);
    ASSERT_EQ(picture.width, 2);
    EXPECT_NEAR(double(picture.pixels.at(6)), 0.25, 1e-6) << "the lower left pixel";
    EXPECT_NEAR(double(picture.pixels.at(9)), 0.5, 1e-6);
}

// One white pixel of a square of equal areas, and of latitudes and longitudes: where it is met.
TEST(Pbrt, SkiesOfPicturesOfBothLayouts) {
    const TemporaryFolder folder;
    std::string square = "PF\n8 8\n-1.0\n";
    const float bright[3] = {1.0f, 1.0f, 1.0f};
    const std::size_t head = square.size();
    square.resize(head + 8 * 8 * 12, '\0');
    for (const std::size_t i : {27u, 28u, 35u, 36u}) {  // the middle: +z
        square.replace(head + i * 12, 12, reinterpret_cast<const char*>(bright), 12);
    }
    folder.write("square.pfm", square);
    const Reading r = read_path(folder.write("scene.pbrt",
                                             "WorldBegin\nRotate -90 1 0 0\nLightSource \"infinite\" \"string filename\" \"square.pfm\"\n"
                                             "Shape \"sphere\"\n"));
    ASSERT_TRUE(r.scene) << r.all();
    ASSERT_TRUE(r.scene->background.image);
    const scene::ImageTexture& image = *r.scene->background.image;
    const Image picture = read_image(*image.bytes, image.file, Encoding::linear);
    ASSERT_EQ(picture.width, 2 * picture.height);
    EXPECT_GT(picture.pixels.front(), 0.9f) << "the top row: turned up, +z is +y";
    EXPECT_EQ(picture.pixels.back(), 0.0f);
}

// ---- Lights with pictures, and parts of the film ----------------------------------------------------------------------------------

// One bright pixel of a picture of 4 x 4.
std::string bright_pixel(int column, int row) {
    std::string bytes = "P6\n4 4\n255\n";
    for (int i = 0; i < 16; ++i) {
        bytes += std::string(3, i == row * 4 + column ? '\xff' : '\0');
    }
    return bytes;
}

// Light along x to the right and y up of who looks along z, as pbrt's camera does from the same place: the picture is seen as it is.
TEST(PbrtLights, ProjectorsThrowTheirPictureUpright) {
    const TemporaryFolder folder;
    folder.write("picture.ppm", bright_pixel(3, 0));
    for (const std::string& turn : {std::string(), std::string("Scale -1 1 1\n")}) {
        const Reading r = read_path(folder.write("scene.pbrt", turn + R"(Camera "perspective" "float fov" 60
Film "rgb" "integer xresolution" 8 "integer yresolution" 8
PixelFilter "box"
WorldBegin
LightSource "projection" "float fov" 60 "string filename" "picture.ppm"
Translate 0 0 4
Shape "bilinearmesh" "point3 P" [-9 -9 0 9 -9 0 -9 9 0 9 9 0]
)"));
        ASSERT_TRUE(r.scene) << r.all();
        const Film film = film_of(*r.scene, 8, 8, 16);
        const auto light = [&](int x, int y) { return double(film.radiance[static_cast<std::size_t>(y * 8 + x)].y); };
        // Only the camera is turned over, and shows the picture so.
        const int right = turn.empty() ? 7 : 0;
        EXPECT_GT(light(right, 0), 0.0) << turn;
        EXPECT_LT(light(7 - right, 0) + light(0, 7) + light(7, 7), 0.01 * light(right, 0)) << turn;
    }
}

// The middle of the square lies along the light's y axis, its right along x, its lower edge along z, and its corners along -y.
TEST(PbrtLights, GoniometricLightsLieWithTheirSquareAcrossY) {
    const TemporaryFolder folder;
    std::string bytes = "P6\n8 8\n255\n";
    for (int i = 0; i < 64; ++i) {
        const bool right = i % 8 == 7 && (i / 8 == 2 || i / 8 == 5);  // outside of the diamond of y > 0, on the right: towards x, and down
        bytes += std::string(3, right ? '\xff' : '\0');
    }
    folder.write("picture.ppm", bytes);
    const Reading r = read_path(folder.write("scene.pbrt", R"(LookAt 0 0 -9  0 0 0  0 1 0
Camera "perspective" "float fov" 60
Film "rgb" "integer xresolution" 24 "integer yresolution" 24
WorldBegin
LightSource "goniometric" "string filename" "picture.ppm"
ReverseOrientation
Shape "sphere" "float radius" 3
)"));
    ASSERT_TRUE(r.scene) << r.all();
    const auto& light = std::get<scene::GoniometricLight>(r.scene->lights.at(0).model);
    EXPECT_TRUE(light.image.bytes);
    const Image picture = read_image(*light.image.bytes, light.image.file, Encoding::linear);
    // Where the panorama is bright: below the horizon, and along x, which the space's other hand turns to -x.
    glm::dvec3 towards(0.0);
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const double tilt = 3.14159265358979 * (y + 0.5) / picture.height,
                         around = 3.14159265358979 * (2.0 * (x + 0.5) / picture.width - 1.0);
            const glm::dvec3 way(std::sin(around) * std::sin(tilt), std::cos(tilt), -std::cos(around) * std::sin(tilt));
            towards += way * std::sin(tilt) * double(picture.pixels[static_cast<std::size_t>(y * picture.width + x) * 3]);
        }
    }
    towards = glm::normalize(towards);
    EXPECT_LT(towards.x, -0.5);
    EXPECT_LT(towards.y, -0.3);
    EXPECT_NEAR(towards.z, 0.0, 0.1);
}

TEST(Pbrt, PartsOfTheFilmAndShiftedWindows) {
    const auto seen = [](const std::string& camera, const std::string& film) {
        const Reading r = read_pbrt_text("LookAt 0 0 3  0.4 0.2 0  0 1 0\nCamera \"perspective\" \"float fov\" 60 " + camera +
                                         "\nFilm \"rgb\" \"integer xresolution\" 40 \"integer yresolution\" 30 " + film +
                                         "\nPixelFilter \"box\"\nWorldBegin\n"
                                         "AreaLightSource \"diffuse\" \"rgb L\" [1 1 1] \"bool twosided\" true\n"
                                         "Shape \"trianglemesh\" \"point3 P\" [0 0 0 2 0.3 0 0.4 1.7 0] \"integer indices\" [0 1 2]\n");
        EXPECT_TRUE(r.scene) << r.all();
        return r.scene.value_or(scene::Scene{});
    };
    const scene::Scene whole = seen("", ""), part = seen("", "\"float cropwindow\" [0.3 0.8 0.2 0.7]");
    EXPECT_EQ(part.settings.width, 20);
    EXPECT_EQ(part.settings.height, 15);
    // The same part, by the window of the screen: the shorter side runs from -1 to 1.
    const scene::Scene moved = seen("\"float screenwindow\" [-0.53333333333 0.8 -0.4 0.6]", "");
    const Film all = film_of(whole, 40, 30, 64), crop = film_of(part, 20, 15, 64), window = film_of(moved, 20, 15, 64);
    int same = 0, same_window = 0, lighted = 0;
    for (int y = 0; y < 15; ++y) {
        for (int x = 0; x < 20; ++x) {
            const float there = all.radiance[static_cast<std::size_t>((y + 6) * 40 + x + 12)].y;
            same += std::abs(crop.radiance[static_cast<std::size_t>(y * 20 + x)].y - there) < 0.05f ? 1 : 0;
            same_window += std::abs(window.radiance[static_cast<std::size_t>(y * 20 + x)].y - there) < 0.05f ? 1 : 0;
            lighted += there > 0.5f ? 1 : 0;
        }
    }
    EXPECT_GT(lighted, 60);
    EXPECT_LT(lighted, 240);
    EXPECT_GT(same, 285) << "of 300, but for noise at edges";
    EXPECT_GT(same_window, 285);
    const scene::Scene wide = seen("\"float frameaspectratio\" 2.6666666667", "");
    EXPECT_NEAR(wide.cameras[0].pixel_aspect, 2.0, 1e-6) << "twice as wide a window as the film has pixels for";
}

}  // namespace
}  // namespace lancer
