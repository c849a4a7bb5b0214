// Scenes as the flat tables that the kernel reads.
#include "lancer/world/compile.h"

#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "lancer/kernel/camera.h"
#include "lancer/spectrum/glass.h"

namespace lancer {
namespace {

const glm::dmat4 identity(1.0);

scene::Scene empty_scene() {
    scene::Scene scene;
    scene.file = "test.toml";
    scene.cameras.emplace_back();
    scene.materials.emplace_back();
    return scene;
}

scene::Scene scene_of(const scene::Shape& shape, const glm::dmat4& to_world = identity) {
    scene::Scene scene = empty_scene();
    scene.objects.push_back({"it", shape, 0, to_world, {"test.toml", 12, 3}});
    return scene;
}

std::shared_ptr<const World> compiled(const scene::Scene& scene) {
    Diagnostics diagnostics;
    auto world = compile_world(scene, scene.cameras.at(0), diagnostics);
    EXPECT_TRUE(diagnostics.list().empty()) << to_string(diagnostics.list().front());
    return world;
}

// The first complaint about a scene that does not compile.
std::string complaint(const scene::Scene& scene) {
    Diagnostics diagnostics;
    const auto world = compile_world(scene, scene.cameras.at(0), diagnostics);
    EXPECT_EQ(world, nullptr);
    EXPECT_TRUE(diagnostics.has_errors());
    return diagnostics.list().empty() ? "" : to_string(diagnostics.list().front());
}

void expect_vec(const kernel::vec3& v, const glm::dvec3& expected, double tolerance = 1e-6) {
    EXPECT_LT(glm::length(glm::dvec3(v) - expected), tolerance) << v.x << " " << v.y << " " << v.z;
}

glm::dvec3 apply(const kernel::AffineRecord& m, const glm::dvec3& p) {
    return glm::dvec3(glm::dot(glm::dvec3(m.row_x), p), glm::dot(glm::dvec3(m.row_y), p), glm::dot(glm::dvec3(m.row_z), p)) +
           glm::dvec3(m.shift);
}

// ---- Shapes ----------------------------------------------------------------------------------------------------------------------

TEST(CompileShapes, SpheresStaySpheresWhereAnglesAreKept) {
    glm::dmat4 m = glm::translate(identity, glm::dvec3(1.0, 2.0, 3.0));
    m = glm::rotate(m, 0.8, glm::normalize(glm::dvec3(1.0, 1.0, 0.5)));
    m = glm::scale(m, glm::dvec3(-2.5));  // and mirrored
    const auto world = compiled(scene_of(scene::Sphere{{0.5, 0.0, 0.0}, 2.0}, m));
    ASSERT_EQ(world->spheres.size(), 1u);
    EXPECT_EQ(world->objects.at(0).kind, kernel::OBJECT_SPHERE);
    EXPECT_FLOAT_EQ(world->spheres[0].radius, 5.0f);
    expect_vec(world->spheres[0].center, glm::dvec3(m * glm::dvec4(0.5, 0.0, 0.0, 1.0)));
}

TEST(CompileShapes, OtherSpheresArePlaced) {
    glm::dmat4 shear(1.0);
    shear[1][0] = 0.3;
    for (const glm::dmat4& m : {glm::scale(identity, glm::dvec3(1.0, 2.0, 1.0)), shear}) {
        const auto world = compiled(scene_of(scene::Sphere{{1.0, 0.0, 0.0}, 2.0}, m));
        EXPECT_TRUE(world->spheres.empty());
        ASSERT_EQ(world->placed.size(), 1u);
        EXPECT_EQ(world->objects.at(0).kind, kernel::OBJECT_PLACED_SPHERE);
        // The unit sphere's top is the written sphere's top, wherever that went.
        const glm::dvec3 top(m * glm::dvec4(1.0, 2.0, 0.0, 1.0));
        EXPECT_LT(glm::length(apply(world->placed[0].to_world, {0.0, 1.0, 0.0}) - top), 1e-6);
        EXPECT_LT(glm::length(apply(world->placed[0].to_object, top) - glm::dvec3(0.0, 1.0, 0.0)), 1e-6);
        EXPECT_LT(glm::length(apply(world->placed[0].to_author, {0.0, 1.0, 0.0}) - glm::dvec3(1.0, 2.0, 0.0)), 1e-6);
    }
}

TEST(CompileShapes, BoxesStayAlongTheAxesWhereTheyAre) {
    const scene::Box box{{-1.0, 0.0, 2.0}, {1.0, 3.0, 4.0}};
    const glm::dmat4 mirrored = glm::scale(glm::translate(identity, glm::dvec3(5.0, 0.0, 0.0)), glm::dvec3(-2.0, 1.0, 1.0));
    const auto world = compiled(scene_of(box, mirrored));
    ASSERT_EQ(world->boxes.size(), 1u);
    expect_vec(world->boxes[0].low, {3.0, 0.0, 2.0});
    expect_vec(world->boxes[0].high, {7.0, 3.0, 4.0});
    const auto turned = compiled(scene_of(box, glm::rotate(identity, 0.3, glm::dvec3(0.0, 1.0, 0.0))));
    EXPECT_TRUE(turned->boxes.empty());
    EXPECT_EQ(turned->objects.at(0).kind, kernel::OBJECT_PLACED_BOX);
    EXPECT_LT(glm::length(apply(turned->placed.at(0).to_author, {1.0, 1.0, -1.0}) - glm::dvec3(1.0, 3.0, 2.0)), 1e-6);
}

TEST(CompileShapes, TexturedShapesKeepTheirSpace) {
    scene::WhittedMaterial checkered;
    checkered.color = scene::Checker{};
    scene::Scene scene = scene_of(scene::Sphere{}, glm::translate(identity, glm::dvec3(1.0, 0.0, 0.0)));
    scene.materials[0].model = checkered;
    const auto world = compiled(scene);
    ASSERT_EQ(world->placed.size(), 1u);
    EXPECT_LT(glm::length(apply(world->placed[0].to_author, {0.0, 0.0, 1.0}) - glm::dvec3(0.0, 0.0, 1.0)), 1e-6);
    scene.objects[0].to_parent = identity;
    EXPECT_EQ(compiled(scene)->spheres.size(), 1u) << "world space is its own space";
}

TEST(CompileShapes, PlanesTurnWithTheirNormals) {
    // Normals are not moved like points: under a stretch along y the plane x + y = 0 gets flatter or steeper.
    const glm::dmat4 m = glm::scale(glm::translate(identity, glm::dvec3(0.0, 1.0, 0.0)), glm::dvec3(1.0, 3.0, 1.0));
    const auto world = compiled(scene_of(scene::Plane{{1.0, -1.0, 7.0}, {2.0, 2.0, 0.0}}, m));
    const kernel::PlaneRecord& plane = world->planes.at(0);
    const glm::dvec3 n(plane.normal);
    EXPECT_NEAR(glm::length(n), 1.0, 1e-7);
    for (const glm::dvec3& p : {glm::dvec3(1.0, -1.0, 7.0), glm::dvec3(-4.0, 4.0, 0.0)}) {
        EXPECT_NEAR(glm::dot(n, glm::dvec3(m * glm::dvec4(p, 1.0))), static_cast<double>(plane.offset), 1e-6);
    }
    EXPECT_GT(glm::dot(n, glm::dvec3(m * glm::dvec4(2.0, 2.0, 0.0, 0.0))), 0.0) << "the same side is outside";
}

TEST(CompileShapes, ConesAndCylindersStandOnTheirAxis) {
    const auto world = compiled(scene_of(scene::Cone{{1.0, 1.0, 1.0}, {1.0, 1.0, 4.0}, 0.5, 2.0, false}));
    const kernel::PlacedRecord& cone = world->placed.at(0);
    EXPECT_EQ(world->objects.at(0).kind, kernel::OBJECT_PLACED_CONE);
    EXPECT_LT(glm::length(apply(cone.to_world, {0.0, 0.0, 0.0}) - glm::dvec3(1.0, 1.0, 1.0)), 1e-6);
    EXPECT_LT(glm::length(apply(cone.to_world, {0.0, 1.0, 0.0}) - glm::dvec3(1.0, 1.0, 4.0)), 1e-6);
    EXPECT_FLOAT_EQ(cone.bottom_radius, 0.25f);
    EXPECT_FLOAT_EQ(cone.top_radius, 1.0f);
    EXPECT_EQ(cone.capped, 0);
    EXPECT_NEAR(glm::length(apply(cone.to_world, {0.0, 0.0, 0.25}) - glm::dvec3(1.0, 1.0, 1.0)), 0.5, 1e-6);
}

TEST(CompileShapes, NumberedKindByKindAndThenAsInTheFile) {
    scene::Scene scene = empty_scene();
    const glm::dmat4 stretch = glm::scale(identity, glm::dvec3(1.0, 2.0, 1.0));
    const auto add = [&](const char* name, const scene::Shape& shape, const glm::dmat4& m = identity) {
        scene.materials.emplace_back();
        scene.objects.push_back({name, shape, static_cast<int>(scene.materials.size()) - 1, m, {}});
    };
    add("disk", scene::Disk{});            // material 1
    add("plane", scene::Plane{});          // 2
    add("box", scene::Box{});              // 3
    add("egg", scene::Sphere{}, stretch);  // 4
    add("sphere", scene::Sphere{});        // 5
    add("box 2", scene::Box{});            // 6
    add("tube", scene::Cylinder{});        // 7
    add("disk 2", scene::Disk{});          // 8
    const auto world = compiled(scene);
    std::vector<int> materials;
    for (const kernel::ObjectRecord& object : world->objects) {
        materials.push_back(object.material);
    }
    EXPECT_EQ(materials, (std::vector<int>{5, 3, 6, 2, 4, 1, 8, 7}));
    // The placed ones stand in their table in the order of their objects.
    for (std::size_t i = 0; i < world->placed.size(); ++i) {
        EXPECT_EQ(world->objects[4 + i].index, static_cast<int>(i));
    }
    const kernel::WorldRecord record = world->record();
    EXPECT_EQ(record.sphere_count, 1);
    EXPECT_EQ(record.box_count, 2);
    EXPECT_EQ(record.plane_count, 1);
    EXPECT_EQ(record.placed_count, 4);
    EXPECT_EQ(record.object_count, 8);
    EXPECT_TRUE(world->is_small());
}

scene::Mesh triangles(int count) {
    auto mesh = std::make_shared<scene::TriangleMesh>();
    for (int i = 0; i < count; ++i) {
        const auto first = static_cast<unsigned>(3 * i);
        const auto z = static_cast<float>(i);
        mesh->positions.emplace_back(0.0f, 0.0f, z);
        mesh->positions.emplace_back(1.0f, 0.0f, z);
        mesh->positions.emplace_back(0.0f, 1.0f, z);
        mesh->triangles.emplace_back(first, first + 1, first + 2);
    }
    return {mesh, true};
}

TEST(CompileMeshes, SmallOnesAreTakenApart) {
    const glm::dmat4 m = glm::translate(identity, glm::dvec3(0.0, 0.0, 5.0));
    const auto world = compiled(scene_of(triangles(3), m));
    EXPECT_TRUE(world->is_small());
    ASSERT_EQ(world->triangles.size(), 3u);
    for (int i = 0; i < 3; ++i) {
        const kernel::ObjectRecord& object = world->objects.at(static_cast<std::size_t>(i));
        EXPECT_EQ(object.kind, kernel::OBJECT_TRIANGLE);
        EXPECT_EQ(object.sub, i);
        expect_vec(world->triangles[static_cast<std::size_t>(i)].b, {1.0, 0.0, 5.0 + i}, 0.0 + 1e-6);
    }
}

TEST(CompileMeshes, LargeOnesArePlacedAndSharedByTheirPlacements) {
    scene::Scene scene = scene_of(triangles(100));
    scene.objects.push_back(scene.objects[0]);
    scene.objects[1].to_parent = glm::translate(identity, glm::dvec3(3.0, 0.0, 0.0));
    const auto world = compiled(scene);
    EXPECT_FALSE(world->is_small());
    EXPECT_EQ(world->meshes.size(), 1u) << "the data stands there once";
    EXPECT_EQ(world->instances.size(), 2u);
    EXPECT_TRUE(world->triangles.empty());
    EXPECT_EQ(world->objects.at(1).kind, kernel::OBJECT_MESH);
    EXPECT_EQ(world->instances[1].to_world.shift.x, 3.0f);
    EXPECT_GT(world->memory(), 300 * sizeof(kernel::vec3));
}

TEST(CompileMeshes, MirroredOnesTurnTheirNormals) {
    EXPECT_EQ(compiled(scene_of(triangles(100)))->instances.at(0).flips, 0);
    EXPECT_EQ(compiled(scene_of(triangles(100), glm::scale(identity, glm::dvec3(1.0, -1.0, 1.0))))->instances.at(0).flips, 1);
    EXPECT_EQ(compiled(scene_of(triangles(100), glm::scale(identity, glm::dvec3(-1.0, -1.0, 1.0))))->instances.at(0).flips, 0);
}

TEST(CompileMeshes, OnesWithAndWithoutNormalsKeepTheirs) {
    scene::Scene scene = empty_scene();
    auto plain = triangles(1), smooth = triangles(1), flat = triangles(1);
    auto data = std::make_shared<scene::TriangleMesh>(*smooth.data);
    data->normals = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}};
    data->uvs = {{0, 0}, {1, 0}, {0, 1}};
    smooth.data = data;
    flat.data = data;
    flat.smooth = false;
    for (const scene::Mesh& mesh : {plain, smooth, flat}) {
        scene.objects.push_back({"", mesh, 0, identity, {}});
    }
    const auto world = compiled(scene);
    ASSERT_EQ(world->meshes.size(), 3u);
    EXPECT_EQ(world->meshes[0].flags, 0);
    EXPECT_EQ(world->meshes[1].flags, kernel::MESH_HAS_NORMALS | kernel::MESH_HAS_UVS);
    EXPECT_EQ(world->meshes[2].flags, kernel::MESH_HAS_UVS);
    expect_vec(world->normals.at(static_cast<std::size_t>(world->meshes[1].first_vertex) + 1), {0.0, 1.0, 0.0});
    EXPECT_EQ(world->uvs.at(static_cast<std::size_t>(world->meshes[2].first_vertex) + 1), kernel::vec2(1.0f, 0.0f));
}

TEST(CompileShapes, DegenerateOnesAreRefusedWithTheirPlace) {
    const glm::dmat4 flat_map = glm::scale(identity, glm::dvec3(1.0, 0.0, 1.0));
    EXPECT_EQ(complaint(scene_of(scene::Sphere{}, flat_map)).rfind("test.toml:12:3: error: ", 0), 0u);
    const double nan = std::nan("");
    for (const scene::Shape& shape : std::initializer_list<scene::Shape>{
             scene::Sphere{{0, 0, 0}, 0.0}, scene::Sphere{{0, 0, 0}, -1.0}, scene::Sphere{{0, 0, 0}, nan}, scene::Box{{0, 0, 0}, {1, 0, 1}},
             scene::Box{{0, 0, 0}, {1, -1, 1}}, scene::Plane{{0, 0, 0}, {0, 0, 0}}, scene::Disk{{0, 0, 0}, {0, 0, 0}, 1.0},
             scene::Disk{{0, 0, 0}, {0, 1, 0}, 0.0}, scene::Cylinder{{1, 1, 1}, {1, 1, 1}, 1.0, true},
             scene::Cone{{0, 0, 0}, {0, 1, 0}, 0.0, 0.0, true}}) {
        EXPECT_EQ(complaint(scene_of(shape)).rfind("test.toml:12:3: error: ", 0), 0u) << shape.index();
    }
}

// ---- Camera, lights, settings ------------------------------------------------------------------------------------------------------

glm::dvec3 view_at(const World& world, float x, float y) {
    const kernel::Ray ray = kernel::camera_ray(world.camera, x, y);
    return {static_cast<double>(ray.direction.x), static_cast<double>(ray.direction.y), static_cast<double>(ray.direction.z)};
}

TEST(CompileCamera, FieldOfViewAlongItsAxis) {
    scene::Scene scene = scene_of(scene::Sphere{});
    scene.settings.width = 400;
    scene.settings.height = 200;
    scene.cameras[0].fov = 90.0;
    const double side = std::sqrt(0.5);
    auto world = compiled(scene);
    EXPECT_LT(glm::length(view_at(*world, 200.0f, 100.0f) - glm::dvec3(0.0, 0.0, -1.0)), 1e-6);
    EXPECT_LT(glm::length(view_at(*world, 400.0f, 100.0f) - glm::dvec3(side, 0.0, -side)), 1e-6) << "right edge";
    EXPECT_LT(glm::length(view_at(*world, 0.0f, 100.0f) - glm::dvec3(-side, 0.0, -side)), 1e-6) << "left edge";
    EXPECT_GT(view_at(*world, 200.0f, 0.0f).y, 0.4) << "the picture's first row is above";
    scene.cameras[0].fov_axis = scene::FovAxis::height;
    world = compiled(scene);
    EXPECT_LT(glm::length(view_at(*world, 200.0f, 0.0f) - glm::dvec3(0.0, side, -side)), 1e-6) << "upper edge";
    EXPECT_LT(glm::length(view_at(*world, 200.0f, 200.0f) - glm::dvec3(0.0, -side, -side)), 1e-6) << "lower edge";
}

TEST(CompileCamera, PixelsAreSquareAndUpIsUp) {
    scene::Scene scene = scene_of(scene::Sphere{});
    scene.cameras[0].direction = {3.0, -1.0, 2.0};
    scene.cameras[0].up = {0.0, 5.0, 0.0};
    const auto world = compiled(scene);
    const glm::dvec3 x(world->camera.step_x), y(world->camera.step_y);
    EXPECT_NEAR(glm::length(x) / glm::length(y), 1.0, 1e-6);
    EXPECT_NEAR(glm::dot(x, y), 0.0, 1e-9);
    EXPECT_NEAR(x.y, 0.0, 1e-9) << "the horizon is level";
    EXPECT_LT(y.y, 0.0) << "rows go down";
}

TEST(CompileCamera, ImpossibleOnesAreRefusedWithTheirPlace) {
    const auto with = [](const glm::dvec3& direction, const glm::dvec3& up, double fov, int width) {
        scene::Scene scene = scene_of(scene::Sphere{});
        scene.cameras[0].direction = direction;
        scene.cameras[0].up = up;
        scene.cameras[0].fov = fov;
        scene.cameras[0].source = {"test.toml", 2, 1};
        scene.settings.width = width;
        return complaint(scene);
    };
    const glm::dvec3 ahead(0.0, 0.0, -1.0), up(0.0, 1.0, 0.0);
    for (const std::string& said :
         {with(glm::dvec3(0.0), up, 60.0, 100), with(ahead, ahead, 60.0, 100), with(ahead, -2.0 * ahead, 60.0, 100),
          with(ahead, up, 0.0, 100), with(ahead, up, 180.0, 100), with(ahead, up, std::nan(""), 100), with(ahead, up, 60.0, 0)}) {
        EXPECT_EQ(said.rfind("test.toml:2:1: error: ", 0), 0u) << said;
    }
}

TEST(CompileLights, AllKinds) {
    scene::Scene scene = scene_of(scene::Sphere{});
    scene.lights.push_back({"", scene::PointLight{{1.0, 2.0, 3.0}}, {1.0, 0.5, 0.25}, 0.5, {}});
    scene.lights.push_back({"", scene::SpotLight{{0.0, 5.0, 0.0}, {0.0, -3.0, 0.0}, 60.0, 15.0}, glm::dvec3(1.0), 0.25, {}});
    scene.lights.push_back({"", scene::SpotLight{{0.0, 5.0, 0.0}, {0.0, -3.0, 0.0}, 60.0, 0.0}, glm::dvec3(1.0), 0.25, {}});
    scene.lights.push_back({"", scene::DirectionalLight{{3.0, 0.0, 4.0}}, glm::dvec3(1.0), 0.25, {}});
    const auto world = compiled(scene);
    EXPECT_EQ(world->lights[0].kind, kernel::LIGHT_POINT);
    expect_vec(world->lights[0].radiance, {0.5, 0.25, 0.125});
    expect_vec(world->lights[0].position, {1.0, 2.0, 3.0});
    EXPECT_EQ(world->lights[1].kind, kernel::LIGHT_SPOT);
    EXPECT_NEAR(world->lights[1].cos_outer, 0.5f, 1e-6f);
    EXPECT_NEAR(world->lights[1].cos_inner, std::sqrt(0.5f), 1e-6f);
    expect_vec(world->lights[1].direction, {0.0, -1.0, 0.0});
    EXPECT_GT(world->lights[2].cos_inner, world->lights[2].cos_outer) << "a hard edge is no division by zero";
    EXPECT_EQ(world->lights[3].kind, kernel::LIGHT_DIRECTIONAL);
    expect_vec(world->lights[3].direction, {0.6, 0.0, 0.8});
}

TEST(CompileSettings, OutOfRange) {
    scene::Scene scene = scene_of(scene::Sphere{});
    scene.settings.bounces = 25;
    EXPECT_EQ(complaint(scene), "test.toml: error: 25 bounces: expected 0 to 24");
    scene.settings.bounces = -1;
    EXPECT_EQ(complaint(scene), "test.toml: error: -1 bounces: expected 0 to 24");
    scene.settings.bounces = 24;
    scene.settings.wavelengths = 0;
    EXPECT_EQ(complaint(scene), "test.toml: error: 0 wavelengths: expected 1 or more");
}

// ---- Materials -------------------------------------------------------------------------------------------------------------------

scene::Scene scene_with(const scene::WhittedMaterial& material) {
    scene::Scene scene = scene_of(scene::Sphere{});
    scene.materials[0] = {"it", material, {"test.toml", 20, 1}};
    return scene;
}

double index_of(const kernel::MediumRecord& r, double nm) {
    if (r.refraction == kernel::REFRACTION_CAUCHY) {
        return static_cast<double>(r.refraction_a.x) + static_cast<double>(r.refraction_a.y) / (nm * nm);
    }
    Sellmeier s;
    for (int i = 0; i < 3; ++i) {
        s.b[static_cast<std::size_t>(i)] = static_cast<double>(r.refraction_a[i]);
        s.c[static_cast<std::size_t>(i)] = static_cast<double>(r.refraction_b[i]);
    }
    return s.index(nm);
}

TEST(CompileMaterials, ValuesAreKept) {
    scene::WhittedMaterial material;
    material.color = scene::Rgb(0.1, 0.2, 0.3);
    material.ambient = 0.4;
    material.diffuse = 0.5;
    material.highlight = 0.6;
    material.shininess = 70.0;
    material.reflectivity = 0.8;
    const auto world = compiled(scene_with(material));
    const kernel::WhittedRecord& r = world->materials.at(0);
    expect_vec(r.color, {0.1, 0.2, 0.3});
    EXPECT_EQ(r.texture, -1);
    EXPECT_FLOAT_EQ(r.ambient, 0.4f);
    EXPECT_FLOAT_EQ(r.diffuse, 0.5f);
    EXPECT_FLOAT_EQ(r.highlight, 0.6f);
    EXPECT_FLOAT_EQ(r.shininess, 70.0f);
    EXPECT_FLOAT_EQ(r.reflectivity, 0.8f);
    EXPECT_EQ(r.transparency, 0.0f);
    EXPECT_FALSE(world->has_transparency);
    EXPECT_TRUE(world->bands.empty());
}

TEST(CompileMaterials, IndicesOfRefraction) {
    scene::WhittedMaterial material;
    material.transparency = 1.0;
    material.refraction = 1.7;
    auto world = compiled(scene_with(material));
    EXPECT_TRUE(world->has_transparency);
    EXPECT_EQ(world->media[0].dispersive, 0);
    EXPECT_TRUE(world->bands.empty()) << "one index for all wavelengths needs none";
    EXPECT_NEAR(index_of(world->media[0], 400.0), 1.7, 1e-6);

    // An Abbe number is (n_d - 1) / (n_F - n_C).
    material.refraction = scene::AbbeGlass{1.5168, 64.17};
    world = compiled(scene_with(material));
    const kernel::MediumRecord& abbe = world->media[0];
    EXPECT_EQ(abbe.dispersive, 1);
    EXPECT_NEAR(index_of(abbe, 587.5618), 1.5168, 1e-6);
    EXPECT_NEAR((index_of(abbe, 587.5618) - 1.0) / (index_of(abbe, 486.1327) - index_of(abbe, 656.2725)), 64.17, 0.02);

    material.refraction = scene::NamedGlass{"N-BK7"};
    world = compiled(scene_with(material));
    EXPECT_EQ(world->media[0].refraction, kernel::REFRACTION_SELLMEIER);
    EXPECT_NEAR(index_of(world->media[0], 587.5618), 1.5168, 2e-6);
    EXPECT_EQ(world->bands.size(), 48u);
    glm::dvec3 sum(0.0);
    for (const kernel::BandRecord& band : world->bands) {
        sum += glm::dvec3(band.weight);
    }
    EXPECT_LT(glm::length(sum - glm::dvec3(1.0)), 1e-5) << "all wavelengths together are white";
}

TEST(CompileMaterials, UnknownGlass) {
    scene::WhittedMaterial material;
    material.refraction = scene::NamedGlass{"N-BK8"};
    const std::string said = complaint(scene_with(material));
    EXPECT_EQ(said.rfind("test.toml:20:1: error: no glass is called \"N-BK8\"", 0), 0u) << said;
    EXPECT_NE(said.find("N-BK7"), std::string::npos) << said;
}

TEST(CompileMaterials, MissingPicturesAreNamedWithTheirPlace) {
    scene::WhittedMaterial material;
    scene::ImageTexture texture;
    texture.file = "/nowhere/missing.png";
    texture.position = {"test.toml", 31, 9};
    material.color = texture;
    const std::string said = complaint(scene_with(material));
    EXPECT_EQ(said.rfind("test.toml:31:9: error: ", 0), 0u) << said;
    EXPECT_NE(said.find("/nowhere/missing.png"), std::string::npos) << said;
}

TEST(CompileMaterials, AnInfinitePlaneIsNoLamp) {
    scene::Scene scene = scene_of(scene::Plane{});
    scene.materials[0].model = scene::DiffuseMaterial{};
    scene.materials[0].emission = scene::Emission{scene::Rgb(1.0), 1.0, false};
    scene.materials[0].position = {"test.toml", 7, 1};
    const std::string said = complaint(scene);
    EXPECT_EQ(said.rfind("test.toml:7:1: error: an infinite plane can't be a lamp", 0), 0u) << said;
}

TEST(CompileMaterials, DirectLightHasOneBounce) {
    scene::Scene scene = scene_of(scene::Sphere{});
    scene.materials[0].model = scene::DiffuseMaterial{};
    scene.settings.integrator = "direct";
    EXPECT_EQ(compiled(scene)->max_depth, 1);
    scene.settings.bounces = 2;
    EXPECT_NE(complaint(scene).find("2 bounces: expected 0 to 1"), std::string::npos);
}

TEST(CompileMaterials, AllComplaintsAtOnce) {
    scene::Scene scene = scene_of(scene::Sphere{{0, 0, 0}, 0.0});
    scene::WhittedMaterial glass;
    glass.refraction = scene::NamedGlass{"no such glass"};
    scene.materials.push_back({"a", glass, {}});
    scene.materials.push_back({"b", glass, {}});
    Diagnostics diagnostics;
    EXPECT_EQ(compile_world(scene, scene.cameras[0], diagnostics), nullptr);
    EXPECT_EQ(diagnostics.list().size(), 3u);
}

}  // namespace
}  // namespace lancer
