#include "lancer/import/pbrt/cameras.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>
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
    Builder(ImportContext& context, const Recipe& camera, const Recipe* film, scene::RenderSettings& settings)
        : context_(context), type_(camera.type), parameters_(camera.parameters), film_(film), settings_(settings) {}

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
        crop(camera);
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
        along_x_ = apply_to_direction(to_world, {1.0, 0.0, 0.0});
    }

    void set_spherical(scene::Camera& camera) {
        camera.projection = scene::Projection::panorama;
        // The middle of the picture looks along its own -x, the right half along -z.
        camera.direction = -along_x_;
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
        if (glm::length(window.middle()) > 1e-6 * across) {
            camera.shift = window.middle() / size;
        }
        if (std::abs(size.x / size.y - aspect) > 1e-6 * aspect) {
            camera.pixel_aspect = std::clamp(size.x / size.y / aspect, 1e-3, 1e3);
        }
        if (type_ == "orthographic") {
            camera.projection = scene::Projection::orthographic;
            // Its transform may scale, too.
            camera.extent = across * glm::length(camera.up);
        } else {
            // Of real lenses one can't tell without following light through them: a normal one.
            parameters_.pass_over({"lensfile", "aperturediameter", "focusdistance", "aperture"});
            double fov = parameters_.number("fov", type_ == "realistic" ? 27.0 : 90.0);
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

    // The part of the film that is rendered, in pixels: a smaller film behind a lens that is shifted.
    void crop(scene::Camera& camera) {
        if (film_ == nullptr) {
            return;
        }
        const Parameters& film = film_->parameters;
        const glm::dvec2 whole(settings_.width, settings_.height);
        glm::dvec2 low(0.0), high = whole;
        if (const std::vector<double> shares = film.numbers("cropwindow"); shares.size() == 4) {
            low = glm::ceil(whole * glm::clamp(glm::dvec2(shares[0], shares[2]), 0.0, 1.0));
            high = glm::ceil(whole * glm::clamp(glm::dvec2(shares[1], shares[3]), 0.0, 1.0));
        }
        if (const std::vector<int> pixels = film.integers("pixelbounds"); pixels.size() == 4) {
            low = glm::clamp(glm::dvec2(pixels[0], pixels[2]), glm::dvec2(0.0), whole);
            high = glm::clamp(glm::dvec2(pixels[1], pixels[3]), glm::dvec2(0.0), whole);
        }
        const glm::dvec2 size = high - low;
        if (size == whole) {
            return;
        }
        if (!(size.x >= 1.0 && size.y >= 1.0)) {
            context_.diagnostics.error(film.position(), "the part of the film that is to be rendered has no pixels");
            return;
        }
        if (camera.projection == scene::Projection::panorama) {
            context_.report.dropped("a part of a panorama", "the whole picture is rendered", film.position());
            return;
        }
        const double share = camera.fov_axis == scene::FovAxis::width ? size.x / whole.x : size.y / whole.y;
        camera.fov = glm::degrees(2.0 * std::atan(std::tan(glm::radians(camera.fov) / 2.0) * share));
        camera.extent *= share;
        const glm::dvec2 off = 0.5 * (low + high - whole) / size;
        camera.shift = camera.shift * whole / size + glm::dvec2(off.x, -off.y);
        settings_.width = static_cast<int>(size.x);
        settings_.height = static_cast<int>(size.y);
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
    const Recipe* film_;
    scene::RenderSettings& settings_;
    glm::dvec3 along_x_{1.0, 0.0, 0.0};  // the camera's own, in the world
};

}  // namespace

scene::Camera build_camera(ImportContext& context, const Recipe* camera, const Recipe* film, const glm::dmat4& from_world,
                           scene::RenderSettings& settings) {
    const Recipe standard{Parameters(context, "Camera", {context.path, 0, 0}, {}), "perspective", ColorSpace::srgb, 0};
    return Builder(context, camera != nullptr ? *camera : standard, film, settings).build(from_world);
}

}  // namespace lancer::pbrt
