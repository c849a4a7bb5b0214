// What the TOML notation can say.
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "reading.h"

namespace lancer {
namespace {

using namespace lancer::testing;
using scene::Rgb;

template <class Vector>
void expect_near(const Vector& a, const Vector& b, double tolerance = 1e-12) {
    EXPECT_LT(glm::length(a - b), tolerance) << "(" << a[0] << ", " << a[1] << ", ...) is not (" << b[0] << ", " << b[1] << ", ...)";
}

const scene::WhittedMaterial& whitted(const scene::Scene& scene, std::size_t material) {
    return std::get<scene::WhittedMaterial>(scene.materials.at(material).model);
}

template <class Shape>
const Shape& shape(const scene::Scene& scene, std::size_t object = 0) {
    return std::get<Shape>(scene.objects.at(object).shape);
}

glm::dvec3 map(const glm::dmat4& matrix, const glm::dvec3& point) { return glm::dvec3(matrix * glm::dvec4(point, 1.0)); }

TEST(Toml, ReadsAShortScene) {
    const Reading reading = read_text(R"(
[camera]
position = [0, 1.6, 5]
look_at  = [0, 1, 0]
fov      = 60                      # degrees, across the width

[[light]]
type = "point"
position = [4, 6, 3]
intensity = 0.7                    # Whitted: its share of the light

[material.mirror]
type = "whitted"
color = "#c0c0d0"
reflectivity = 0.6

[[sphere]]
center = [0, 1, 0]
radius = 1
material = "mirror"

[[box]]
min = [-5, -0.1, -5]
max = [5, 0, 5]
material = { type = "whitted", color = "#808080", reflectivity = 0.2 }
)");
    ASSERT_TRUE(reading.scene) << reading.all();
    const scene::Scene& scene = *reading.scene;
    ASSERT_EQ(scene.cameras.size(), 1u);
    expect_near(scene.cameras[0].position, glm::dvec3(0, 1.6, 5));
    expect_near(scene.cameras[0].direction, glm::normalize(glm::dvec3(0, -0.6, -5)));
    EXPECT_EQ(scene.cameras[0].fov, 60.0);
    ASSERT_EQ(scene.objects.size(), 2u);
    expect_near(shape<scene::Sphere>(scene, 0).center, glm::dvec3(0, 1, 0));
    EXPECT_EQ(scene.objects[0].material, 0);
    EXPECT_EQ(scene.materials[0].name, "mirror");
    EXPECT_EQ(whitted(scene, 0).reflectivity, 0.6);
    EXPECT_EQ(whitted(scene, 1).reflectivity, 0.2);
    EXPECT_EQ(scene.objects[1].position.line, 22);
    EXPECT_EQ(scene.file, "scene.toml");
    EXPECT_EQ(scene.hash.size(), 32u);
}

TEST(Toml, LeavesWhatIsNotWrittenAtTheDefaultsOfTheStructs) {
    const Reading reading = read_text(
        "[[sphere]]\n[[box]]\n[[plane]]\n[[disk]]\n[[cylinder]]\n[[cone]]\n[material.m]\n[[light]]\ntype='spot'\nposition=[0,0,0]\n"
        "direction=[0,-1,0]\n[camera.c]\n[render]\n");
    ASSERT_TRUE(reading.scene) << reading.all();
    const scene::Scene& s = *reading.scene;
    EXPECT_EQ(shape<scene::Sphere>(s, 0).radius, scene::Sphere{}.radius);
    EXPECT_EQ(shape<scene::Box>(s, 1).min, scene::Box{}.min);
    EXPECT_EQ(shape<scene::Box>(s, 1).max, scene::Box{}.max);
    EXPECT_EQ(shape<scene::Plane>(s, 2).normal, scene::Plane{}.normal);
    EXPECT_EQ(shape<scene::Disk>(s, 3).radius, scene::Disk{}.radius);
    EXPECT_EQ(shape<scene::Disk>(s, 3).normal, scene::Disk{}.normal);
    EXPECT_EQ(shape<scene::Cylinder>(s, 4).radius, scene::Cylinder{}.radius);
    EXPECT_EQ(shape<scene::Cylinder>(s, 4).to, scene::Cylinder{}.to);
    EXPECT_EQ(shape<scene::Cylinder>(s, 4).capped, scene::Cylinder{}.capped);
    EXPECT_EQ(shape<scene::Cone>(s, 5).radius, scene::Cone{}.radius);
    EXPECT_EQ(shape<scene::Cone>(s, 5).top_radius, scene::Cone{}.top_radius);
    const scene::WhittedMaterial preset;
    for (std::size_t i : {0u, 1u}) {  // [material.m], and the one of shapes without a material
        const scene::WhittedMaterial& m = whitted(s, i);
        EXPECT_EQ(std::get<scene::Color>(m.color), std::get<scene::Color>(preset.color));
        EXPECT_EQ(m.ambient, preset.ambient);
        EXPECT_EQ(m.diffuse, preset.diffuse);
        EXPECT_EQ(m.highlight, preset.highlight);
        EXPECT_EQ(m.shininess, preset.shininess);
        EXPECT_EQ(m.reflectivity, preset.reflectivity);
        EXPECT_EQ(m.transparency, preset.transparency);
        EXPECT_EQ(std::get<double>(m.refraction), std::get<double>(preset.refraction));
        EXPECT_EQ(m.absorption, preset.absorption);
    }
    const auto& spot = std::get<scene::SpotLight>(s.lights[0].model);
    EXPECT_EQ(spot.angle, scene::SpotLight{}.angle);
    EXPECT_EQ(spot.falloff, scene::SpotLight{}.falloff);
    const scene::Camera& camera = s.cameras.at(0);
    EXPECT_EQ(camera.name, "c");
    EXPECT_EQ(camera.position, scene::Camera{}.position);
    EXPECT_EQ(camera.direction, scene::Camera{}.direction);
    EXPECT_EQ(camera.fov, scene::Camera{}.fov);
    EXPECT_EQ(camera.fov_axis, scene::Camera{}.fov_axis);
    const scene::RenderSettings defaults;
    EXPECT_EQ(s.settings.width, defaults.width);
    EXPECT_EQ(s.settings.height, defaults.height);
    EXPECT_EQ(s.settings.integrator, defaults.integrator);
    EXPECT_EQ(s.settings.bounces, defaults.bounces);
    EXPECT_EQ(s.settings.ssaa, defaults.ssaa);
    EXPECT_EQ(s.settings.antialiasing, defaults.antialiasing);
    EXPECT_EQ(s.settings.adaptive_threshold, defaults.adaptive_threshold);
    EXPECT_EQ(s.settings.adaptive_depth, defaults.adaptive_depth);
    EXPECT_EQ(s.settings.wavelengths, defaults.wavelengths);
    EXPECT_EQ(s.settings.min_weight, defaults.min_weight);
    EXPECT_EQ(s.settings.exposure, defaults.exposure);
    EXPECT_EQ(s.ambient, scene::Scene{}.ambient);
    EXPECT_EQ(s.background.zenith, scene::Background{}.zenith);
    EXPECT_FALSE(s.background.image);
    EXPECT_EQ(s.background.rotation, scene::Background{}.rotation);
    EXPECT_EQ(s.background.strength, scene::Background{}.strength);
    EXPECT_EQ(s.background.visible, scene::Background{}.visible);
    EXPECT_EQ(s.settings.diffuse_bounces, defaults.diffuse_bounces);
    EXPECT_EQ(s.settings.glossy_bounces, defaults.glossy_bounces);
    EXPECT_EQ(s.settings.transmission_bounces, defaults.transmission_bounces);
    EXPECT_EQ(s.settings.direct_samples, defaults.direct_samples);
}

TEST(Toml, ReadsShapes) {
    const scene::Scene s = read_part(R"(
[[cone]]
name = "tip"
from = [1, 0, 0]
to = [1, 2, 0]
radius = 0.25
top_radius = 0.125
capped = false
[[sphere]]
center = [1, 2, 3]
radius = 4
[[plane]]
point = [0, -1, 0]
normal = [0, 2, 0]
[[disk]]
center = [0, 1, 0]
normal = [3, 0, 4]
radius = 0.5
[[cylinder]]
from = [0, 0, 0]
to = [0, 3, 0]
radius = 0.75
)");
    // In the order of the file, whatever their kinds.
    EXPECT_EQ(s.objects.at(0).name, "tip");
    const auto& cone = shape<scene::Cone>(s, 0);
    EXPECT_EQ(cone.radius, 0.25);
    EXPECT_EQ(cone.top_radius, 0.125);
    EXPECT_FALSE(cone.capped);
    EXPECT_EQ(shape<scene::Sphere>(s, 1).radius, 4.0);
    expect_near(shape<scene::Plane>(s, 2).normal, glm::dvec3(0, 1, 0));
    expect_near(shape<scene::Disk>(s, 3).normal, glm::dvec3(0.6, 0, 0.8));
    EXPECT_EQ(shape<scene::Cylinder>(s, 4).radius, 0.75);
}

TEST(Toml, ReadsMeshes) {
    const TemporaryFolder folder;
    folder.write("one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const std::string text = R"(
[[mesh]]
positions = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
triangles = [[0, 1, 2], [0, 2, 3]]
normals = [[0, 0, 1], [0, 0, 1], [0, 0, 2], [0, 0, 1]]
uvs = [[0, 0], [1, 0], [1, 1], [0, 1]]
smooth = false
[[mesh]]
file = "one.obj"
[[mesh]]
file = "one.obj"
translate = [1, 0, 0]
[[light]]
type = "point"
position = [0, 0, 9]
)";
    const Reading reading = read_text(text, folder / "scene.toml");
    ASSERT_TRUE(reading.scene) << reading.all();
    const auto& written = shape<scene::Mesh>(*reading.scene, 0);
    EXPECT_FALSE(written.smooth);
    EXPECT_EQ(written.data->triangles.at(1), glm::uvec3(0, 2, 3));
    EXPECT_EQ(written.data->normals.at(2), glm::vec3(0, 0, 1));
    EXPECT_EQ(written.data->uvs.at(3), glm::vec2(0, 1));
    const auto& first = shape<scene::Mesh>(*reading.scene, 1);
    EXPECT_TRUE(first.smooth);
    EXPECT_EQ(first.data->positions.size(), 3u);
    EXPECT_EQ(first.data, shape<scene::Mesh>(*reading.scene, 2).data) << "a file is read once";
}

TEST(Toml, TransformsScaleThenRotateThenTranslate) {
    const scene::Scene s = read_part(R"(
[[sphere]]
scale = 2
[[sphere]]
rotate = [90, 0, 0]
[[sphere]]
rotate = [90, 90, 0]
[[sphere]]
rotate = [0, 0, 90]
scale = [1, 2, 3]
translate = [10, 20, 30]
[[sphere]]
rotate = { axis = [0, 2, 0], angle = 90 }
[[sphere]]
rotate = { axis = [1, 1, 1], angle = 120 }
[[sphere]]
scale = [-1, 1, 1]
)");
    const auto at = [&](std::size_t object, const glm::dvec3& p) { return map(s.objects.at(object).to_parent, p); };
    expect_near(at(0, {1, 2, 3}), glm::dvec3(2, 4, 6));
    EXPECT_EQ(at(1, {0, 1, 0}), glm::dvec3(0, 0, 1)) << "quarter turns are exact";
    expect_near(at(2, {0, 1, 0}), glm::dvec3(1, 0, 0));  // about x to +z, then about y to +x
    expect_near(at(3, {1, 0, 0}), glm::dvec3(10, 21, 30));
    expect_near(at(3, {0, 1, 0}), glm::dvec3(8, 20, 30));
    expect_near(at(4, {0, 0, 1}), glm::dvec3(1, 0, 0));
    expect_near(at(5, {1, 0, 0}), glm::dvec3(0, 1, 0));
    expect_near(at(6, {1, 1, 1}), glm::dvec3(-1, 1, 1));
}

TEST(Toml, ReadsColorsAsLinearLight) {
    const scene::Scene s = read_part(R"(
[material.hex]
color = "#8040ff"
[material.short]
color = "#f80"
[material.name]
color = "orange"
[material.linear]
color = [0.1, 0.2, 0.3]
[[sphere]]
material = "hex"
[[sphere]]
material = "short"
[[sphere]]
material = "name"
[[sphere]]
material = "linear"
)");
    // The sRGB curve: 0x80 = 128/255 -> 0.21586, 0x40 -> 0.05127, 0x88 -> 0.24620, 0xa5 -> 0.37626.
    expect_near(std::get<scene::Color>(whitted(s, 0).color).rgb, Rgb(0.2158605, 0.0512695, 1.0), 1e-6);
    expect_near(std::get<scene::Color>(whitted(s, 1).color).rgb, Rgb(1.0, 0.2462013, 0.0), 1e-6);
    expect_near(std::get<scene::Color>(whitted(s, 2).color).rgb, Rgb(1.0, 0.3762621, 0.0), 1e-6);
    EXPECT_EQ(std::get<scene::Color>(whitted(s, 3).color).rgb, Rgb(0.1, 0.2, 0.3));
}

TEST(Toml, ReadsTextures) {
    const TemporaryFolder folder;
    folder.write("wood.png", "not looked into here");
    const Reading reading = read_text(R"(
[material.floor]
color = { type = "checker", first = "white", second = [0.1, 0.1, 0.1], size = 0.5, solid = false }
[material.wood]
color = { type = "image", file = "wood.png", wrap = "mirror", filter = "nearest", encoding = "linear", scale = [2, 3], offset = [0.5, 0] }
[[sphere]]
material = "floor"
[[sphere]]
material = "wood"
[[light]]
type = "point"
position = [0, 0, 9]
)",
                                      folder / "scene.toml");
    ASSERT_TRUE(reading.scene) << reading.all();
    const auto& checker = std::get<scene::Checker>(whitted(*reading.scene, 0).color);
    EXPECT_EQ(checker.first, Rgb(1.0));
    EXPECT_EQ(checker.second, Rgb(0.1));
    EXPECT_EQ(checker.size, 0.5);
    EXPECT_FALSE(checker.solid);
    const auto& image = std::get<scene::ImageTexture>(whitted(*reading.scene, 1).color);
    EXPECT_EQ(image.file, folder / "wood.png");
    EXPECT_EQ(image.wrap, scene::Wrap::mirror);
    EXPECT_EQ(image.filter, scene::Filter::nearest);
    EXPECT_TRUE(image.linear);
    EXPECT_EQ(image.scale, glm::dvec2(2, 3));
    EXPECT_EQ(image.offset, glm::dvec2(0.5, 0));
    EXPECT_EQ(image.position.line, 5);
}

TEST(Toml, ReadsNumbersFromTextures) {
    const TemporaryFolder folder;
    folder.write("a.png", "not looked into here");
    const Reading reading = read_text(R"(
[material.m]
type = "principled"
roughness = { texture = { type = "image", file = "a.png", wrap_v = "clamp", rotation = 90, uv_set = 1 }, channel = "green", scale = 0.5, offset = 0.1 }
metalness = 0.7
sheen = { type = "vertex_color" }
coat = { texture = { type = "face_color" } }
normal_map = { type = "image", file = "a.png", encoding = "srgb" }
normal_scale = 0.5
normal_flip_green = true
opacity = { texture = { type = "image", file = "a.png" }, channel = "alpha" }
opacity_cutoff = 0.5
[material.later]
type = "mix"
first = "last"
second = { type = "diffuse" }
share = 0.3
behind = "m"
[material.last]
type = "diffuse"
one_sided = true
bump = { texture = { type = "checker" }, scale = 0.01 }
[[sphere]]
material = "later"
[[light]]
type = "point"
position = [0, 0, 9]
)",
                                      folder / "scene.toml");
    ASSERT_TRUE(reading.scene) << reading.all();
    const scene::Material& m = reading.scene->materials[0];
    const auto& model = std::get<scene::PrincipledMaterial>(m.model);
    const auto& image = std::get<scene::ImageTexture>(model.roughness.texture.value());
    EXPECT_TRUE(image.linear) << "numbers are not encoded";
    EXPECT_EQ(image.wrap, scene::Wrap::repeat);
    EXPECT_EQ(image.wrap_v, scene::Wrap::clamp);
    EXPECT_EQ(image.rotation, 90.0);
    EXPECT_EQ(image.uv_set, 1);
    EXPECT_EQ(image.filter, scene::Filter::mipmaps);
    EXPECT_EQ(model.roughness.channel, scene::Channel::green);
    EXPECT_EQ(model.roughness.scale, 0.5);
    EXPECT_EQ(model.roughness.offset, 0.1);
    EXPECT_EQ(model.metalness.number, 0.7);
    EXPECT_FALSE(std::get<scene::MeshColors>(model.sheen).of_faces);
    EXPECT_TRUE(std::get<scene::MeshColors>(model.coat.texture.value()).of_faces);
    EXPECT_FALSE(std::get<scene::ImageTexture>(m.relief.normals.value()).linear);
    EXPECT_EQ(m.relief.scale, 0.5);
    EXPECT_TRUE(m.relief.flips_green);
    EXPECT_EQ(m.opacity.channel, scene::Channel::alpha);
    EXPECT_EQ(m.opacity_cutoff, 0.5);
    const scene::Material& mix = reading.scene->materials[1];
    EXPECT_EQ(std::get<scene::MixMaterial>(mix.model).first, 2);
    EXPECT_EQ(std::get<scene::MixMaterial>(mix.model).second, 3);
    EXPECT_EQ(std::get<scene::MixMaterial>(mix.model).share.number, 0.3);
    EXPECT_EQ(mix.behind, 0);
    EXPECT_TRUE(reading.scene->materials[2].one_sided);
    EXPECT_EQ(reading.scene->materials[2].relief.heights.value().scale, 0.01);
}

TEST(Toml, ReadsColorsOfMeshes) {
    const scene::Scene s = read_part(R"(
[[mesh]]
positions = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
triangles = [[0, 0, 1], [0, 1, 2]]
colors = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
face_colors = [[1, 1, 0], [0.5, 0.25, 0]]
)");
    const scene::TriangleMesh& mesh = *std::get<scene::Mesh>(s.objects[0].shape).data;
    EXPECT_EQ(mesh.colors, (std::vector<glm::vec4>{{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}}));
    EXPECT_EQ(mesh.face_colors, (std::vector<glm::vec4>{{0.5f, 0.25f, 0, 1}})) << "that of the needle went with it";
    const Reading wrong =
        read_text("[[mesh]]\npositions = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]\ntriangles = [[0, 1, 2]]\ncolors = [[1, 0, 0]]\n");
    EXPECT_NE(wrong.all().find(":4:10: error: \"colors\" must have one entry for each of the 3 positions, not 1"), std::string::npos)
        << wrong.all();
}

TEST(Toml, ReadsRefraction) {
    const scene::Scene s = read_part(R"(
[[sphere]]
material = { transparency = 1, refraction = 1.33, absorption = [0.5, 1, 2] }
[[sphere]]
material = { transparency = 1, refraction = "N-BK7" }
[[sphere]]
material = { transparency = 1, refraction = { index = 1.6, abbe_number = 40 } }
[[sphere]]
material = { transparency = 1, refraction = { b = [1.04, 0.23, 1.01], c = [0.006, 0.02, 103.56] } }
)");
    EXPECT_EQ(std::get<double>(whitted(s, 0).refraction), 1.33);
    EXPECT_EQ(whitted(s, 0).absorption, Rgb(0.5, 1, 2));
    EXPECT_EQ(std::get<scene::NamedGlass>(whitted(s, 1).refraction).name, "N-BK7");
    EXPECT_EQ(std::get<scene::AbbeGlass>(whitted(s, 2).refraction).abbe_number, 40.0);
    EXPECT_EQ(std::get<scene::SellmeierGlass>(whitted(s, 3).refraction).c, glm::dvec3(0.006, 0.02, 103.56));
}

TEST(Toml, ReadsLights) {
    const Reading reading = read_text(R"(
[[sphere]]
[[light]]
name = "lamp"
type = "point"
position = [1, 2, 3]
color = "red"
intensity = 0.5
[[light]]
type = "spot"
position = [0, 5, 0]
look_at = [0, 0, 0]
angle = 20
falloff = 4
intensity = 0.3
[[light]]
type = "directional"
direction = [0, -3, 4]
intensity = 0.2
)");
    ASSERT_TRUE(reading.scene) << reading.all();
    const auto& lights = reading.scene->lights;
    EXPECT_EQ(lights.at(0).name, "lamp");
    EXPECT_EQ(std::get<scene::PointLight>(lights[0].model).position, glm::dvec3(1, 2, 3));
    EXPECT_EQ(lights[0].color, Rgb(1, 0, 0));
    EXPECT_EQ(lights[0].intensity, 0.5);
    const auto& spot = std::get<scene::SpotLight>(lights.at(1).model);
    expect_near(spot.direction, glm::dvec3(0, -1, 0));
    EXPECT_EQ(spot.angle, 20.0);
    EXPECT_EQ(spot.falloff, 4.0);
    expect_near(std::get<scene::DirectionalLight>(lights.at(2).model).direction, glm::dvec3(0, -0.6, 0.8));
    EXPECT_EQ(reading.messages, std::vector<std::string>{"scene.toml: note: there is no [camera]: one that sees everything is used"});
}

TEST(Toml, ScalesSharesThatDoNotSumToOne) {
    const Reading reading = read_text(
        "[camera]\n[[sphere]]\n[[light]]\ntype='point'\nposition=[1,2,3]\nintensity=0.6\n[[light]]\ntype='point'\nposition=[1,2,3]"
        "\nintensity=1.8\n");
    ASSERT_TRUE(reading.scene) << reading.all();
    EXPECT_DOUBLE_EQ(reading.scene->lights.at(0).intensity, 0.25);
    EXPECT_DOUBLE_EQ(reading.scene->lights.at(1).intensity, 0.75);
    EXPECT_EQ(reading.messages,
              std::vector<std::string>{
                  "scene.toml:3:1: note: the intensities of the lights are shares that should sum to 1, not 2.4; they are scaled"});
}

TEST(Toml, LightsWithoutIntensityShareWhatIsLeft) {
    const std::string light = "[[light]]\ntype='point'\nposition=[1,2,3]\n";
    const Reading reading = read_text("[camera]\n[[sphere]]\n" + light + light + light + "intensity=0.5\n");
    ASSERT_TRUE(reading.scene) << reading.all();
    EXPECT_EQ(reading.scene->lights.at(0).intensity, 0.25);
    EXPECT_EQ(reading.scene->lights.at(1).intensity, 0.25);
    EXPECT_EQ(reading.scene->lights.at(2).intensity, 0.5);
    EXPECT_TRUE(reading.messages.empty()) << reading.all();
}

TEST(Toml, ReadsSeveralCameras) {
    const scene::Scene s = read_part(R"(
[[sphere]]
[camera]
position = [0, 0, 9]
direction = [0, 0, -2]
up = [1, 1, 0]
fov = 30
fov_axis = "height"
[camera.zoom]
fov = 10
[camera.above]
position = [0, 9, 0]
look_at = [0, 0, 0]
)");
    ASSERT_EQ(s.cameras.size(), 3u);
    EXPECT_EQ(s.cameras[0].name, "");
    EXPECT_EQ(s.cameras[0].direction, glm::dvec3(0, 0, -1));
    expect_near(s.cameras[0].up, glm::normalize(glm::dvec3(1, 1, 0)));
    EXPECT_EQ(s.cameras[0].fov_axis, scene::FovAxis::height);
    EXPECT_EQ(s.cameras[1].name, "zoom") << "in the order of the file";
    EXPECT_EQ(s.cameras[2].name, "above");
    EXPECT_EQ(s.cameras[2].up, glm::dvec3(0, 0, -1)) << "straight down: up would be along the view";
}

TEST(Toml, FramesASceneWithoutCamera) {
    const scene::Scene s = read_part("[[sphere]]\ncenter = [100, 0, 0]\nradius = 10\n");
    ASSERT_EQ(s.cameras.size(), 1u);
    const scene::Camera& camera = s.cameras[0];
    const glm::dvec3 to_center = glm::dvec3(100, 0, 0) - camera.position;
    expect_near(glm::normalize(to_center), camera.direction);
    // The cone of the field of view holds the sphere.
    EXPECT_LT(std::asin(10.0 / glm::length(to_center)), glm::radians(camera.fov / 2));
}

TEST(Toml, ReadsBackgroundAmbientAndRender) {
    const scene::Scene s = read_part(R"(
ambient = [0.5, 0.25, 0.125]
[background]
zenith = [0, 0, 1]
horizon = "white"
[render]
size = [640, 480]
integrator = "whitted"
bounces = 7
ssaa = 4
aa = "adaptive"
adaptive_threshold = 0.1
adaptive_depth = 2
wavelengths = 12
exposure = -1.5
[[sphere]]
)");
    EXPECT_EQ(s.ambient, Rgb(0.5, 0.25, 0.125));
    EXPECT_EQ(s.background.zenith, Rgb(0, 0, 1));
    EXPECT_EQ(s.background.horizon, Rgb(1.0));
    EXPECT_EQ(s.background.nadir, Rgb(1.0));
    EXPECT_EQ(s.settings.width, 640);
    EXPECT_EQ(s.settings.height, 480);
    EXPECT_EQ(s.settings.bounces, 7);
    EXPECT_EQ(s.settings.ssaa, 4);
    EXPECT_EQ(s.settings.antialiasing, scene::Antialiasing::adaptive);
    EXPECT_EQ(s.settings.adaptive_threshold, 0.1);
    EXPECT_EQ(s.settings.adaptive_depth, 2);
    EXPECT_EQ(s.settings.wavelengths, 12);
    EXPECT_EQ(s.settings.exposure, -1.5);

    const scene::Scene t = read_part("background = 'red'\n[ambient]\ncolor = [2, 2, 2]\n[[sphere]]\n");
    EXPECT_EQ(t.background.nadir, Rgb(1, 0, 0));
    EXPECT_EQ(t.ambient, Rgb(2.0));
}

TEST(Toml, ReadsASkyAndLimits) {
    const std::string sky = LANCER_SOURCE_FOLDER "/scenes/textures/sky.hdr";
    const scene::Scene s = read_part("[background]\nimage = '" + sky + R"('
rotation = -30
strength = 2
visible = false
[render]
integrator = "direct"
direct_samples = "emitter"
diffuse_bounces = 1
glossy_bounces = 2
transmission_bounces = 3
[[sphere]]
material = { type = "diffuse" }
)");
    ASSERT_TRUE(s.background.image);
    EXPECT_EQ(s.background.image->file, sky);
    EXPECT_EQ(s.background.rotation, -30.0);
    EXPECT_EQ(s.background.strength, 2.0);
    EXPECT_FALSE(s.background.visible);
    EXPECT_EQ(s.settings.direct_samples, scene::DirectSamples::emitter);
    EXPECT_EQ(s.settings.diffuse_bounces, 1);
    EXPECT_EQ(s.settings.glossy_bounces, 2);
    EXPECT_EQ(s.settings.transmission_bounces, 3);
    EXPECT_EQ(scene::bounces_of(s), 1);
}

TEST(Toml, ReadsGroups) {
    const scene::Scene s = read_part(R"(
[material.red]
color = "red"
[[group]]
name = "pair"
[[group.place]]
group = "ball"
[[group.place]]
group = "ball"
translate = [3, 0, 0]
[[group.sphere]]
center = [0, 9, 0]
[[group]]
name = "ball"
[[group.sphere]]
[[group.box]]
material = "red"
[[place]]
group = "pair"
scale = 2
material = "red"
[[place]]
group = "ball"
)");
    ASSERT_EQ(s.groups.size(), 2u);
    EXPECT_EQ(s.groups[0].name, "ball") << "what is placed comes first";
    EXPECT_EQ(s.groups[0].objects.size(), 2u);
    EXPECT_EQ(s.groups[1].name, "pair");
    EXPECT_EQ(s.groups[1].objects.size(), 1u);
    ASSERT_EQ(s.groups[1].placements.size(), 2u);
    EXPECT_EQ(s.groups[1].placements[0].group, 0);
    expect_near(map(s.groups[1].placements[1].to_parent, {1, 1, 1}), glm::dvec3(4, 1, 1));
    ASSERT_EQ(s.placements.size(), 2u);
    EXPECT_EQ(s.placements[0].group, 1);
    EXPECT_EQ(s.materials.at(static_cast<std::size_t>(s.placements[0].material.value())).name, "red");
    EXPECT_EQ(s.placements[1].group, 0);
    EXPECT_FALSE(s.placements[1].material);
    EXPECT_TRUE(s.objects.empty());
}

TEST(Toml, HashCoversTheTextAndEveryFile) {
    const TemporaryFolder folder;
    const std::string text = "[camera]\n[[mesh]]\nfile = 'a.obj'\n[[light]]\ntype = 'point'\nposition = [0, 0, 9]\n";
    const auto hash = [&](const std::string& scene, const std::string& mesh) {
        folder.write("a.obj", mesh);
        const Reading reading = read_text(scene, folder / "scene.toml");
        EXPECT_TRUE(reading.scene) << reading.all();
        return reading.scene ? reading.scene->hash : "";
    };
    const std::string mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    EXPECT_EQ(hash(text, mesh), hash(text, mesh));
    EXPECT_NE(hash(text, mesh), hash(text + "# more\n", mesh));
    EXPECT_NE(hash(text, mesh), hash(text, mesh + "# more\n"));
}

TEST(Toml, TakesWindowsLineEndsAndAByteOrderMark) {
    const Reading reading =
        read_text("\xef\xbb\xbf[camera]\r\n[[sphere]]\r\nradius = 2\r\n[[light]]\r\ntype = 'point'\r\nposition = [0, 1, 0]\r\n");
    ASSERT_TRUE(reading.scene) << reading.all();
    EXPECT_EQ(shape<scene::Sphere>(*reading.scene).radius, 2.0);
}

TEST(Toml, EverySceneOfTheProjectIsFine) {
    int count = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(source_folder() / "scenes")) {
        if (entry.path().extension() == ".toml") {
            const Reading reading = read_path(entry.path().string());
            EXPECT_TRUE(reading.scene) << reading.all();
            ++count;
        }
    }
    if (count == 0) {
        GTEST_SKIP() << "there are no scenes under " << source_folder() / "scenes";
    }
}

TEST(Toml, FacetsAndIndicesAsOtherProgramsHaveThem) {
    const Reading reading = read_text(R"(
[[sphere]]
material = { type = "conductor", n = [0.2, 0.9, 1.1], k = 3, color = [1, 0.5, 0.5], facets = "beckmann", facet_light = "lost", anisotropy = -4 }
[[sphere]]
material = { type = "plastic", facet_shadows = "separate" }
[[sphere]]
material = { type = "burley", thin = true, passes = 0.3, specular_tint = 0.5 }
[background]
image = "sky.pfm"
axes = [[0, 0, -1], [0, 1, 0], [1, 0, 0]]
)");
    EXPECT_EQ(reading.all().find("conductor"), std::string::npos) << reading.all();
    EXPECT_NE(reading.all().find("sky.pfm"), std::string::npos) << "only the picture is not there: " << reading.all();
    const Reading skewed = read_text("[background]\nimage = \"sky.pfm\"\naxes = [[0, 0, -1], [0, 1, 0], [0, 1, 0]]\n");
    EXPECT_NE(skewed.all().find("at right angles"), std::string::npos) << skewed.all();
}

}  // namespace
}  // namespace lancer
