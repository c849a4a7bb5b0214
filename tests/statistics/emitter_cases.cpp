#include "statistics/emitter_cases.h"

#include <utility>

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

#include "lancer/image/image.h"
#include "lancer/world/compile.h"

namespace lancer::statistics {

using namespace kernel;

namespace {

scene::Scene lit_scene() {
    scene::Scene scene;
    scene.settings.integrator = "path";
    scene.settings.rgb = true;
    scene.cameras.push_back({});
    scene::Material material;
    material.model = scene::DiffuseMaterial{};
    material.emission = scene::Emission{scene::Rgb(1.0), 2.0, true};
    scene.materials.push_back(material);
    return scene;
}

std::shared_ptr<const World> compiled(const scene::Scene& scene) {
    Diagnostics diagnostics;
    auto world = compile_world(scene, scene.cameras.front(), diagnostics);
    EXPECT_TRUE(world);
    return world;
}

std::shared_ptr<const World> world_with(const scene::Shape& shape, const glm::dmat4& placed = glm::dmat4(1.0),
                                        const scene::Texture& texture = scene::Rgb(1.0)) {
    scene::Scene scene = lit_scene();
    scene.materials.front().emission->radiance = texture;
    scene::Object object;
    object.shape = shape;
    object.to_parent = placed;
    scene.objects.push_back(object);
    return compiled(scene);
}

template <class Model>
std::shared_ptr<const World> world_lit_by(const Model& model) {
    scene::Scene scene = lit_scene();
    scene::Light light;
    light.model = model;
    light.power = scene::Rgb(3.0);
    scene.lights.push_back(light);
    scene::Object floor;
    floor.shape = scene::Plane{{0.0, -50.0, 0.0}, {0.0, 1.0, 0.0}};
    scene.materials.front().emission.reset();
    scene.objects.push_back(floor);
    return compiled(scene);
}

scene::Mesh grid(int side) {
    auto mesh = std::make_shared<scene::TriangleMesh>();
    for (int i = 0; i <= side; ++i) {
        for (int j = 0; j <= side; ++j) {
            const float x = static_cast<float>(i) / static_cast<float>(side);
            const float z = static_cast<float>(j) / static_cast<float>(side);
            mesh->positions.push_back({x * x, 0.3f * x * z, z});  // triangles of different sizes
        }
    }
    const auto at = [&](int i, int j) { return static_cast<unsigned>(i * (side + 1) + j); };
    for (int i = 0; i < side; ++i) {
        for (int j = 0; j < side; ++j) {
            mesh->triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
            mesh->triangles.push_back({at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)});
        }
    }
    return scene::Mesh{mesh, false};
}

// A lamp of two triangles, too near and too large to be looked at as one point, in a scene that is not small.
std::shared_ptr<const World> world_with_pane() {
    scene::Scene scene = lit_scene();
    auto pane = std::make_shared<scene::TriangleMesh>();
    pane->positions = {{-0.5f, 0.7f, -0.4f}, {0.6f, 0.7f, -0.4f}, {0.6f, 0.9f, 0.5f}, {-0.5f, 0.9f, 0.5f}};
    pane->triangles = {{0, 1, 2}, {0, 2, 3}};
    scene.objects.resize(2);
    scene.objects[0].shape = scene::Mesh{pane, false};
    scene.materials.emplace_back().model = scene::DiffuseMaterial{};
    scene.objects[1].shape = grid(6);
    scene.objects[1].material = 1;
    scene.objects[1].to_parent = glm::translate(glm::dmat4(1.0), {0.0, -90.0, 0.0});
    return compiled(scene);
}

scene::ImageTexture bright_picture() {
    const Image image{2, 2, 3, std::vector<float>(12, 0.5f)};
    const std::string file = testing::TempDir() + "bright.hdr";
    write_image(file, image, {});
    scene::ImageTexture texture;
    texture.file = file;
    return texture;
}

// A few texels of different brightness, one of them a sun, some black.
scene::Background image_of_a_sky() {
    Image image;
    image.width = 12;
    image.height = 6;
    for (int i = 0; i < image.width * image.height; ++i) {
        const float light = i == 20 ? 40.0f : i % 5 == 0 ? 0.0f : 0.2f * static_cast<float>(i % 7);
        image.pixels.insert(image.pixels.end(), {light, 0.5f * light, 2.0f * light});
    }
    const std::string file = testing::TempDir() + "sky.hdr";
    write_image(file, image, {});
    scene::Background background;
    background.image = scene::ImageTexture{};
    background.image->file = file;
    background.rotation = 40.0;
    background.strength = 3.0;
    return background;
}

}  // namespace

std::vector<EmitterCase> emitter_cases() {
    std::vector<EmitterCase> cases;
    const auto add = [&](const std::string& name, int kind, std::shared_ptr<const World> world) {
        cases.push_back({name, kind, std::move(world), {}, 1});
    };
    add("point", EMITTER_POINT, world_lit_by(scene::PointLight{{1.0, 2.0, 0.5}}));
    add("spot", EMITTER_SPOT, world_lit_by(scene::SpotLight{{1.0, 2.0, 0.5}, {-0.4, -0.9, -0.2}, 30.0, 5.0}));
    add("directional", EMITTER_DIRECTIONAL, world_lit_by(scene::DirectionalLight{{0.2, -0.9, 0.1}}));
    scene::ProjectorLight projector;
    projector.position = {1.0, 2.0, 0.5};
    projector.direction = {-1.0, -2.1, -0.6};
    projector.image = bright_picture();
    add("projector", EMITTER_PROJECTOR, world_lit_by(projector));
    add("goniometric", EMITTER_GONIOMETRIC,
        world_lit_by(scene::GoniometricLight{{1.0, 2.0, 0.5}, {0.0, 0.3, -1.0}, {0.0, 1.0, 0.0}, bright_picture()}));
    const scene::Photometry photometry{{0.0, 45.0, 90.0, 180.0}, {0.0}, {3.0, 2.0, 1.0, 1.0}};
    add("photometric", EMITTER_IES,
        world_lit_by(
            scene::IesLight{{1.0, 2.0, 0.5}, {0.0, -1.0, 0.0}, {1.0, 0.0, 0.0}, std::make_shared<const scene::Photometry>(photometry)}));
    scene::Scene sky = lit_scene();
    sky.materials.front().emission.reset();
    scene::Object ball;
    ball.shape = scene::Sphere{{0.0, -9.0, 0.0}, 1.0};
    sky.objects.push_back(ball);
    sky.background.zenith = scene::Rgb(1.0);
    sky.background.horizon = scene::Rgb(0.5);
    sky.background.nadir = scene::Rgb(0.2);
    add("gradient", EMITTER_ENVIRONMENT, compiled(sky));
    sky.background.horizon = sky.background.nadir = sky.background.zenith;
    add("even sky", EMITTER_ENVIRONMENT, compiled(sky));
    sky.background.sky = scene::ClearSky{};
    sky.background.sky->has_sun = false;
    add("clear sky", EMITTER_ENVIRONMENT, compiled(sky));
    sky.background = image_of_a_sky();
    add("image of a sky", EMITTER_ENVIRONMENT, compiled(sky));
    sky.settings.integrator = "direct";
    sky.settings.direct_samples = scene::DirectSamples::emitter;  // what is darker than the mean is drawn, too
    add("image of a sky, all of it", EMITTER_ENVIRONMENT, compiled(sky));
    add("sphere", EMITTER_SPHERE, world_with(scene::Sphere{{0.5, 1.5, 0.7}, 0.8}));
    add("sphere from within", EMITTER_SPHERE, world_with(scene::Sphere{{0.2, 0.3, 0.1}, 1.0}));
    const auto stretch = [](double x, double y, double z) {
        return glm::scale(glm::rotate(glm::translate(glm::dmat4(1.0), {0.4, 1.6, 0.5}), 0.8, {0.3, 0.5, 0.8}), {x, y, z});
    };
    add("stretched sphere", EMITTER_PLACED, world_with(scene::Sphere{{0.0, 0.0, 0.0}, 1.0}, stretch(0.8, 0.3, 0.6)));
    add("box", EMITTER_PLACED, world_with(scene::Box{{-0.5, -0.3, -0.2}, {0.5, 0.3, 0.6}}, stretch(1.0, 1.2, 0.8)));
    add("disk", EMITTER_PLACED, world_with(scene::Disk{{0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 0.8}, stretch(1.0, 1.0, 0.6)));
    add("cylinder", EMITTER_PLACED, world_with(scene::Cylinder{{0.0, 0.0, 0.0}, {0.0, 0.8, 0.0}, 0.4, true}, stretch(1.0, 1.0, 1.0)));
    add("cone", EMITTER_PLACED, world_with(scene::Cone{{0.0, 0.0, 0.0}, {0.0, 0.8, 0.0}, 0.6, 0.2, true}, stretch(1.0, 1.0, 1.0)));
    auto triangle = std::make_shared<scene::TriangleMesh>();
    triangle->positions = {{-0.5f, 1.5f, -0.4f}, {1.2f, 1.6f, 0.0f}, {0.1f, 1.0f, 1.1f}};
    triangle->triangles = {{0, 1, 2}};
    add("triangle", EMITTER_TRIANGLE, world_with(scene::Mesh{triangle, false}));
    // Two small triangles far apart are emitters of their own.
    auto pair = std::make_shared<scene::TriangleMesh>();
    pair->positions = triangle->positions;
    pair->positions.insert(pair->positions.end(), {{90.0f, 0.0f, 0.0f}, {90.0f, 0.0f, 1.0f}, {91.0f, 0.0f, 0.0f}});
    pair->triangles = {{0, 1, 2}};
    pair->triangles.resize(70, {3, 4, 5});
    add("triangle of a large mesh", EMITTER_MESH_TRIANGLE, world_with(scene::Mesh{pair, false}));
    cases.back().count = 70;
    for (const auto& [u, v] : {std::pair{0.0f, 0.0f}, {1.0f, 0.0f}, {0.0f, 1.0f}}) {
        cases.back().corners.push_back(mesh_surface(cases.back().world->record(), 0, 0, u, v, true).position);
    }
    triangle = std::make_shared<scene::TriangleMesh>(*triangle);
    triangle->positions[1] = {-0.3f, 1.52f, -0.3f};  // seen small: drawn by its area
    triangle->positions[2] = {-0.4f, 1.5f, -0.2f};
    add("small triangle", EMITTER_TRIANGLE, world_with(scene::Mesh{triangle, false}));
    add("pane", EMITTER_MESH, world_with_pane());
    for (const int part : {0, 1}) {
        for (const auto& [u, v] : {std::pair{0.0f, 0.0f}, {1.0f, 0.0f}, {0.0f, 1.0f}}) {
            cases.back().corners.push_back(mesh_surface(cases.back().world->record(), 0, part, u, v, true).position);
        }
    }
    const scene::Checker squares{scene::Rgb(1.0), scene::Rgb(0.0), 0.4, true};
    for (const scene::Texture& texture : {scene::Texture(scene::Rgb(1.0)), scene::Texture(squares)}) {
        add("mesh", EMITTER_MESH, world_with(grid(6), glm::translate(glm::dmat4(1.0), {-0.3, 1.3, -0.2}), texture));
        EmitterCase& mesh = cases.back();
        for (std::size_t part = 0; 3 * part < mesh.world->indices.size(); ++part) {
            for (const auto& [u, v] : {std::pair{0.0f, 0.0f}, {1.0f, 0.0f}, {0.0f, 1.0f}}) {
                mesh.corners.push_back(mesh_surface(mesh.world->record(), 0, static_cast<int>(part), u, v, true).position);
            }
        }
    }
    return cases;
}

std::vector<Met> points_along(const EmitterCase& c, const WorldRecord& world, const Vec3& direction, bool all) {
    std::vector<Met> points;
    Ray ray;
    ray.origin = vec3_all(0.0f);
    ray.direction = direction;
    ray.reach = FAR;
    if (c.kind == EMITTER_MESH || c.kind == EMITTER_MESH_TRIANGLE) {
        const int count = static_cast<int>(c.corners.size() / 3);
        for (int part = 0; part < count; ++part) {
            const auto corner = [&](int i) { return c.corners[static_cast<std::size_t>(3 * part + i)]; };
            const TriangleHit met = triangle_hit(corner(0), corner(1), corner(2), ray);
            if (met.t < FAR) {
                points.push_back({mesh_surface(world, 0, part, met.u, met.v, true), part});
            }
        }
        return points;
    }
    for (int i = 0; i < 6; ++i) {
        const Hit hit = closest_of_all(world, ray, true);
        if (hit.object < 0) {
            break;
        }
        points.push_back({object_surface(world, world.objects[hit.object], ray, hit, true), 0});
        if (c.kind == EMITTER_SPHERE && !all) {
            break;  // from outside only the near half is drawn from
        }
        ray.origin = points.back().point.position + direction * 1e-4f;
    }
    return points;
}

}  // namespace lancer::statistics
