// Scenes of a few lines, and single rays through them.
#pragma once

#include <memory>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lancer/device/cpu/cpu.h"
#include "lancer/scene/scene.h"

namespace lancer::tests {

// Starts empty and dark: no background, no ambient light, one camera at (0, 0, 5) that looks along -z. The picture is 101 x 101 pixels of a
// field of view of 90 degrees; its middle (50.5, 50.5) is the view itself. No path is too weak to be followed.
class SmallWorld {
public:
    SmallWorld();

    // The number of the material.
    int add(const scene::WhittedMaterial& material);
    void add(const scene::Shape& shape, int material, const glm::dmat4& to_world = glm::dmat4(1.0));
    void add_light(const decltype(scene::Light::model)& model, double intensity, const glm::dvec3& color = glm::dvec3(1.0));
    void set_background(double zenith, double horizon, double nadir);
    void look(const glm::dvec3& from, const glm::dvec3& direction, const glm::dvec3& up = {0.0, 1.0, 0.0});

    // Fails the running test and throws where the scene does not compile.
    std::shared_ptr<const World> compile() const;

    // What the camera sees straight ahead, or at a point of the picture.
    glm::dvec3 ahead(const CpuOptions& options = {}) const;
    glm::dvec3 at(const glm::dvec2& point, const CpuOptions& options = {}) const;

    // The whole picture, `size` x `size` pixels.
    std::vector<glm::vec3> picture(int size, const CpuOptions& options = {}) const;

    scene::Scene scene;
};

// The middles of all pixels, row by row.
std::vector<glm::vec2> pixel_middles(int width, int height);

// A material that shows `ambient` of the ambient light and nothing else.
scene::WhittedMaterial glowing(double ambient, const glm::dvec3& color = glm::dvec3(1.0));
scene::WhittedMaterial matte(const glm::dvec3& color = glm::dvec3(1.0));
scene::WhittedMaterial clear(const scene::Refraction& refraction, double transparency = 1.0);

}  // namespace lancer::tests
