// From where a scene is looked at.
#pragma once

#include <string>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lancer/base/diagnostic.h"

namespace lancer::scene {

enum class FovAxis { width, height };
enum class Projection { perspective, orthographic, panorama };

struct Camera {
    std::string name;  // empty for the unnamed one, which comes first
    glm::dvec3 position{0.0, 0.0, 5.0};
    glm::dvec3 direction{0.0, 0.0, -1.0};  // need not have length 1
    glm::dvec3 up{0.0, 1.0, 0.0};
    double fov = 60.0;  // degrees, between the two edges of the picture along `fov_axis`
    FovAxis fov_axis = FovAxis::width;
    Projection projection = Projection::perspective;
    double extent = 2.0;          // orthographic: metres across the picture along `fov_axis`
    double aperture = 0.0;        // diameter of the lens in metres; 0: a pinhole, all is sharp
    double focus_distance = 5.0;  // of the plane that is sharp, along the view
    glm::dvec2 shift{0.0};  // where the view meets the picture: so far left of its middle and below it, in parts of its width and height
    double pixel_aspect = 1.0;  // width of a pixel over its height
    SourcePosition source;
};

}  // namespace lancer::scene
