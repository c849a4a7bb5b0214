#include "analytic/small_world.h"

#include <stdexcept>

#include "lancer/world/compile.h"

namespace lancer::tests {

SmallWorld::SmallWorld() {
    scene::Camera camera;
    camera.position = {0.0, 0.0, 5.0};
    camera.fov = 90.0;
    scene.cameras = {camera};
    scene.ambient = glm::dvec3(0.0);
    scene.settings.width = 101;
    scene.settings.height = 101;
    scene.settings.min_weight = 0.0;
}

int SmallWorld::add(const scene::WhittedMaterial& material) {
    scene.materials.push_back({"", material, {}});
    return static_cast<int>(scene.materials.size()) - 1;
}

void SmallWorld::add(const scene::Shape& shape, int material, const glm::dmat4& to_world) {
    scene.objects.push_back({"", shape, material, to_world, {}});
}

void SmallWorld::add_light(const decltype(scene::Light::model)& model, double intensity, const glm::dvec3& color) {
    scene.lights.push_back({"", model, color, intensity, {}});
}

void SmallWorld::set_background(double zenith, double horizon, double nadir) {
    scene.background = {glm::dvec3(zenith), glm::dvec3(horizon), glm::dvec3(nadir)};
}

void SmallWorld::look(const glm::dvec3& from, const glm::dvec3& direction, const glm::dvec3& up) {
    scene.cameras[0].position = from;
    scene.cameras[0].direction = direction;
    scene.cameras[0].up = up;
}

std::shared_ptr<const World> SmallWorld::compile() const {
    Diagnostics diagnostics;
    auto world = compile_world(scene, scene.cameras[0], diagnostics);
    if (!world) {
        throw std::runtime_error("the test's scene does not compile: " + to_string(diagnostics.list().at(0)));
    }
    return world;
}

glm::dvec3 SmallWorld::ahead(const CpuOptions& options) const {
    return at({0.5 * scene.settings.width, 0.5 * scene.settings.height}, options);
}

glm::dvec3 SmallWorld::at(const glm::dvec2& point, const CpuOptions& options) const {
    const glm::vec2 points[1] = {glm::vec2(point)};
    glm::vec3 radiance[1];
    RayCounts counts;
    make_cpu_device(compile(), options)->follow(points, radiance, counts);
    return glm::dvec3(radiance[0]);
}

std::vector<glm::vec3> SmallWorld::picture(int size, const CpuOptions& options) const {
    SmallWorld sized = *this;
    sized.scene.settings.width = size;
    sized.scene.settings.height = size;
    const std::vector<glm::vec2> points = pixel_middles(size, size);
    std::vector<glm::vec3> radiance(points.size());
    RayCounts counts;
    make_cpu_device(sized.compile(), options)->follow(points, radiance, counts);
    return radiance;
}

std::vector<glm::vec2> pixel_middles(int width, int height) {
    std::vector<glm::vec2> points;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            points.emplace_back(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
        }
    }
    return points;
}

scene::WhittedMaterial glowing(double ambient, const glm::dvec3& color) {
    scene::WhittedMaterial material;
    material.color = color;
    material.ambient = ambient;
    material.diffuse = 0.0;
    material.highlight = 0.0;
    return material;
}

scene::WhittedMaterial matte(const glm::dvec3& color) {
    scene::WhittedMaterial material = glowing(0.0, color);
    material.diffuse = 1.0;
    return material;
}

scene::WhittedMaterial clear(const scene::Refraction& refraction, double transparency) {
    scene::WhittedMaterial material = glowing(0.0);
    material.transparency = transparency;
    material.refraction = refraction;
    return material;
}

}  // namespace lancer::tests
