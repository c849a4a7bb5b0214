// One picture, bit for bit, whatever follows the rays: 4, 8 or 16 of them at a time or one by one, all objects or a tree. Of several objects
// at the same distance the one with the lowest number is seen, wherever the tree keeps them.
#include <cmath>
#include <cstring>
#include <numbers>
#include <string>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "analytic/dice.h"
#include "analytic/scalar_device.h"
#include "analytic/small_world.h"
#include "lancer/base/failure.h"

namespace lancer::tests {
namespace {

using Picture = std::vector<glm::vec3>;

int pixels_that_differ(const Picture& a, const Picture& b) {
    int count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        count += std::memcmp(&a[i], &b[i], sizeof(glm::vec3)) != 0 ? 1 : 0;
    }
    return count;
}

bool processor_has(int lanes) {
    try {
        make_cpu_device(SmallWorld().compile(), {.lanes = lanes});
        return true;
    } catch (const MachineFailure&) {
        return false;
    }
}

struct Way {
    std::string name;
    CpuOptions options;
};

std::vector<Way> all_ways() {
    std::vector<Way> ways;
    for (const int lanes : {4, 8, 16}) {
        if (processor_has(lanes)) {
            ways.push_back({"all objects, " + std::to_string(lanes) + " lanes", {.tracer = Tracer::all_objects, .lanes = lanes}});
            ways.push_back({"tree, " + std::to_string(lanes) + " lanes", {.tracer = Tracer::tree, .lanes = lanes}});
        }
    }
    return ways;
}

void expect_one_picture(SmallWorld world, int size) {
    world.scene.settings.width = size;
    world.scene.settings.height = size;
    const Picture reference = follow_one_by_one(*world.compile(), pixel_middles(size, size));
    for (const Way& way : all_ways()) {
        EXPECT_EQ(pixels_that_differ(world.picture(size, way.options), reference), 0) << way.name;
    }
}

std::shared_ptr<scene::TriangleMesh> tetrahedron(bool has_normals) {
    auto mesh = std::make_shared<scene::TriangleMesh>();
    mesh->positions = {{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}};
    mesh->triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    if (has_normals) {
        for (const glm::vec3& p : mesh->positions) {
            mesh->normals.push_back(glm::normalize(p));
        }
    }
    return mesh;
}

// Every kind of shape, material and lamp.
SmallWorld everything() {
    SmallWorld world;
    world.scene.ambient = glm::dvec3(0.2, 0.25, 0.3);
    world.scene.background = {{0.3, 0.5, 1.0}, {0.9, 0.9, 1.0}, {0.2, 0.1, 0.0}};
    world.scene.settings.bounces = 4;
    world.scene.settings.wavelengths = 5;
    world.scene.settings.min_weight = 0.001;
    scene::WhittedMaterial checker;
    checker.color = scene::Checker{{0.9, 0.9, 0.8}, {0.1, 0.2, 0.3}, 0.7, true};
    checker.reflectivity = 0.2;
    scene::WhittedMaterial shiny;
    shiny.color = glm::dvec3(0.8, 0.3, 0.2);
    shiny.reflectivity = 0.5;
    scene::WhittedMaterial tinted = clear(1.4, 0.8);
    tinted.absorption = glm::dvec3(0.2, 0.6, 0.1);
    tinted.highlight = 0.5;
    const int floor = world.add(checker), mirror = world.add(shiny), glass = world.add(tinted);
    const int flint = world.add(clear(scene::NamedGlass{"SF11"})), crown = world.add(clear(scene::AbbeGlass{1.52, 60.0}, 0.9));
    const int plain = world.add(scene::WhittedMaterial{});
    const auto at = [](double x, double y, double z) { return glm::translate(glm::dmat4(1.0), glm::dvec3(x, y, z)); };
    const auto turned = [](const glm::dmat4& m, double angle) { return glm::rotate(m, angle, glm::normalize(glm::dvec3(1.0, 2.0, -1.0))); };
    world.add(scene::Plane{{0, -1, 0}, {0, 1, 0}}, floor);
    world.add(scene::Sphere{{-1.5, 0, 0}, 1.0}, mirror);
    world.add(scene::Sphere{{0.7, 0.0, 1.5}, 0.9}, flint);
    world.add(scene::Sphere{{0.7, 0.0, 1.5}, 0.3}, mirror);
    world.add(scene::Box{{1.5, -1, -1}, {2.8, 0.5, 0.3}}, mirror);
    world.add(scene::Box{{-0.5, -0.9, 2.0}, {0.3, -0.2, 2.5}}, glass);
    world.add(scene::Sphere{}, glass, glm::scale(turned(at(-2.5, 0.2, 2.0), 0.5), glm::dvec3(0.5, 0.9, 0.4)));
    world.add(scene::Box{}, floor, glm::scale(turned(at(-0.2, 1.9, -1.0), 0.9), glm::dvec3(1.2)));
    world.add(scene::Disk{{0, 0, 0}, {0.2, 1.0, 0.9}, 0.8}, plain, at(2.4, 1.6, -1.0));
    world.add(scene::Cylinder{{0, -0.5, 0}, {0.1, 0.5, 0}, 0.4, true}, crown, at(2.2, -0.4, 1.8));
    world.add(scene::Cylinder{{0, 0, 0}, {0.4, 0.9, 0.2}, 0.5, false}, mirror, at(-3.0, 1.2, -1.0));
    world.add(scene::Cone{{0, 0, 0}, {0, 1.2, 0}, 0.6, 0.0, true}, plain, at(-0.6, -1.0, 2.2));
    world.add(scene::Cone{{0, 0, 0}, {0.2, 1.0, 0}, 0.5, 0.25, false}, floor, at(1.6, 1.2, 0.0));
    world.add(scene::Mesh{tetrahedron(true), true}, crown, glm::scale(turned(at(1.2, 1.5, 1.6), 0.3), glm::dvec3(0.5)));
    world.add(scene::Mesh{tetrahedron(false), true}, plain, glm::scale(turned(at(-1.5, 1.8, 0.5), 1.3), glm::dvec3(0.5, -0.6, 0.4)));
    world.add_light(scene::PointLight{{4, 5, 6}}, 0.5);
    world.add_light(scene::SpotLight{{-4, 6, 2}, {0.6, -1.0, -0.2}, 35.0, 15.0}, 0.3, {1.0, 0.9, 0.7});
    world.add_light(scene::DirectionalLight{{0.2, -1.0, -0.5}}, 0.2);
    world.look({0.0, 0.8, 6.0}, {0.0, -0.08, -1.0});
    world.scene.cameras[0].fov = 60.0;
    return world;
}

TEST(SamePicture, OfEverything) { expect_one_picture(everything(), 64); }

// Shapes strewn about, small ones far away among them.
TEST(SamePicture, OfManyShapes) {
    for (const std::uint64_t seed : {81u, 82u, 83u}) {
        Dice dice(seed);
        SmallWorld world;
        world.set_background(0.8, 0.5, 0.1);
        world.scene.settings.bounces = 3;
        scene::WhittedMaterial shiny;
        shiny.reflectivity = 0.6;
        const int materials[] = {world.add(shiny), world.add(clear(1.5, 0.7)), world.add(matte({0.9, 0.4, 0.2}))};
        for (int i = 0; i < 50; ++i) {
            const double distance = dice.log_between(1.0, 1000.0);
            const glm::dvec3 middle =
                glm::dvec3(0.0, 0.0, 5.0) + distance * glm::normalize(glm::dvec3(dice.in_cube(0.7).x, dice.in_cube(0.7).y, -1.0));
            const double size = distance * dice.log_between(0.01, 0.3);
            const int material = materials[dice.below(3)];
            const glm::dmat4 m = glm::scale(glm::translate(glm::dmat4(1.0), middle) * dice.rotation(), glm::dvec3(size));
            switch (dice.below(6)) {
                case 0:
                case 1:
                    world.add(scene::Sphere{}, material, m);
                    break;
                case 2:
                    world.add(scene::Box{middle - size, middle + 0.5 * size}, material);
                    break;
                case 3:
                    world.add(scene::Box{}, material, m);
                    break;
                case 4:
                    world.add(scene::Cone{{0, 0, 0}, {0, 1, 0}, 1.0, dice.between(0.0, 1.0), dice.coin()}, material, m);
                    break;
                default:
                    world.add(scene::Disk{}, material, m);
            }
        }
        world.add_light(scene::PointLight{{30, 50, 60}}, 0.7);
        world.add_light(scene::DirectionalLight{{0.3, -1.0, -0.4}}, 0.3);
        expect_one_picture(world, 64);
    }
}

// From so far that the rounding of a ray is a good part of what it looks at.
TEST(SamePicture, OfSmallThingsFarAway) {
    SmallWorld world;
    world.set_background(0.8, 0.5, 0.1);
    const int white = world.add(matte());
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 middle(0.03 * (i % 4) - 0.045, 0.03 * (i / 4), 0.0);
        if (i % 2 == 0) {
            world.add(scene::Sphere{middle, 0.01}, white);
        } else {
            world.add(scene::Box{middle - 0.01, middle + 0.01}, white);
        }
        world.add(scene::Cone{middle + glm::dvec3(0.0, -0.06, 0.0), middle + glm::dvec3(0.0, -0.05, 0.0), 0.01, 0.0, true}, white);
    }
    world.add_light(scene::DirectionalLight{{0.2, -1.0, -0.6}}, 1.0);
    for (const double distance : {10.0, 1000.0, 2e4}) {
        world.look({0.6 * distance, 0.0, 0.8 * distance}, {-0.6, 0.0, -0.8});
        world.scene.cameras[0].fov = 2.0 * std::atan(0.1 / distance) * 180.0 / std::numbers::pi;
        expect_one_picture(world, 48);
    }
}

// ---- Equal distances -------------------------------------------------------------------------------------------------------------

// The rule: spheres before boxes before planes before placed shapes before triangles; within a kind, in the order of the file.
void expect_first_seen(const SmallWorld& world, const glm::dvec3& color) {
    for (const Way& way : all_ways()) {
        for (const glm::vec3& seen : world.picture(16, way.options)) {
            ASSERT_EQ(glm::dvec3(seen), color) << way.name;
        }
    }
}

struct Pair {
    scene::Shape first;
    scene::Shape second;
    glm::dmat4 map{1.0};
};

scene::Mesh square(float size, int cells) {
    auto mesh = std::make_shared<scene::TriangleMesh>();
    const auto side = static_cast<unsigned>(cells + 1);
    for (unsigned y = 0; y < side; ++y) {
        for (unsigned x = 0; x < side; ++x) {
            mesh->positions.emplace_back(size * (2.0f * static_cast<float>(x) / static_cast<float>(cells) - 1.0f),
                                         size * (2.0f * static_cast<float>(y) / static_cast<float>(cells) - 1.0f), 0.0f);
        }
    }
    for (unsigned y = 0; y + 1 < side; ++y) {
        for (unsigned x = 0; x + 1 < side; ++x) {
            const unsigned i = y * side + x;
            mesh->triangles.insert(mesh->triangles.end(), {{i, i + 1, i + side + 1}, {i, i + side + 1, i + side}});
        }
    }
    return {mesh, true};
}

TEST(EqualDistances, TheFirstInTheFileIsSeen) {
    const glm::dmat4 turned = glm::rotate(glm::dmat4(1.0), 0.3, glm::dvec3(0, 0, 1));
    const Pair pairs[] = {
        {scene::Sphere{{0, 0, -20}, 20.0}, scene::Sphere{{0, 0, -20}, 20.0}},
        {scene::Box{{-9, -9, -1}, {9, 9, 0}}, scene::Box{{-9, -9, -2}, {9, 9, 0}}},
        {scene::Box{{-9, -9, -1}, {9, 9, 0}}, scene::Box{{-9, -9, -1}, {9, 9, 0}}, turned},
        {scene::Plane{{0, 0, 0}, {0, 0, 1}}, scene::Plane{{5, 5, 0}, {0, 0, 1}}},
        {scene::Disk{{0, 0, 0}, {0, 0, 1}, 20.0}, scene::Disk{{0, 0, 0}, {0, 0, 1}, 20.0}},
        {square(9.0f, 1), square(9.0f, 1)},
        {square(9.0f, 7), square(9.0f, 7)},
        {square(9.0f, 7), square(9.0f, 7), glm::scale(turned, glm::dvec3(1.3, 1.1, 1.0))},
    };
    for (const Pair& pair : pairs) {
        SmallWorld world;
        world.scene.ambient = glm::dvec3(1.0);
        const int red = world.add(glowing(1.0, {1, 0, 0})), blue = world.add(glowing(1.0, {0, 0, 1}));
        // Others around them, so that a tree has something to sort.
        for (int i = 0; i < 20; ++i) {
            world.add(scene::Sphere{{3.0 * i - 30.0, 0.0, -100.0}, 1.0}, blue);
        }
        SmallWorld red_first = world, blue_first = world;
        red_first.add(pair.first, red, pair.map);
        red_first.add(pair.second, blue, pair.map);
        blue_first.add(pair.second, blue, pair.map);
        blue_first.add(pair.first, red, pair.map);
        SCOPED_TRACE(static_cast<int>(&pair - pairs));
        expect_first_seen(red_first, {1, 0, 0});
        expect_first_seen(blue_first, {0, 0, 1});
    }
}

// Straight ahead, where all of them compute the very same distance.
TEST(EqualDistances, KindsHaveTheirOrder) {
    const auto expect_ahead = [](const SmallWorld& world, const glm::dvec3& color) {
        for (const Way& way : all_ways()) {
            EXPECT_EQ(world.ahead(way.options), color) << way.name;
        }
    };
    SmallWorld world;
    world.scene.ambient = glm::dvec3(1.0);
    const auto color = [&](const glm::dvec3& c) { return world.add(glowing(1.0, c)); };
    world.add(square(9.0f, 1), color({0.5, 0, 0}));
    world.add(scene::Disk{{0, 0, 0}, {0, 0, 1}, 20.0}, color({0, 0.5, 0}));
    world.add(scene::Plane{{0, 0, 0}, {0, 0, 1}}, color({0, 0, 0.5}));
    world.add(scene::Box{{-9, -9, -1}, {9, 9, 0}}, color({1, 1, 0}));
    world.add(scene::Sphere{{0, 0, -1}, 1.0}, color({0, 1, 1}));
    expect_ahead(world, {0, 1, 1});
    world.scene.objects.pop_back();
    expect_ahead(world, {1, 1, 0});
    world.scene.objects.pop_back();
    expect_ahead(world, {0, 0, 0.5});
    world.scene.objects.pop_back();
    expect_ahead(world, {0, 0.5, 0});
    world.scene.objects.pop_back();
    expect_ahead(world, {0.5, 0, 0});
}

// ---- Meshes ----------------------------------------------------------------------------------------------------------------------

// A bumpy globe in the tree, against the scalar kernel that asks each of its triangles.
void expect_mesh_is_met_as_its_triangles(double from_origin, int allowed) {
    Dice dice(84);
    auto mesh = std::make_shared<scene::TriangleMesh>();
    const unsigned rings = 24, sectors = 48;
    for (unsigned i = 0; i <= rings; ++i) {
        for (unsigned j = 0; j < sectors; ++j) {
            const double polar = std::numbers::pi * i / rings, around = 2.0 * std::numbers::pi * j / sectors;
            const double r = i == 0 || i == rings ? 1.0 : dice.between(0.9, 1.1);
            mesh->positions.emplace_back(
                r * glm::dvec3(std::sin(polar) * std::sin(around), std::cos(polar), std::sin(polar) * std::cos(around)));
        }
    }
    for (unsigned i = 0; i < rings; ++i) {
        for (unsigned j = 0; j < sectors; ++j) {
            const unsigned a = i * sectors + j, b = i * sectors + (j + 1) % sectors;
            mesh->triangles.insert(mesh->triangles.end(), {{a, a + sectors, b + sectors}, {a, b + sectors, b}});
        }
    }
    SmallWorld world;
    world.scene.ambient = glm::dvec3(0.2);
    world.set_background(0.7, 0.5, 0.1);
    world.scene.settings.bounces = 3;
    scene::WhittedMaterial shiny;
    shiny.reflectivity = 0.5;
    const glm::dvec3 shift = from_origin * glm::dvec3(0.6, 0.0, 0.8);
    const glm::dmat4 turned = glm::rotate(glm::translate(glm::dmat4(1.0), shift), 0.4, glm::dvec3(1, 0, 0));
    world.add(scene::Mesh{mesh, true}, world.add(shiny), glm::scale(turned, glm::dvec3(3.0, 2.5, 2.0)));
    world.add(scene::Plane{{0, -2, 0}, {0, 1, 0}}, world.add(matte()));
    world.add_light(scene::PointLight{shift + glm::dvec3(4, 6, 8)}, 0.8);
    world.look(shift + glm::dvec3(0, 0, 5), {0, 0, -1});
    const int size = 64;
    world.scene.settings.width = size;
    world.scene.settings.height = size;

    // The same world with each triangle an object of its own.
    const auto large = world.compile();
    World loose;
    loose.materials = large->materials;
    loose.media = large->media;
    loose.planes = large->planes;
    loose.lights = large->lights;
    loose.meshes = large->meshes;
    loose.instances = large->instances;
    loose.positions = large->positions;
    loose.indices = large->indices;
    loose.camera = large->camera;
    loose.ambient = large->ambient;
    loose.sky = large->sky;
    loose.bounces = large->bounces;
    for (const kernel::ObjectRecord& object : large->objects) {
        if (object.kind != kernel::OBJECT_MESH) {
            loose.objects.push_back(object);
        }
    }
    const kernel::InstanceRecord& instance = large->instances.at(0);
    for (int i = 0; i < large->meshes.at(0).triangle_count; ++i) {
        const auto corner = [&](int k) {
            const auto vertex = static_cast<std::size_t>(large->indices[static_cast<std::size_t>(3 * i + k)]);
            const kernel::AffineRecord& m = instance.to_world;
            const kernel::vec3 p = large->positions[vertex];
            return kernel::vec3(m.row_x.x * p.x + m.row_x.y * p.y + m.row_x.z * p.z + m.shift.x,
                                m.row_y.x * p.x + m.row_y.y * p.y + m.row_y.z * p.z + m.shift.y,
                                m.row_z.x * p.x + m.row_z.y * p.y + m.row_z.z * p.z + m.shift.z);
        };
        loose.objects.push_back({kernel::OBJECT_TRIANGLE, i, large->objects.back().material, 0, 0, i, -1});
        loose.triangles.push_back({corner(0), corner(1), corner(2)});
    }
    const Picture reference = follow_one_by_one(loose, pixel_middles(size, size));
    Picture first;
    for (const Way& way : all_ways()) {
        const Picture picture = world.picture(size, way.options);
        EXPECT_LE(pixels_that_differ(picture, reference), allowed) << way.name;
        first = first.empty() ? picture : first;
        EXPECT_EQ(pixels_that_differ(picture, first), 0) << way.name;
    }
}

TEST(SamePicture, OfALargeMesh) { expect_mesh_is_met_as_its_triangles(0.0, 0); }

// The tree moves the ray into the mesh's own space, where it rounds otherwise: on an edge it may name the other triangle. No surface is met by
// the rays that leave it.
TEST(SamePicture, OfALargeMeshFarAway) { expect_mesh_is_met_as_its_triangles(5000.0, 64 * 64 / 100); }

}  // namespace
}  // namespace lancer::tests
