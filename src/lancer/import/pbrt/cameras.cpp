#include "lancer/import/pbrt/cameras.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "lancer/import/pbrt/transforms.h"

namespace lancer::pbrt {

namespace {

// The part of the plane at distance 1 (or, without perspective, of any plane) that is on the film, x to the right and y up.
struct Window {
    glm::dvec2 low;
    glm::dvec2 high;

    glm::dvec2 size() const { return high - low; }
    glm::dvec2 middle() const { return 0.5 * (low + high); }
};

// The shorter side runs from -1 to 1.
Window usual_window(double aspect) {
    const glm::dvec2 reach = aspect > 1.0 ? glm::dvec2(aspect, 1.0) : glm::dvec2(1.0, 1.0 / aspect);
    return {-reach, reach};
}

class Builder {
public:
    Builder(ImportContext& context, const Recipe& camera, scene::RenderSettings& settings)
        : context_(context), type_(camera.type), parameters_(camera.parameters), settings_(settings) {}

    scene::Camera build(const glm::dmat4& from_world) {
        scene::Camera camera;
        camera.source = parameters_.position();
        place(from_world, camera);
        parameters_.pass_over({"shutteropen", "shutterclose", "halffov"});
        if (type_ == "spherical" || type_ == "environment") {
            set_spherical(camera);
        } else {
            set_flat(camera);
        }
        return camera;
    }

private:
    void place(const glm::dmat4& from_world, scene::Camera& camera) {
        if (!is_usable(from_world)) {
            context_.diagnostics.error(parameters_.position(), "the camera's transform squeezes space flat");
            return;
        }
        const glm::dmat4 to_world = glm::inverse(from_world);
        camera.position = apply_to_point(to_world, glm::dvec3(0.0));
        camera.direction = apply_to_direction(to_world, {0.0, 0.0, 1.0});
        camera.up = apply_to_direction(to_world, {0.0, 1.0, 0.0});
        // Its own x points right, y up and z forward: the wrong hand, unless the transform mirrors.
        mirrored_ = glm::determinant(glm::dmat3(to_world)) > 0.0;
    }

    void set_spherical(scene::Camera& camera) {
        camera.projection = scene::Projection::panorama;
        // The middle of the picture looks along -x, its right half towards -z.
        const glm::dvec3 forward = camera.direction;
        const glm::dvec3 right = glm::cross(forward, camera.up) * (mirrored_ ? -1.0 : 1.0);
        camera.direction = -right;
        if (type_ == "environment" || parameters_.string("mapping", "equalarea") == "equirectangular") {
            context_.report.honoured(parameters_.owner(), parameters_.position());
        } else {
            context_.report.approximated(parameters_.owner() + " of equal areas", "a picture of latitudes and longitudes",
                                         parameters_.position());
        }
        parameters_.pass_over({"lensradius", "focaldistance"});
    }

    void set_flat(scene::Camera& camera) {
        const double aspect = static_cast<double>(settings_.width) / settings_.height;
        Window window = usual_window(std::max(parameters_.number("frameaspectratio", aspect), 1e-6));
        if (const std::vector<double> written = parameters_.numbers("screenwindow"); written.size() == 4) {
            window = {{written[0], written[2]}, {written[1], written[3]}};
        } else if (!written.empty()) {
            parameters_.error(*parameters_.find("screenwindow"), "\"screenwindow\" needs four numbers");
        }
        const glm::dvec2 size = window.size();
        if (!(size.x > 0.0 && size.y > 0.0)) {
            parameters_.error(*parameters_.find("screenwindow"), "\"screenwindow\" needs two rising numbers for x and two for y");
            return;
        }
        camera.fov_axis = size.x < size.y ? scene::FovAxis::width : scene::FovAxis::height;
        const double across = std::min(size.x, size.y);

        if (std::abs(size.x / size.y - aspect) > 1e-3 * aspect) {
            context_.report.approximated("pixels that are not square", "square ones", parameters_.position());
        }
        if (type_ == "orthographic") {
            camera.projection = scene::Projection::orthographic;
            // Its transform may scale, too.
            camera.extent = across * glm::length(camera.up);
        } else {
            double fov = parameters_.number("fov", 90.0);
            if (!(fov > 0.0 && fov < 180.0)) {
                parameters_.error(*parameters_.find("fov"), "\"fov\" must lie between 0 and 180 degrees");
                fov = 90.0;
            }
            camera.fov = glm::degrees(2.0 * std::atan(std::tan(glm::radians(fov / 2.0)) * across / 2.0));
        }
        set_lens(camera);
        if (type_ == "perspective" || type_ == "orthographic") {
            context_.report.honoured(parameters_.owner(), parameters_.position());
        } else {
            context_.report.approximated(parameters_.owner(), "a thin lens", parameters_.position());
        }
    }

    void set_lens(scene::Camera& camera) {
        const double radius = parameters_.number("lensradius", 0.0);
        const double focus = parameters_.number("focaldistance", 1e6);
        const double scale = glm::length(camera.direction);
        camera.aperture = std::max(2.0 * radius * scale, 0.0);
        camera.focus_distance = focus > 0.0 ? focus * scale : camera.focus_distance;
    }

    ImportContext& context_;
    const std::string& type_;
    const Parameters& parameters_;
    scene::RenderSettings& settings_;
    bool mirrored_ = false;
};

}  // namespace

scene::Camera build_camera(ImportContext& context, const Recipe* camera, const Recipe*, const glm::dmat4& from_world,
                           scene::RenderSettings& settings) {
    const Recipe standard{Parameters(context, "Camera", {context.path, 0, 0}, {}), "perspective", ColorSpace::srgb, 0};
    return Builder(context, camera != nullptr ? *camera : standard, settings).build(from_world);
}

}  // namespace lancer::pbrt
