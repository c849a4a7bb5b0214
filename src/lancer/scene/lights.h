// Lamps, and the light that comes from outside of the scene.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "lancer/base/diagnostic.h"
#include "lancer/scene/color.h"
#include "lancer/scene/textures.h"

namespace lancer::scene {

struct PointLight {
    glm::dvec3 position{0.0};
};

enum class SpotFade { smooth, even, square };  // by a smooth step of the cosine, evenly with the angle, or with its cosine's square

struct SpotLight {
    glm::dvec3 position{0.0};
    glm::dvec3 direction{0.0, -1.0, 0.0};
    double angle = 30.0;                               // degrees from the axis to where the light ends
    double falloff = 5.0;                              // degrees over which it fades, measured inwards from `angle`
    std::optional<ImageTexture> image = std::nullopt;  // times this: a square around the cone, thrown as a projector does
    glm::dvec3 up{0.0, 1.0, 0.0};                      // of that picture
    SpotFade fade = SpotFade::smooth;
};

struct DirectionalLight {
    glm::dvec3 direction{0.0, -1.0, 0.0};  // the way the light travels
};

enum class ProjectorFov { width, height, smaller };

// A picture thrown from a point. Whoever stands there and looks along `direction` sees it the right way round on a wall.
struct ProjectorLight {
    glm::dvec3 position{0.0};
    glm::dvec3 direction{0.0, 0.0, -1.0};
    glm::dvec3 up{0.0, 1.0, 0.0};
    double fov = 30.0;  // degrees, between the two edges of the picture along `fov_axis`
    ProjectorFov fov_axis = ProjectorFov::width;
    std::optional<ImageTexture> image = std::nullopt;  // none: a white square
    bool even = true;  // on a screen at right angles white is as bright at the edges as in the middle; else as intense in each direction
};

// A point whose intensity in each direction is that of a latitude-longitude picture as one sees it from there: its middle lies along `direction`, its
// top along `up`.
struct GoniometricLight {
    glm::dvec3 position{0.0};
    glm::dvec3 direction{0.0, 0.0, -1.0};
    glm::dvec3 up{0.0, 1.0, 0.0};
    ImageTexture image;
};

// Measured intensities of a lamp; straight lines between the angles, in both. Beyond the last vertical one there is no light.
struct Photometry {
    std::vector<double> vertical;    // degrees from the lamp's axis, rising, 0 to 180
    std::vector<double> horizontal;  // degrees about it, rising, from 0 to 360; a single one: the same all around
    std::vector<double> candela;     // of each horizontal angle, one for each vertical angle
};

// A point with the intensities of a photometric file.
struct IesLight {
    glm::dvec3 position{0.0};
    glm::dvec3 direction{0.0, -1.0, 0.0};  // vertical angle 0
    glm::dvec3 forward{1.0, 0.0, 0.0};     // horizontal angle 0; the angle grows counter-clockwise as seen against `direction`
    std::shared_ptr<const Photometry> photometry;
};

struct Light {
    std::string name;
    std::variant<PointLight, SpotLight, DirectionalLight, ProjectorLight, GoniometricLight, IesLight> model;
    Color color = Rgb(1.0);
    double intensity = 1.0;  // in Whitted scenes its share of the light; the shares sum to 1
    SourcePosition position;

    // For light that follows physics: W/sr of point and spot lights, W/m^2 at right angles of directional ones, weighed by the eye. Of lights with a
    // picture: where that is white; a projector's, along its axis. Of those with a photometric file: for each candela.
    std::optional<Color> power = std::nullopt;
};

// A clear sky with the sun, computed from what the air is made of. The ground below is the same everywhere.
struct ClearSky {
    glm::dvec3 sun{0.0, 0.7071067811865476, -0.7071067811865476};  // the direction towards it, length 1
    double distance = 1.0;                                         // of the sun, in astronomical units
    double turbidity = 3.0;                                        // 1: pure air; 2 to 3: clear; 10: haze
    double ozone = 0.3;                                            // atm-cm
    double ground = 0.2;                                           // the share of light that it scatters back
    bool has_sun = true;                                           // whether the sun itself is there, and not only its light in the air
    glm::dvec3 up{0.0, 1.0, 0.0};                                  // length 1
};

// What rays see that leave the scene: a vertical gradient, all equal for a plain colour; or a latitude-longitude image around it.
struct Background {
    Color zenith;
    Color horizon;
    Color nadir;
    std::optional<ImageTexture> image = std::nullopt;  // its middle lies along -z, its right half towards +x, its top along +y
    double rotation = 0.0;                             // of the image about +y: degrees, counter-clockwise as seen from above
    glm::dmat3 axes{1.0};  // where x, y and z of the turned image lie, column by column: length 1, at right angles; of either hand
    std::optional<ClearSky> sky = std::nullopt;  // instead of colours and image; of spectral radiance in W/(m^2 sr nm)
    double strength = 1.0;                       // times this
    bool visible = true;                         // to the camera itself
};

}  // namespace lancer::scene
