// Pictures of the surroundings.
#pragma once

#include <string>
#include <vector>

#include <glm/mat3x3.hpp>

#include "lancer/image/image.h"
#include "lancer/scene/color.h"
#include "lancer/scene/lights.h"
#include "lancer/scene/textures.h"

namespace lancer::pbrt {

struct Environment {
    std::string file;
    SourcePosition position;
    Image image;               // its pixels, where they have been read
    bool square = true;        // laid out on a square of equal areas, as version 4 wants it; else by latitudes and longitudes
    scene::Rgb scale{1.0};     // times this
    glm::dmat3 to_light{1.0};  // from directions of the world to those of the picture, whose z is up
};

// The mean over the sphere. `square` as above.
scene::Rgb mean_color(const Image& image, bool square);

// What the upper half of the sphere sends down on a surface, weighed by the eye.
double illuminance_of(const Image& square);

// All of them together, and a colour that comes from everywhere besides, as one latitude-longitude picture in memory. They have their pixels.
scene::ImageTexture panorama_of(const std::vector<Environment>& environments, const scene::Rgb& everywhere);

// Where x, y and z of scene::Background's image lie for such a picture; false where its transform squeezes it.
bool turned_axes(const Environment& environment, glm::dmat3& axes);

}  // namespace lancer::pbrt
