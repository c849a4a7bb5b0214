#include "lancer/import/default_view.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace lancer {

scene::Camera default_camera(const scene::Bounds& bounds) {
    scene::Camera camera;
    camera.fov = 40.0;
    camera.fov_axis = scene::FovAxis::height;  // the narrower one in most pictures
    glm::dvec3 center(0.0);
    double radius = 1.0;  // of a sphere around everything
    if (!bounds.empty()) {
        center = 0.5 * (bounds.low + bounds.high);
        radius = std::max(0.5 * glm::distance(bounds.low, bounds.high), 1e-6);
    }
    const glm::dvec3 towards_eye = glm::normalize(glm::dvec3(0.4, 0.35, 1.0));
    camera.position = center + towards_eye * (radius / std::sin(glm::radians(0.5 * camera.fov)));
    camera.direction = -towards_eye;
    return camera;
}

std::vector<scene::Light> default_lights() {
    std::vector<scene::Light> lights(2);
    lights[0].name = "key";
    lights[0].model = scene::DirectionalLight{glm::normalize(glm::dvec3(0.6, -1.0, -0.8))};
    lights[0].intensity = 0.7;
    lights[1].name = "fill";
    lights[1].model = scene::DirectionalLight{glm::normalize(glm::dvec3(-1.0, -0.4, -0.5))};
    lights[1].intensity = 0.3;
    return lights;
}

scene::Background default_background() { return {scene::Rgb(0.75), scene::Rgb(0.5), scene::Rgb(0.25)}; }

scene::Background neutral_surroundings() { return {scene::Rgb(1.2), scene::Rgb(0.7), scene::Rgb(0.25)}; }

}  // namespace lancer
