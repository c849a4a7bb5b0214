// The path integrator against closed forms, against itself with and without asking emitters, and spectra against RGB.
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "analytic/small_world.h"
#include "lancer/device/cpu/cpu.h"
#include "lancer/image/image.h"
#include "lancer/world/compile.h"

namespace lancer::tests {
namespace {

using std::numbers::pi;

struct Estimate {
    glm::dvec3 mean{0.0};
    glm::dvec3 error{0.0};  // standard error of the mean, as if samples were independent
};

// Samples of all pixels of a small picture, taken together.
Estimate estimate(const std::shared_ptr<const World>& world, int size, int spp, const CpuOptions& options = {}) {
    const auto device = make_cpu_device(world, options);
    const PathRange range{0, 0, size, size, 0, spp};
    std::vector<glm::vec3> radiance(range.paths());
    RayCounts counts;
    device->follow_paths(range, radiance, counts);
    glm::dvec3 sum(0.0), squares(0.0);
    for (const glm::vec3& c : radiance) {
        const glm::dvec3 value(static_cast<double>(c.x), static_cast<double>(c.y), static_cast<double>(c.z));
        sum += value;
        squares += value * value;
    }
    const double n = static_cast<double>(radiance.size());
    Estimate result;
    result.mean = sum / n;
    result.error = glm::sqrt(glm::max(squares / n - result.mean * result.mean, glm::dvec3(0.0)) / n);
    return result;
}

scene::Material diffuse(double albedo, double emission = 0.0, bool both_sides = false) {
    scene::Material material;
    material.model = scene::DiffuseMaterial{scene::Rgb(albedo), 0.0};
    if (emission > 0.0) {
        material.emission = scene::Emission{scene::Rgb(1.0), emission, both_sides};
    }
    return material;
}

class Physical : public SmallWorld {
public:
    explicit Physical(int bounces = 1) {
        scene.settings.integrator = "path";
        scene.settings.bounces = bounces;
        scene.settings.rgb = true;
        scene.settings.filter = scene::PixelFilter::box;
        scene.cameras[0].fov = 0.001;
        scene.settings.width = scene.settings.height = 4;
    }
    int material(const scene::Material& m) {
        scene.materials.push_back(m);
        return static_cast<int>(scene.materials.size()) - 1;
    }
    Estimate estimate(int spp, const CpuOptions& options = {}) const {
        return tests::estimate(compile(), scene.settings.width, spp, options);
    }
};

scene::Mesh rectangle(const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v) {
    auto data = std::make_shared<scene::TriangleMesh>();
    data->positions = {corner, corner + u, corner + u + v, corner + v};
    data->triangles = {{0, 1, 2}, {0, 2, 3}};
    return {data, false};
}

// ---- Closed forms ----------------------------------------------------------------------------------------------------------------

TEST(Path, FurnaceIsAsBrightAsItsSeries) {
    for (const bool rgb : {true, false}) {
        for (const double albedo : {0.5, 0.8}) {
            Physical world(1000);
            world.scene.settings.rgb = rgb;
            world.add(scene::Sphere{{0.0, 0.0, 5.0}, 2.0}, world.material(diffuse(albedo, 1.0, true)));
            const Estimate e = world.estimate(4096);
            for (int c = 0; c < 3; ++c) {
                EXPECT_NEAR(e.mean[c], 1.0 / (1.0 - albedo), 0.001 / (1.0 - albedo) + 4.0 * e.error[c]) << albedo << " channel " << c;
            }
            EXPECT_LT(e.error.y, 0.02);
        }
    }
}

// Samples from where the filter is negative are followed like others.
TEST(Path, AFilterWithNegativeLobesLosesNoLight) {
    for (const int bounces : {1, 1000}) {
        Physical world(bounces);
        world.scene.settings.filter = scene::PixelFilter::mitchell;
        if (bounces == 1) {
            world.add(scene::Plane{{0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}, world.material(diffuse(0.5)));
            world.set_background(1.0, 1.0, 1.0);
            world.look({0.0, 0.5, 5.0}, {0.0, -0.1, -1.0});
        } else {
            world.add(scene::Sphere{{0.0, 0.0, 5.0}, 2.0}, world.material(diffuse(0.8, 1.0, true)));
        }
        const double truth = bounces == 1 ? 0.5 : 5.0;
        const Estimate e = world.estimate(16384);
        EXPECT_NEAR(e.mean.x, truth, 0.001 * truth + 4.0 * e.error.x) << bounces;
        EXPECT_LT(e.error.x, 0.004 * truth);
    }
}

// With or without asking lamps for their light.
Estimate asked_or_met(const Physical& world, bool ask, int spp, const CpuOptions& options = {}) {
    auto compiled = std::const_pointer_cast<World>(world.compile());
    if (!ask) {
        compiled->emitters.clear();
        for (kernel::ObjectRecord& object : compiled->objects) {
            object.emitter = -1;
        }
    }
    return estimate(compiled, world.scene.settings.width, spp, options);
}

// What an emitter makes of a white point at the origin that faces +y, seen from the side: irradiance over pi.
Estimate lit_point(const scene::Shape& lamp, bool both_sides, int spp, bool ask = true, const glm::dmat4& to_world = glm::dmat4(1.0),
                   const CpuOptions& options = {}, const scene::Texture& texture = scene::Rgb(1.0), bool rgb = true) {
    Physical world(1);
    world.scene.settings.rgb = rgb;
    world.add(scene::Disk{{0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 0.01}, world.material(diffuse(1.0)));
    scene::Material shining = diffuse(0.0, 1.0, both_sides);
    shining.emission->radiance = texture;
    world.add(lamp, world.material(shining), to_world);
    world.look({0.0, 0.5, 5.0}, {0.0, -0.1, -1.0});
    return asked_or_met(world, ask, spp, options);
}

TEST(Path, IrradianceUnderASphereADiskAndASquare) {
    const double tolerance = 0.001;
    const Estimate sphere = lit_point(scene::Sphere{{0.0, 4.0, 0.0}, 1.0}, false, 4096);
    EXPECT_NEAR(sphere.mean.x * pi, pi / 16.0, tolerance * pi / 16.0 + 4.0 * pi * sphere.error.x);
    const Estimate disk = lit_point(scene::Disk{{0.0, 2.0, 0.0}, {0.0, -1.0, 0.0}, 1.0}, false, 4096);
    EXPECT_NEAR(disk.mean.x * pi, pi / 5.0, tolerance * pi / 5.0 + 4.0 * pi * disk.error.x);
    const Estimate square = lit_point(rectangle({-0.5f, 1.0f, -0.5f}, {1.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}), true, 4096);
    EXPECT_NEAR(square.mean.x * pi, 0.7522747, tolerance * 0.7522747 + 4.0 * pi * square.error.x);
    EXPECT_LT(square.error.x / square.mean.x, 0.002);
}

TEST(Path, FormFactorsOfAUnitCube) {
    // Light from the face at y = 1, or from that at x = 0, onto the face at y = 0, all over which an orthographic camera looks.
    const scene::Mesh floor = rectangle({0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}, {1.0f, 0.0f, 0.0f});
    struct Face {
        scene::Mesh lamp;
        double factor;
    };
    const Face faces[] = {{rectangle({0.0f, 1.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}), 0.1998249},
                          {rectangle({0.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, 1.0f}), 0.2000438}};
    for (const Face& face : faces) {
        Physical world(1);
        world.add(floor, world.material(diffuse(1.0)));
        world.add(face.lamp, world.material(diffuse(0.0, 1.0, true)));
        world.look({0.5, 0.5, 0.5}, {0.0, -1.0, 0.0}, {0.0, 0.0, -1.0});
        world.scene.cameras[0].projection = scene::Projection::orthographic;
        world.scene.cameras[0].extent = 1.0;
        world.scene.settings.width = world.scene.settings.height = 32;
        const Estimate e = world.estimate(256);
        EXPECT_NEAR(e.mean.x, face.factor, 0.001 * face.factor + 4.0 * e.error.x);
        EXPECT_LT(e.error.x, 0.002);
    }
}

TEST(Path, LightsWithoutSize) {
    // 2 W/sr at 2 m, 60 degrees from the normal: 0.25 W/m^2; the sun at the same slant: half of it.
    const glm::dvec3 up(0.0, 0.5, -std::sqrt(0.75));
    for (const bool sun : {false, true}) {
        Physical world(1);
        world.add(scene::Disk{{0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 0.01}, world.material(diffuse(1.0)));
        if (sun) {
            world.scene.lights.push_back({"", scene::DirectionalLight{-up}, scene::Rgb(1.0), 0.0, {}, scene::Rgb(2.0)});
        } else {
            world.scene.lights.push_back({"", scene::PointLight{2.0 * up}, scene::Rgb(1.0), 0.0, {}, scene::Rgb(2.0)});
        }
        world.look({0.0, 0.5, 5.0}, {0.0, -0.1, -1.0});
        EXPECT_NEAR(world.estimate(16).mean.x, (sun ? 1.0 : 0.25) / pi, 1e-4);
    }
}

TEST(Path, ASlabOfGlassLetsThroughWhatFresnelSays) {
    Physical world(64);
    scene::Material glass;
    glass.model = scene::DielectricMaterial{.refraction = 1.5168};
    world.add(scene::Box{{-1.0, -1.0, 0.0}, {1.0, 1.0, 0.2}}, world.material(glass));
    world.add(scene::Disk{{0.0, 0.0, -2.0}, {0.0, 0.0, 1.0}, 1.0}, world.material(diffuse(0.0, 1.0)));
    world.look({0.0, 0.0, 5.0}, {0.0, 0.0, -1.0});
    const Estimate e = world.estimate(65536);
    EXPECT_NEAR(e.mean.x, 0.9190827, 0.0005 + 4.0 * e.error.x);
    EXPECT_LT(e.error.x, 0.0005);
}

// However often a path is bent by glass that spreads colours, white stays white.
TEST(Path, DispersiveGlassInAFurnaceIsInvisible) {
    Physical world(200);
    world.scene.settings.rgb = false;
    scene::Material glass;
    glass.model = scene::DielectricMaterial{.refraction = scene::NamedGlass{"N-SF11"}};
    world.add(scene::Sphere{{0.0, 0.0, 0.0}, 1.0}, world.material(glass));
    world.add(scene::Sphere{{0.0, 0.0, 0.0}, 0.3}, world.material(diffuse(1.0)));
    world.set_background(1.0, 1.0, 1.0);
    world.scene.cameras[0].fov = 20.0;
    const Estimate e = world.estimate(16384);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(e.mean[c], 1.0, 0.001 + 4.0 * e.error[c]) << "channel " << c;
    }
    EXPECT_LT(e.error.y, 0.01);
}

// A principled body that is all clear follows the same paths as glass, and gives up its other wavelengths where glass does.
TEST(Path, APrincipledBodyPartsTheColoursLikeGlass) {
    const auto seen_through = [](const auto& model) {
        Physical world(32);
        world.scene.settings.rgb = false;
        scene::Material material;
        material.model = model;
        world.add(scene::Sphere{{0.0, 0.0, 0.0}, 1.0}, world.material(material));
        world.set_background(2.0, 0.5, 0.1);
        world.scene.cameras[0].fov = 20.0;
        return world.estimate(4096);
    };
    const Estimate glass = seen_through(scene::DielectricMaterial{.refraction = scene::AbbeGlass{1.7, 20.0}});
    const Estimate body = seen_through(
        scene::PrincipledMaterial{.color = scene::Rgb(1.0), .roughness = 0.0, .refraction = 1.7, .transmission = 1.0, .dispersion = 1.0});
    const Estimate plain =
        seen_through(scene::PrincipledMaterial{.color = scene::Rgb(1.0), .roughness = 0.0, .refraction = 1.7, .transmission = 1.0});
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(body.mean[c], glass.mean[c], 1e-3 * glass.mean[c]) << "channel " << c;
        EXPECT_NEAR(body.error[c], glass.error[c], 0.05 * glass.error[c]) << "channel " << c;
        EXPECT_GT(body.error[c], 1.5 * plain.error[c]) << "channel " << c;
    }
}

TEST(Path, AbsorptionFollowsBeer) {
    Physical world(8);
    scene::Material body;
    body.model = scene::DielectricMaterial{.refraction = 1.0, .absorption = {0.5, 2.0, 8.0}};
    world.add(scene::Box{{-1.0, -1.0, 0.0}, {1.0, 1.0, 0.25}}, world.material(body));
    world.add(scene::Disk{{0.0, 0.0, -2.0}, {0.0, 0.0, 1.0}, 1.0}, world.material(diffuse(0.0, 1.0)));
    world.look({0.0, 0.0, 5.0}, {0.0, 0.0, -1.0});
    const Estimate e = world.estimate(16);
    EXPECT_NEAR(e.mean.x, std::exp(-0.125), 1e-4);
    EXPECT_NEAR(e.mean.y, std::exp(-0.5), 1e-4);
    EXPECT_NEAR(e.mean.z, std::exp(-2.0), 1e-4);
}

// ---- Two ways to the same light ----------------------------------------------------------------------------------------------------

struct Lamp {
    const char* name;
    scene::Shape shape;
    bool both_sides = false;
    glm::dmat4 to_world{1.0};
};

class LampShapes : public testing::TestWithParam<Lamp> {};

// A lamp gives the same light whether it is asked for it or met by chance.
TEST_P(LampShapes, AskedOrMet) {
    const Lamp& lamp = GetParam();
    const Estimate asked = lit_point(lamp.shape, lamp.both_sides, 8192, true, lamp.to_world);
    const Estimate met = lit_point(lamp.shape, lamp.both_sides, 65536, false, lamp.to_world);
    EXPECT_GT(asked.mean.x, 0.001);
    EXPECT_NEAR(asked.mean.x, met.mean.x, 4.5 * std::hypot(asked.error.x, met.error.x));
    EXPECT_LT(asked.error.x / asked.mean.x, 0.02);
    const Estimate tree = lit_point(lamp.shape, lamp.both_sides, 8192, true, lamp.to_world, {.tracer = Tracer::tree});
    EXPECT_EQ(asked.mean.x, tree.mean.x);
}

const glm::dmat4 turned =
    glm::rotate(glm::dmat4(1.0), 0.7, glm::dvec3(1.0, 2.0, 0.5)) * glm::scale(glm::dmat4(1.0), glm::dvec3(0.7, 1.4, 0.9));
const glm::dmat4 above = glm::translate(glm::dmat4(1.0), glm::dvec3(0.4, 2.0, -0.3)) * turned;

INSTANTIATE_TEST_SUITE_P(All, LampShapes,
                         testing::Values(Lamp{"sphere", scene::Sphere{{0.5, 2.0, 0.3}, 0.7}},
                                         Lamp{"around", scene::Sphere{{0.0, 0.0, 0.0}, 8.0}, true},
                                         Lamp{"ellipsoid", scene::Sphere{}, false, above},
                                         Lamp{"box", scene::Box{{-0.5, 1.5, -0.4}, {0.6, 2.0, 0.5}}},
                                         Lamp{"turned_box", scene::Box{}, false, above},
                                         Lamp{"disk", scene::Disk{{0.0, 0.0, 0.0}, {0.3, -1.0, 0.1}, 0.8}, false, above},
                                         Lamp{"cylinder", scene::Cylinder{{-0.5, 1.5, 0.0}, {0.7, 2.0, 0.2}, 0.3}},
                                         Lamp{"tube", scene::Cylinder{{-0.5, 1.5, 0.0}, {0.7, 2.0, 0.2}, 0.3, false}, true},
                                         Lamp{"cone", scene::Cone{{0.0, 0.0, 0.0}, {0.2, 1.0, 0.0}, 0.6, 0.1}, false, above},
                                         Lamp{"triangles", rectangle({-0.5f, 1.2f, -0.3f}, {1.0f, 0.3f, 0.0f}, {0.0f, 0.2f, 1.0f}), true}),
                         [](const auto& case_) { return std::string(case_.param.name); });

// A texture that gives light: each lamp shows it to those who ask where it shows it to those who look. Solid cells, cells of uv, and an image that
// is brighter than 1.
TEST_P(LampShapes, TexturedAskedOrMet) {
    const Lamp& lamp = GetParam();
    const scene::Rgb dark(0.2, 0.0, 0.1);
    for (const bool solid : {true, false}) {
        const scene::Checker squares{scene::Rgb(9.0, 3.0, 0.5), dark, 0.3, solid};
        const Estimate asked = lit_point(lamp.shape, lamp.both_sides, 16384, true, lamp.to_world, {}, squares, !solid);
        const Estimate met = lit_point(lamp.shape, lamp.both_sides, 65536, false, lamp.to_world, {}, squares, !solid);
        for (int c = 0; c < 3; ++c) {
            EXPECT_GT(asked.mean[c], 0.0002);
            EXPECT_NEAR(asked.mean[c], met.mean[c], 4.5 * std::hypot(asked.error[c], met.error[c])) << solid << " channel " << c;
        }
        EXPECT_LT(asked.error.x / asked.mean.x, 0.03);
    }
}

TEST(Path, TexturedLampsOfManyTrianglesAskedOrMet) {
    // More triangles than are kept apart, and a texture that leaves most of them dark.
    auto data = std::make_shared<scene::TriangleMesh>();
    constexpr unsigned side = 12;
    for (unsigned i = 0; i <= side; ++i) {
        for (unsigned j = 0; j <= side; ++j) {
            const float x = static_cast<float>(i) / side, z = static_cast<float>(j) / side;
            data->positions.push_back({x * x - 0.4f, 1.0f + 0.3f * x * z, z - 0.5f});
            data->uvs.push_back({x, z});
        }
    }
    for (unsigned i = 0; i < side; ++i) {
        for (unsigned j = 0; j < side; ++j) {
            const unsigned a = i * (side + 1) + j, b = a + side + 1;
            data->triangles.push_back({a, a + 1, b});
            data->triangles.push_back({b, a + 1, b + 1});
        }
    }
    const scene::Checker squares{scene::Rgb(5.0), scene::Rgb(0.01), 0.25, false};
    const Estimate asked = lit_point(scene::Mesh{data, false}, true, 16384, true, glm::dmat4(1.0), {}, squares);
    const Estimate met = lit_point(scene::Mesh{data, false}, true, 131072, false, glm::dmat4(1.0), {}, squares);
    EXPECT_NEAR(asked.mean.x, met.mean.x, 4.5 * std::hypot(asked.error.x, met.error.x));
    EXPECT_LT(asked.error.x / asked.mean.x, 0.005);
}

TEST(Path, LampsInsideAnAbsorbingBody) {
    // All within a body that does not bend light: the way to the camera and the way to the lamp are both dimmed.
    const glm::dvec3 absorption(0.3, 0.8, 1.5);
    const auto inside = [&](bool point, bool ask, int spp) {
        Physical world(3);
        scene::Material body;
        body.model = scene::DielectricMaterial{.refraction = 1.0, .absorption = absorption};
        world.add(scene::Box{{-2.0, -1.0, -2.0}, {2.0, 3.0, 2.0}}, world.material(body));
        world.add(scene::Disk{{0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 0.5}, world.material(diffuse(1.0)));
        if (point) {
            world.scene.lights.push_back({"", scene::PointLight{{0.0, 1.5, 0.0}}, scene::Rgb(1.0), 0.0, {}, scene::Rgb(2.0)});
        } else {
            world.add(scene::Sphere{{0.0, 1.5, 0.0}, 0.6}, world.material(diffuse(0.0, 1.0)));
        }
        world.look({0.0, 1.0, 5.0}, {0.0, -0.2, -1.0});
        return asked_or_met(world, ask, spp);
    };
    const Estimate point = inside(true, true, 16);
    const double to_camera = 2.0 * std::sqrt(1.0 + 0.2 * 0.2);
    for (int c = 0; c < 3; ++c) {
        const double expected = 2.0 / (1.5 * 1.5) / pi * std::exp(-absorption[c] * (1.5 + to_camera));
        EXPECT_NEAR(point.mean[c], expected, 0.001 * expected);
    }
    const Estimate asked = inside(false, true, 8192), met = inside(false, false, 65536);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(asked.mean[c], met.mean[c], 4.5 * std::hypot(asked.error[c], met.error[c])) << "channel " << c;
        EXPECT_LT(asked.error[c] / asked.mean[c], 0.02);
    }
}

TEST(Path, ManyLampsOfATreeAndFew) {
    // More lamps than are looked at one by one: the same light either way.
    const auto lit = [](int lamps) {
        Physical world(1);
        world.add(scene::Disk{{0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 0.01}, world.material(diffuse(1.0)));
        const int shining = world.material(diffuse(0.0, 1.0));
        for (int i = 0; i < lamps; ++i) {
            const double angle = 2.0 * pi * i / lamps;
            world.add(scene::Sphere{{2.0 * std::cos(angle), 1.0 + 0.01 * i, 2.0 * std::sin(angle)}, 0.05}, shining);
        }
        world.look({0.0, 0.5, 5.0}, {0.0, -0.1, -1.0});
        return world.estimate(16384);
    };
    const auto sum = [](int lamps) {
        double total = 0.0;
        for (int i = 0; i < lamps; ++i) {
            const double height = 1.0 + 0.01 * i, distance_2 = 4.0 + height * height;
            total += 0.05 * 0.05 / distance_2 * height / std::sqrt(distance_2);  // pi r^2 / d^2 cos, over pi
        }
        return total;
    };
    for (const int lamps : {2, 30, 40}) {
        const Estimate e = lit(lamps);
        EXPECT_NEAR(e.mean.x, sum(lamps), 0.001 * sum(lamps) + 4.0 * e.error.x) << lamps;
    }
}

// ---- The sky -----------------------------------------------------------------------------------------------------------------------

// A latitude-longitude image of a radiance, with the background that shows it.
template <class Radiance>
scene::Background image_of(const std::string& name, int height, const Radiance& radiance) {
    Image image;
    image.width = 2 * height;
    image.height = height;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const double theta = pi * (y + 0.5) / height, phi = 2.0 * pi * ((x + 0.5) / image.width - 0.5);
            const glm::dvec3 direction(std::sin(phi) * std::sin(theta), std::cos(theta), -std::cos(phi) * std::sin(theta));
            const glm::dvec3 light = radiance(direction);
            for (int c = 0; c < 3; ++c) {
                image.pixels.push_back(static_cast<float>(light[c]));
            }
        }
    }
    scene::Background background;
    background.image = scene::ImageTexture{};
    background.image->file = testing::TempDir() + name + ".exr";
    write_image(background.image->file, image, {});
    return background;
}

// What a white disk at the origin that faces `up` reflects of it, over which a camera looks along the normal.
Estimate under(const scene::Background& sky, const glm::dvec3& up, int spp, scene::DirectSamples samples = scene::DirectSamples::mis) {
    Physical world(1);
    world.scene.settings.integrator = "direct";
    world.scene.settings.direct_samples = samples;
    world.add(scene::Disk{{0.0, 0.0, 0.0}, up, 0.1}, world.material(diffuse(1.0)));
    world.scene.background = sky;
    world.look(up * 3.0, -up, {0.3, 0.4, 0.5});
    return world.estimate(spp);
}

TEST(Path, AnEvenImageIsAWhiteFurnace) {
    for (const bool rgb : {true, false}) {
        Physical world(100);
        world.scene.settings.rgb = rgb;
        world.add(scene::Sphere{{0.0, 0.0, 0.0}, 1.0}, world.material(diffuse(1.0)));
        world.scene.background = image_of("even", 4, [](const glm::dvec3&) { return glm::dvec3(1.0); });
        world.scene.background.strength = 2.5;
        const Estimate e = world.estimate(4096);
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(e.mean[c], 2.5, 0.0025 + 4.0 * e.error[c]) << rgb << " channel " << c;
        }
    }
}

// Light in a lobe, the cosine of the angle from an axis: from the axis at angle g a surface gets 2/3 (sin g + (pi - g) cos g).
TEST(Path, IrradianceUnderALobeOfTheSky) {
    const glm::dvec3 axis = glm::normalize(glm::dvec3(0.5, 0.6, -0.4));
    const scene::Background sky = image_of("lobe", 128, [&](const glm::dvec3& d) { return glm::dvec3(std::max(0.0, glm::dot(d, axis))); });
    for (const glm::dvec3& up :
         {glm::dvec3(0.0, 1.0, 0.0), glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(-1.0, 0.0, 0.0), glm::dvec3(0.0, 0.0, -1.0)}) {
        const double angle = std::acos(glm::dot(axis, up));
        const double expected = 2.0 / 3.0 * (std::sin(angle) + (pi - angle) * std::cos(angle)) / pi;
        for (const auto samples : {scene::DirectSamples::mis, scene::DirectSamples::emitter, scene::DirectSamples::bsdf}) {
            const Estimate e = under(sky, up, 16384, samples);
            EXPECT_NEAR(e.mean.x, expected, 0.001 * expected + 4.0 * e.error.x) << "towards " << up.x << " " << up.y << " " << up.z;
            EXPECT_LT(e.error.x, 0.006 * expected);  // a lobe that is mostly below the horizon is seldom found
        }
    }
}

TEST(Path, ASkyImageLiesAsDescribed) {
    // The lobe stands at -z, the image's middle; turned by 90 degrees counter-clockwise as seen from above, at -x.
    scene::Background sky =
        image_of("middle", 64, [](const glm::dvec3& d) { return glm::dvec3(std::max(0.0, -d.z), std::max(0.0, d.x), std::max(0.0, d.y)); });
    const auto seen = [&](const glm::dvec3& direction) {
        Physical world(1);
        world.add(scene::Sphere{{0.0, -900.0, 0.0}, 1.0}, world.material(diffuse(1.0)));
        world.scene.background = sky;
        world.look({0.0, 0.0, 0.0}, direction, {0.3, 0.4, 0.5});
        return world.estimate(4).mean;
    };
    EXPECT_NEAR(seen({0.0, 0.0, -1.0}).x, 1.0, 0.002);
    EXPECT_NEAR(seen({1.0, 0.0, 0.0}).y, 1.0, 0.002);
    EXPECT_NEAR(seen({0.0, 1.0, 0.0}).z, 1.0, 0.002);
    EXPECT_NEAR(seen({0.6, 0.0, -0.8}).x, 0.8, 0.002);
    EXPECT_NEAR(seen({0.6, 0.0, -0.8}).y, 0.6, 0.002);
    sky.rotation = 90.0;
    EXPECT_NEAR(seen({-1.0, 0.0, 0.0}).x, 1.0, 0.002);
    EXPECT_NEAR(seen({0.0, 0.0, -1.0}).y, 1.0, 0.002);
    sky.rotation = -30.0;
    EXPECT_NEAR(seen({0.5, 0.0, -std::sqrt(0.75)}).x, 1.0, 0.002);
    sky.visible = false;
    EXPECT_EQ(seen({0.0, 0.0, -1.0}).x, 0.0);
    EXPECT_GT(under(sky, {0.0, 0.0, -1.0}, 64).mean.x, 0.1);
}

// A sun in one texel, over surfaces of several kinds: found either way, or both ways together.
TEST(Path, DirectLightIsTheSameEachWay) {
    scene::Material copper;
    copper.model = scene::ConductorMaterial{.metal = "copper", .roughness = 0.5};
    scene::Material lacquer;
    lacquer.model = scene::PlasticMaterial{.color = scene::Rgb(0.6, 0.1, 0.1), .roughness = 0.4};
    const scene::Background sky = image_of("sun", 8, [](const glm::dvec3& d) {
        return d.y > 0.5 && d.y < 0.8 && d.x > 0.2 && d.z > 0.2 ? glm::dvec3(20.0, 18.0, 12.0) : glm::dvec3(0.2, 0.3, 0.4 + 0.3 * d.y);
    });
    for (const scene::Material& material : {diffuse(0.7), copper, lacquer}) {
        const auto lit = [&](scene::DirectSamples samples, const char* integrator, bool rgb) {
            Physical world(1);
            world.scene.settings.integrator = integrator;
            world.scene.settings.direct_samples = samples;
            world.scene.settings.rgb = rgb;
            world.add(scene::Sphere{{0.0, 0.0, 0.0}, 1.0}, world.material(material));
            world.add(scene::Sphere{{2.0, 1.0, 3.0}, 0.7}, world.material(diffuse(0.0, 4.0)));
            world.scene.background = sky;
            world.scene.cameras[0].fov = 18.0;
            return world.estimate(32768);
        };
        const Estimate both = lit(scene::DirectSamples::mis, "direct", true);
        for (const auto samples : {scene::DirectSamples::emitter, scene::DirectSamples::bsdf}) {
            const Estimate alone = lit(samples, "direct", true);
            for (int c = 0; c < 3; ++c) {
                EXPECT_NEAR(alone.mean[c], both.mean[c], 4.5 * std::hypot(alone.error[c], both.error[c])) << "channel " << c;
            }
            EXPECT_GT(alone.error.y, both.error.y);
        }
        EXPECT_LT(both.error.y, 0.01 * both.mean.y);
        EXPECT_EQ(lit(scene::DirectSamples::mis, "path", true).mean, both.mean);
        // Measured indices of a metal are more than three numbers, and what a lacquer sends back into its body is no multiple of its colour.
        if (std::holds_alternative<scene::DiffuseMaterial>(material.model)) {
            const Estimate spectral = lit(scene::DirectSamples::mis, "direct", false);
            EXPECT_NEAR(spectral.mean.y, both.mean.y, 0.02 * both.mean.y + 4.0 * spectral.error.y);
        }
    }
}

// ---- Limits ------------------------------------------------------------------------------------------------------------------------

// After k bounces a furnace is as bright as the first terms of its series.
TEST(Path, LimitedBouncesAreTheFirstTermsOfTheSeries) {
    scene::Material mirror = diffuse(0.0, 1.0, true);
    mirror.model = scene::ConductorMaterial{.metal = "", .color = scene::Rgb(0.5)};
    const auto furnace = [](const scene::Material& material, const std::function<void(scene::RenderSettings&)>& limit) {
        Physical world(1000);
        world.scene.settings.rgb = true;
        limit(world.scene.settings);
        world.add(scene::Sphere{{0.0, 0.0, 5.0}, 2.0}, world.material(material));
        return world.estimate(4096);
    };
    for (const int bounces : {0, 1, 2, 5}) {
        const double sum = 2.0 * (1.0 - std::pow(0.5, bounces + 1));
        const auto near = [&](const Estimate& e) { return std::abs(e.mean.x - sum) <= 0.001 * sum + 4.0 * e.error.x; };
        EXPECT_TRUE(near(furnace(diffuse(0.5, 1.0, true), [&](auto& settings) { settings.bounces = bounces; }))) << bounces;
        EXPECT_TRUE(near(furnace(diffuse(0.5, 1.0, true), [&](auto& settings) { settings.diffuse_bounces = bounces; }))) << bounces;
        EXPECT_TRUE(near(furnace(mirror, [&](auto& settings) { settings.glossy_bounces = bounces; }))) << bounces;
    }
    const Estimate others =
        furnace(diffuse(0.5, 1.0, true), [&](auto& settings) { settings.glossy_bounces = settings.transmission_bounces = 0; });
    EXPECT_NEAR(others.mean.x, 2.0, 0.002 + 4.0 * others.error.x);
}

TEST(Path, LimitedTransmission) {
    // Two boxes of air with a border: the light behind them is four borders away.
    for (const int most : {0, 3, 4}) {
        Physical world(64);
        world.scene.settings.rgb = true;
        world.scene.settings.transmission_bounces = most;
        world.scene.settings.diffuse_bounces = 0;
        scene::Material air;
        air.model = scene::DielectricMaterial{.refraction = 1.0};
        const int material = world.material(air);
        world.add(scene::Box{{-1.0, -1.0, 0.0}, {1.0, 1.0, 0.2}}, material);
        world.add(scene::Box{{-1.0, -1.0, 1.0}, {1.0, 1.0, 1.2}}, material);
        world.add(scene::Disk{{0.0, 0.0, -2.0}, {0.0, 0.0, 1.0}, 1.0}, world.material(diffuse(0.0, 1.0)));
        world.look({0.0, 0.0, 5.0}, {0.0, 0.0, -1.0});
        const Estimate e = world.estimate(256);
        // Russian roulette at the last border.
        EXPECT_NEAR(e.mean.x, most < 4 ? 0.0 : 1.0, 4.0 * e.error.x) << most;
    }
}

// ---- Spectra -----------------------------------------------------------------------------------------------------------------------

TEST(Path, GreyIsTheSameInSpectraAndRgb) {
    for (const bool rgb : {true, false}) {
        Physical world(2);
        world.scene.settings.rgb = rgb;
        world.add(scene::Plane{{0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}, world.material(diffuse(0.5)));
        world.set_background(1.0, 1.0, 1.0);
        world.look({0.0, 0.5, 5.0}, {0.0, -0.1, -1.0});
        const Estimate e = world.estimate(4096);
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(e.mean[c], 0.5, 0.0005 + 4.0 * e.error[c]) << rgb << " channel " << c;
        }
    }
}

TEST(Path, ColorsComeBackFromTheirSpectra) {
    Physical world(1);
    world.scene.settings.rgb = false;
    scene::Material red;
    red.model = scene::DiffuseMaterial{scene::Rgb(0.63, 0.065, 0.05), 0.0};
    world.add(scene::Plane{{0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}, world.material(red));
    world.set_background(1.0, 1.0, 1.0);
    world.look({0.0, 0.5, 5.0}, {0.0, -0.1, -1.0});
    const Estimate e = world.estimate(16384);
    EXPECT_NEAR(e.mean.x, 0.63, 0.002 + 4.0 * e.error.x);
    EXPECT_NEAR(e.mean.y, 0.065, 0.002 + 4.0 * e.error.y);
    EXPECT_NEAR(e.mean.z, 0.05, 0.002 + 4.0 * e.error.z);
}

// ---- The same bits -----------------------------------------------------------------------------------------------------------------

TEST(Path, SameBitsForAnyLanesAndRanges) {
    Physical world(6);
    world.scene.settings.rgb = false;
    world.scene.cameras[0].fov = 50.0;
    world.scene.cameras[0].aperture = 0.1;
    scene::Material glass;
    glass.model = scene::DielectricMaterial{.refraction = scene::NamedGlass{"SF11"}, .roughness = 0.2};
    scene::Material gold;
    gold.model = scene::ConductorMaterial{.metal = "gold", .roughness = 0.4};
    world.add(scene::Sphere{{-0.8, 0.0, 0.0}, 0.8}, world.material(glass));
    world.add(scene::Sphere{{0.9, 0.0, 0.0}, 0.8}, world.material(gold));
    world.add(scene::Plane{{0.0, -0.8, 0.0}, {0.0, 1.0, 0.0}}, world.material(diffuse(0.7)));
    world.add(scene::Sphere{{0.0, 3.0, 1.0}, 0.5}, world.material(diffuse(0.0, 10.0)));
    world.set_background(0.3, 0.2, 0.1);
    world.scene.settings.width = world.scene.settings.height = 24;
    const auto compiled = world.compile();
    const PathRange whole{0, 0, 24, 24, 0, 6};
    std::vector<glm::vec3> first;
    for (const int lanes : {4, 8, 16}) {
        if (lanes > make_cpu_device(compiled)->lanes()) {
            continue;
        }
        const auto device = make_cpu_device(compiled, {.lanes = lanes});
        RayCounts counts;
        std::vector<glm::vec3> radiance(whole.paths());
        device->follow_paths(whole, radiance, counts);
        if (first.empty()) {
            first = radiance;
        }
        int differ = 0;
        for (std::size_t i = 0; i < radiance.size(); ++i) {
            differ += radiance[i] == first[i] ? 0 : 1;
        }
        EXPECT_EQ(differ, 0) << lanes;
        // One sample of one pixel by itself.
        const PathRange one{7, 11, 8, 12, 3, 1};
        std::vector<glm::vec3> alone(1);
        device->follow_paths(one, alone, counts);
        EXPECT_EQ(alone[0], first[static_cast<std::size_t>((11 * 24 + 7) * 6 + 3)]);
    }
}

}  // namespace
}  // namespace lancer::tests
