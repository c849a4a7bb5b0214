// Mixes, cut-out surfaces, other materials behind, relief and mesh colours, where the answer is known.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "analytic/small_world.h"
#include "lancer/image/image.h"
#include "lancer/world/compile.h"
#include "temporary_folder.h"

namespace lancer::tests {
namespace {

struct Answer {
    glm::dvec3 mean{0.0};
    double error = 0.0;   // standard error of the mean of green
    double least = 1e30;  // of the pixels' means
    double most = 0.0;
};

class Stage : public SmallWorld {
public:
    explicit Stage(int bounces = 1) {
        scene.settings.integrator = "path";
        scene.settings.bounces = bounces;
        scene.settings.rgb = true;
        scene.settings.filter = scene::PixelFilter::box;
        scene.settings.width = scene.settings.height = 8;
        scene.cameras[0].fov = 0.001;
    }

    int material(const scene::Material& m) {
        scene.materials.push_back(m);
        return static_cast<int>(scene.materials.size()) - 1;
    }

    Answer see(int spp, const CpuOptions& options = {}) const {
        const int size = scene.settings.width;
        const auto device = make_cpu_device(compile(), options);
        const PathRange range{0, 0, size, size, 0, spp};
        std::vector<glm::vec3> radiance(range.paths());
        RayCounts counts;
        device->follow_paths(range, radiance, counts);
        Answer answer;
        double squares = 0.0;
        for (std::size_t pixel = 0; pixel < static_cast<std::size_t>(size * size); ++pixel) {
            double of_pixel = 0.0;
            for (std::size_t i = 0; i < static_cast<std::size_t>(spp); ++i) {
                const glm::dvec3 value(radiance[pixel * static_cast<std::size_t>(spp) + i]);
                answer.mean += value;
                squares += value.y * value.y;
                of_pixel += value.y / spp;
            }
            answer.least = std::min(answer.least, of_pixel);
            answer.most = std::max(answer.most, of_pixel);
        }
        const double n = static_cast<double>(radiance.size());
        answer.mean /= n;
        answer.error = std::sqrt(std::max(squares / n - answer.mean.y * answer.mean.y, 0.0) / n);
        return answer;
    }
};

scene::Material diffuse(double albedo) {
    scene::Material material;
    material.model = scene::DiffuseMaterial{scene::Rgb(albedo), 0.0};
    return material;
}

scene::Material mix(int first, int second, const scene::Value& share) {
    scene::Material material;
    material.model = scene::MixMaterial{first, second, share};
    return material;
}

// First 1 where cells are even, second 0.
scene::Value checkered(double size, double scale = 1.0, double offset = 0.0) {
    scene::Value value;
    value.texture = scene::Checker{scene::Rgb(1.0), scene::Rgb(0.0), size, true};
    value.scale = scale;
    value.offset = offset;
    return value;
}

TEST(Mixes, AreAsBrightAsTheirShares) {
    Stage world;
    world.set_background(1.0, 1.0, 1.0);
    const int dark = world.material(diffuse(0.2));
    const int bright = world.material(diffuse(0.8));
    const int inner = world.material(mix(dark, bright, 0.25));  // 0.35
    world.add(scene::Sphere{{0, 0, 0}, 1.0}, world.material(mix(inner, bright, 0.4)));
    const Answer a = world.see(4096);
    EXPECT_NEAR(a.mean.y, 0.6 * 0.35 + 0.4 * 0.8, 4.0 * a.error);
    EXPECT_LT(a.error, 0.003);
}

TEST(Mixes, FollowATexture) {
    Stage world;
    world.set_background(1.0, 1.0, 1.0);
    const int dark = world.material(diffuse(0.2));
    const int bright = world.material(diffuse(0.8));
    world.add(scene::Box{{-1, -1, -1}, {1, 1, 1}}, world.material(mix(dark, bright, checkered(1.0))));
    for (const double side : {-0.5, 0.5}) {  // under the face at z = 1: the cell z 0, y 0, x 0 or -1
        world.look({side, 0.5, 5.0}, {0, 0, -1});
        const Answer a = world.see(256);
        EXPECT_NEAR(a.mean.y, side > 0.0 ? 0.8 : 0.2, 4.0 * a.error + 1e-4);
    }
}

TEST(Mixes, ThatContainThemselvesAreErrors) {
    Stage world;
    world.material(diffuse(0.5));
    world.add(scene::Sphere{}, world.material(mix(0, 1, 0.5)));
    EXPECT_THROW(world.compile(), std::runtime_error);
}

TEST(Cutouts, LetTheRestPass) {
    for (const bool tree : {false, true}) {
        Stage world;
        world.set_background(1.0, 1.0, 1.0);
        scene::Material gauze = diffuse(0.0);
        gauze.opacity = 0.3;
        const int material = world.material(gauze);
        for (const double z : {0.0, 0.5, 1.0}) {
            world.add(scene::Plane{{0, 0, z}, {0, 0, 1}}, material);
        }
        const Answer a = world.see(4096, {.tracer = tree ? Tracer::tree : Tracer::all_objects});
        EXPECT_NEAR(a.mean.y, 0.7 * 0.7 * 0.7, 4.0 * a.error);
        EXPECT_LT(a.error, 0.003);
    }
}

TEST(Cutouts, ShadowsAreAsThinAsTheSurface) {
    // A lamp above a white point, two sheets between; the same light whether lamps are asked or met.
    for (const bool ask : {true, false}) {
        Stage world;
        world.add(scene::Disk{{0, 0, 0}, {0, 1, 0}, 0.01}, world.material(diffuse(1.0)));
        scene::Material lamp = diffuse(0.0);
        lamp.emission = scene::Emission{scene::Rgb(1.0), 1.0, false};
        world.add(scene::Sphere{{0, 4, 0}, 1.0}, world.material(lamp));
        scene::Material gauze = diffuse(0.0);
        gauze.opacity = 0.4;
        const int material = world.material(gauze);
        world.add(scene::Disk{{0, 1, 0}, {0, 1, 0}, 3.0}, material);
        world.add(scene::Disk{{0, 2, 0}, {0, 1, 0}, 3.0}, material);
        world.look({0.0, 0.05, 0.5}, {0.0, -0.1, -1.0});
        auto compiled = std::const_pointer_cast<World>(world.compile());
        if (!ask) {
            compiled->emitters.clear();
            for (kernel::ObjectRecord& object : compiled->objects) {
                object.emitter = -1;
            }
        }
        const PathRange range{0, 0, 8, 8, 0, ask ? 256 : 8192};
        std::vector<glm::vec3> radiance(range.paths());
        RayCounts counts;
        make_cpu_device(compiled)->follow_paths(range, radiance, counts);
        double sum = 0.0, squares = 0.0;
        for (const glm::vec3& c : radiance) {
            sum += static_cast<double>(c.y);
            squares += static_cast<double>(c.y) * static_cast<double>(c.y);
        }
        const double n = static_cast<double>(radiance.size());
        const double mean = sum / n;
        const double error = std::sqrt((squares / n - mean * mean) / n);
        EXPECT_NEAR(mean, 0.36 / 16.0, 4.0 * error + 2e-5) << ask;
        EXPECT_LT(error, 0.0005) << ask;
    }
}

scene::Material pane(double tint = 1.0) {
    scene::Material material;
    scene::DielectricMaterial glass;
    glass.thin = true;
    glass.color = scene::Rgb(tint);
    material.model = glass;
    return material;
}

// Of an index of 1.5, straight on: 0.04 at each of its two borders, with all that goes to and fro.
constexpr double mirrored_by_a_pane = 2.0 * 0.04 / 1.04;

TEST(Panes, LightOfASunComesThrough) {
    // A white floor under two panes, and a sun that no path could meet. The same with a medium somewhere, where other ways are taken.
    for (const bool with_medium : {false, true}) {
        Stage world;
        world.add(scene::Plane{{0, 0, 0}, {0, 1, 0}}, world.material(diffuse(0.5)));
        const int glass = world.material(pane(0.8));
        world.add(scene::Disk{{0, 1, 0}, {0, 1, 0}, 30.0}, glass);
        world.add(scene::Disk{{0, 2, 0}, {0, 1, 0}, 30.0}, glass);
        world.add_light(scene::DirectionalLight{{0, -1, 0}}, 1.0);
        world.scene.lights[0].power = scene::Color(scene::Rgb(3.0));
        if (with_medium) {
            scene::Medium fog;
            fog.coefficients = scene::AbsorbingScattering{scene::Rgb(0.0), scene::Rgb(1.0)};
            world.scene.media.push_back(fog);
            scene::Material border;
            border.model = scene::NullMaterial{};
            border.interior = 0;
            world.add(scene::Sphere{{50, 0, 0}, 1.0}, world.material(border));
        }
        world.look({0.0, 0.5, 0.5}, {0.0, -1.0, -1.0});
        const Answer a = world.see(16);
        const double through = 0.8 * (1.0 - mirrored_by_a_pane);
        EXPECT_NEAR(a.mean.y, 3.0 * 0.5 / std::numbers::pi * through * through, 1e-5) << with_medium;
    }
}

TEST(Panes, MirrorTheRest) {
    // White surroundings above, nothing below, seen straight on from below and from above.
    Stage world(3);
    world.set_background(1.0, 0.5, 0.0);
    world.add(scene::Disk{{0, 0, 0}, {0, 1, 0}, 30.0}, world.material(pane()));
    world.look({0.0, -1.0, 0.0}, {0.0, 1.0, 0.0}, {0, 0, 1});
    const Answer up = world.see(4096);
    EXPECT_NEAR(up.mean.y, 1.0 - mirrored_by_a_pane, 4.0 * up.error + 1e-6);
    world.look({0.0, 1.0, 0.0}, {0.0, -1.0, 0.0}, {0, 0, 1});
    const Answer down = world.see(4096);
    EXPECT_NEAR(down.mean.y, mirrored_by_a_pane, 4.0 * down.error + 1e-6);
    EXPECT_LT(down.error, 0.002);
}

TEST(Panes, CloseInAMedium) {
    // Through a ball of a pane that holds fog which only swallows light, from without and from within; and past its own light to lamps.
    scene::Medium fog;
    fog.coefficients = scene::AbsorbingScattering{scene::Rgb(0.4), scene::Rgb(1e-9)};
    Stage world(2);
    world.set_background(1.0, 1.0, 1.0);
    world.scene.media.push_back(fog);
    scene::Material glass = pane();
    glass.interior = 0;
    world.add(scene::Sphere{{0, 0, 0}, 1.0}, world.material(glass));
    const double once = 1.0 - mirrored_by_a_pane;
    const Answer outside = world.see(16384);
    // What comes straight through, and what is mirrored at the first border and at the second one, and then goes out through the first.
    const double depth = std::exp(-0.8);
    const double seen = mirrored_by_a_pane + once * depth * (once + mirrored_by_a_pane * depth * once);
    EXPECT_NEAR(outside.mean.y, seen, 4.0 * outside.error + mirrored_by_a_pane * mirrored_by_a_pane * depth * depth * depth);
    EXPECT_LT(outside.error, 0.002);
    world.look({0, 0, 0}, {0, 0, -1});
    const Answer inside = world.see(16384);
    const double half = std::exp(-0.4);
    EXPECT_NEAR(inside.mean.y, once * half + mirrored_by_a_pane * half * depth * once, 4.0 * inside.error + 1e-3);
}

TEST(Cutouts, ACutoffIsAllOrNothing) {
    for (const double cutoff : {0.2, 0.6}) {
        Stage world;
        world.set_background(1.0, 1.0, 1.0);
        scene::Material leaf = diffuse(0.0);
        leaf.opacity = checkered(1.0, 0.3, 0.25);  // 0.55 or 0.25
        leaf.opacity_cutoff = cutoff;
        world.add(scene::Box{{-1, -1, -0.5}, {1, 1, 0.5}}, world.material(leaf));
        world.look({0.5, 0.5, 5.0}, {0, 0, -1});
        EXPECT_NEAR(world.see(16).mean.y, cutoff < 0.5 ? 0.0 : 1.0, 1e-5);
    }
}

TEST(Sides, AnotherMaterialBehind) {
    Stage world;
    world.set_background(1.0, 1.0, 1.0);
    scene::Material front = diffuse(0.8);
    front.behind = world.material(diffuse(0.3));
    world.add(scene::Disk{{0, 0, 0}, {0, 0, 1}, 1.0}, world.material(front));
    const Answer a = world.see(256);
    EXPECT_NEAR(a.mean.y, 0.8, 4.0 * a.error + 1e-4);
    world.look({0, 0, -5}, {0, 0, 1});
    const Answer b = world.see(256);
    EXPECT_NEAR(b.mean.y, 0.3, 4.0 * b.error + 1e-4);
    world.scene.materials.back().behind.reset();
    world.scene.materials.back().one_sided = true;
    EXPECT_EQ(world.see(16).mean.y, 0.0);
}

// A white sphere covered with bumps, in even light: nowhere black, nowhere brighter than the light.
TEST(Relief, NeitherMakesLightNorBlackSpots) {
    const tests::TemporaryFolder folder;
    Image waves{64, 64, 3, {}};
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            const double sx = 0.8 * std::sin(2.0 * std::numbers::pi * x / 16.0), sy = 0.8 * std::cos(2.0 * std::numbers::pi * y / 16.0);
            const glm::dvec3 n = glm::normalize(glm::dvec3(sx, sy, 1.0));
            for (int c = 0; c < 3; ++c) {
                waves.pixels.push_back(static_cast<float>(0.5 + 0.5 * n[c]));
            }
        }
    }
    const std::string file = folder / "waves.exr";
    write_image(file, waves, {});
    for (const bool bumps : {false, true}) {
        for (const int kind : {0, 1, 2, 3}) {
            Stage world(8);
            world.set_background(1.0, 1.0, 1.0);
            world.scene.settings.width = world.scene.settings.height = 32;
            world.scene.cameras[0].fov = 22.0;  // only the sphere
            world.scene.cameras[0].position = {0.0, 0.0, 5.0};
            scene::Material material = diffuse(1.0);
            if (kind == 1 || kind == 2) {
                material.model = scene::ConductorMaterial{.metal = "", .roughness = kind == 1 ? 0.0 : 0.4};
            } else if (kind == 3) {
                material.model = scene::PrincipledMaterial{.color = scene::Rgb(1.0), .roughness = 0.2, .coat = 0.5};
            }
            scene::ImageTexture image;
            image.file = file;
            image.linear = true;
            image.scale = {8.0, 4.0};
            if (bumps) {
                scene::Value heights;
                heights.texture = image;
                heights.scale = 0.05;
                material.relief.heights = heights;
            } else {
                material.relief.normals = image;
            }
            world.add(scene::Sphere{{0, 0, 0}, 1.0}, world.material(material));
            const Answer a = world.see(64);
            EXPECT_LT(a.mean.y, 1.0 + 1e-5 + 4.0 * a.error) << kind;  // a smooth mirror is exactly white but for rounding
            EXPECT_GT(a.mean.y, 0.85) << kind;
            EXPECT_GT(a.least, 0.4) << kind << ": a dark spot";
        }
    }
}

// A flat normal map changes nothing but rounding.
TEST(Relief, AFlatMapIsNone) {
    Stage world;
    world.set_background(1.0, 0.5, 0.0);
    scene::Material material = diffuse(0.8);
    material.relief.normals = scene::Checker{scene::Rgb(0.5, 0.5, 1.0), scene::Rgb(0.5, 0.5, 1.0), 0.3, false};
    world.look({0.4, 0.3, 5.0}, {0, 0, -1});
    world.add(scene::Sphere{{0, 0, 0}, 1.0}, world.material(diffuse(0.8)));
    const double plain = world.see(256).mean.y;
    world.scene.materials[0] = material;
    EXPECT_NEAR(world.see(256).mean.y, plain, 1e-4);
}

// A normal map that leans towards +u brightens the side that light from there reaches.
TEST(Relief, LeansTheWayOfTheMap) {
    for (const bool flip : {false, true}) {
        Stage world;
        world.scene.settings.integrator = "path";
        scene::Material material = diffuse(0.8);
        material.relief.normals = scene::Checker{scene::Rgb(0.5, 0.8, 0.9), scene::Rgb(0.5, 0.8, 0.9), 1.0, false};  // towards +v
        material.relief.flips_green = flip;
        world.add(scene::Box{{-1, -1, -1}, {1, 1, 1}}, world.material(material));
        world.add_light(scene::DirectionalLight{{0.0, -1.0, -1.0}}, 1.0);  // from above, where v is larger
        world.scene.lights[0].power = glm::dvec3(1.0);
        const double seen = world.see(16).mean.y;
        const double even = 0.8 / std::numbers::pi * std::sqrt(0.5);
        if (flip) {
            EXPECT_LT(seen, 0.8 * even);
        } else {
            EXPECT_GT(seen, 1.1 * even);
        }
    }
}

TEST(MeshColors, OfVerticesAndFaces) {
    auto data = std::make_shared<scene::TriangleMesh>();
    data->positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    data->triangles = {{0, 1, 2}, {0, 2, 3}};
    data->colors = {{0, 0, 0, 1}, {1, 0, 0, 1}, {1, 1, 0, 1}, {0, 1, 0, 1}};
    data->face_colors = {{0.25f, 0.5f, 0.75f, 1}, {0.75f, 0.5f, 0.25f, 1}};
    for (const bool faces : {false, true}) {
        Stage world(0);
        scene::Material material = diffuse(0.0);
        material.emission = scene::Emission{scene::MeshColors{faces}, 1.0, true};
        world.add(scene::Mesh{data, false}, world.material(material));
        world.look({0.5, -0.25, 5.0}, {0, 0, -1});
        const glm::dvec3 seen = world.see(4).mean;
        const glm::dvec3 expected = faces ? glm::dvec3(0.25, 0.5, 0.75) : glm::dvec3(0.75, 0.375, 0.0);
        EXPECT_LT(glm::length(seen - expected), 1e-3) << faces;
    }
}

// Numbers from textures: the same as the number itself where the texture is even.
TEST(Values, FromEvenTexturesAreNumbers) {
    const auto picture = [](bool textured) {
        Stage world(4);
        world.set_background(1.0, 0.5, 0.1);
        world.scene.settings.width = world.scene.settings.height = 16;
        world.scene.cameras[0].fov = 30.0;
        const auto value = [&](double number) {
            scene::Value v(number);
            if (textured) {
                v.texture = scene::Checker{scene::Rgb(0.5), scene::Rgb(0.5), 1.0, true};
                v.channel = scene::Channel::blue;
                v.scale = number;
                v.offset = 0.5 * number;
            }
            return v;
        };
        scene::PrincipledMaterial model;
        model.metalness = value(0.5);
        model.roughness = value(0.4);
        model.anisotropy = value(0.5);
        model.transmission = value(0.5);
        model.coat = value(0.8);
        model.coat_roughness = value(0.3);
        model.sheen = scene::Rgb(0.2);
        model.sheen_roughness = value(0.4);
        model.film = value(300.0);
        scene::Material material;
        material.model = model;
        world.add(scene::Sphere{{0, 0, 0}, 1.0}, world.material(material));
        return world.see(64).mean;
    };
    EXPECT_LT(glm::length(picture(true) - picture(false)), 1e-3);
}

TEST(Surfaces, AreTheSameBitsInAnyNumberOfLanes) {
    Stage world(6);
    world.set_background(1.0, 0.5, 0.2);
    world.scene.settings.rgb = false;
    world.scene.settings.width = world.scene.settings.height = 16;
    world.scene.cameras[0].fov = 60.0;
    const int checker = world.material(diffuse(0.8));
    world.scene.materials[0].model = scene::DiffuseMaterial{scene::Checker{scene::Rgb(0.9), scene::Rgb(0.1), 0.3, true}, checkered(0.2)};
    scene::Material metal;
    metal.model = scene::ConductorMaterial{.metal = "gold", .roughness = checkered(0.3, 0.4, 0.1), .anisotropy = 0.7};
    metal.relief.heights = checkered(0.2, 0.01);
    const int gold = world.material(metal);
    scene::Material both = mix(checker, gold, checkered(0.4));
    both.opacity = 0.8;
    both.behind = checker;
    world.add(scene::Sphere{{-0.8, 0, 0}, 0.9}, world.material(both));
    world.add(scene::Box{{0.2, -1, -1}, {1.4, 0.5, 0.5}}, gold);
    world.add(scene::Plane{{0, -1, 0}, {0, 1, 0}}, checker);
    world.add(scene::Cone{{0, -1, 1}, {0, 0, 1}, 0.5, 0.1}, gold);
    const auto compiled = world.compile();
    const PathRange whole{0, 0, 16, 16, 0, 8};
    std::vector<glm::vec3> first;
    for (const int lanes : {4, 8, 16}) {
        if (lanes > make_cpu_device(compiled)->lanes()) {
            continue;
        }
        std::vector<glm::vec3> radiance(whole.paths());
        RayCounts counts;
        make_cpu_device(compiled, {.lanes = lanes})->follow_paths(whole, radiance, counts);
        if (first.empty()) {
            first = radiance;
        }
        EXPECT_TRUE(first == radiance) << lanes;
    }
    for (const glm::vec3& c : first) {
        ASSERT_TRUE(std::isfinite(c.x + c.y + c.z));
    }
}

}  // namespace
}  // namespace lancer::tests
