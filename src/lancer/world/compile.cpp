#include "lancer/world/compile.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "lancer/kernel/spectrum.h"
#include "lancer/scene/integrator.h"
#include "lancer/spectrum/sensor.h"
#include "lancer/spectrum/upsample.h"
#include "lancer/world/bounds.h"
#include "lancer/world/emission.h"
#include "lancer/world/emitters.h"
#include "lancer/world/filters.h"
#include "lancer/world/flatten.h"
#include "lancer/world/lights.h"
#include "lancer/world/materials.h"
#include "lancer/world/names.h"
#include "lancer/world/shapes.h"
#include "lancer/world/sky.h"
#include "lancer/world/spectra.h"
#include "lancer/world/surroundings.h"
#include "lancer/world/volumes.h"
#include "lancer/world/wavelengths.h"

namespace lancer {

namespace {

kernel::vec3 to_float(const glm::dvec3& v) { return kernel::vec3(v); }

kernel::CameraRecord compile_camera(const scene::Camera& camera, int width, int height, Diagnostics& diagnostics) {
    if (width < 1 || height < 1) {
        diagnostics.error(camera.source,
                          "a picture of " + std::to_string(width) + " x " + std::to_string(height) + " pixels can't be made");
    }
    if (!(camera.fov > 0.0 && camera.fov < 180.0)) {
        diagnostics.error(camera.source, "the camera's field of view must lie between 0 and 180 degrees");
    }
    if (!(camera.pixel_aspect > 0.0 && std::isfinite(camera.pixel_aspect) && std::isfinite(camera.shift.x) &&
          std::isfinite(camera.shift.y))) {
        diagnostics.error(camera.source, "the camera's pixels must have a shape, and its shift must be finite");
    }
    if (!(glm::length(glm::cross(camera.direction, camera.up)) > 0.0)) {
        diagnostics.error(camera.source, "the camera must look somewhere, and \"up\" must not point along its view");
    }
    const glm::dvec3 forward = glm::normalize(camera.direction);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
    const glm::dvec3 down = -glm::cross(right, forward);
    // One pixel's size on the plane at distance 1.
    const double across = camera.fov_axis == scene::FovAxis::width ? width : height;
    const double aspect = camera.pixel_aspect;
    const glm::dvec2 shape = camera.fov_axis == scene::FovAxis::width ? glm::dvec2(1.0, 1.0 / aspect) : glm::dvec2(aspect, 1.0);
    const glm::dvec2 pixel = shape * (2.0 * std::tan(glm::radians(camera.fov) / 2.0) / across);
    // From where the view meets the film to its upper left corner, in pixels.
    const glm::dvec2 off(width * (camera.shift.x - 0.5), height * (-camera.shift.y - 0.5));
    const glm::dvec3 corner = forward + right * (pixel.x * off.x) + down * (pixel.y * off.y);
    kernel::CameraRecord record{};
    record.position = to_float(camera.position);
    record.corner = to_float(corner);
    record.step_x = to_float(right * pixel.x);
    record.step_y = to_float(down * pixel.y);
    record.right = to_float(right);
    record.down = to_float(down);
    record.forward = to_float(forward);
    record.kind = kernel::CAMERA_PERSPECTIVE;
    record.lens_radius = static_cast<float>(camera.aperture / 2.0);
    record.focus_distance = static_cast<float>(camera.focus_distance);
    if (camera.projection == scene::Projection::orthographic) {
        const glm::dvec2 step = shape * (camera.extent / across);
        record.kind = kernel::CAMERA_ORTHOGRAPHIC;
        record.corner = to_float(camera.position + right * (step.x * off.x) + down * (step.y * off.y));
        record.step_x = to_float(right * step.x);
        record.step_y = to_float(down * step.y);
    } else if (camera.projection == scene::Projection::panorama) {
        record.kind = kernel::CAMERA_PANORAMA;
    }
    record.width = static_cast<float>(width);
    record.height = static_cast<float>(height);
    return record;
}

// What the path integrator needs beyond what all need.
void compile_physics(const scene::Scene& scene, World& world) {
    world.max_depth = scene::bounces_of(scene);
    const scene::RenderSettings& settings = scene.settings;
    world.limits.limited = settings.diffuse_bounces || settings.glossy_bounces || settings.transmission_bounces ? 1 : 0;
    world.limits.diffuse = settings.diffuse_bounces.value_or(world.max_depth);
    world.limits.glossy = settings.glossy_bounces.value_or(world.max_depth);
    world.limits.transmission = settings.transmission_bounces.value_or(world.max_depth);
    world.ways = scene::chosen_integrator(scene) != "direct"                ? kernel::WAYS_BOTH
                 : settings.direct_samples == scene::DirectSamples::emitter ? kernel::WAYS_EMITTER
                 : settings.direct_samples == scene::DirectSamples::bsdf    ? kernel::WAYS_BSDF
                                                                            : kernel::WAYS_BOTH;
    world.halves = scene::chosen_integrator(scene) == "light"  ? kernel::HALF_OF_LIGHT
                   : scene::chosen_integrator(scene) == "bdpt" ? kernel::HALVES_JOINED
                   : scene::chosen_integrator(scene) == "vcm"  ? kernel::HALVES_MERGED
                                                               : kernel::HALF_OF_CAMERA;
    world.seed = scene.settings.seed;
    compile_filter(scene.settings, world);
    world.spectral = !scene.settings.rgb;
    // Each of a pixel's samples stands for its share of the pixel. An eighth of its width is as fine as textures are worth looking at.
    world.beam = static_cast<float>(std::max(0.125, 1.0 / std::sqrt(static_cast<double>(std::max(scene.settings.spp, 1)))));
    if (world.spectral) {
        for (int i = 0; i < kernel::WAVELENGTH_COUNT; ++i) {
            world.observer.push_back(to_float(sensor_weight(static_cast<double>(kernel::FIRST_WAVELENGTH) + i)));
        }
    }
}

// All pictures at once: the materials are compiled twice, the first time for no more than what they ask for.
void read_pictures(const scene::Scene& scene, bool physical, Textures& textures) {
    World scratch;
    Diagnostics said_later;
    Textures probe(scratch, said_later);
    probe.only_note();
    Colors colors(scratch);
    compile_materials(scene, scratch, probe, colors, said_later);
    if (physical) {
        compile_surfaces(scene, scratch, probe, colors, said_later);
    }
    textures.read_ahead(probe);
}

}  // namespace

std::shared_ptr<const World> compile_world(const scene::Scene& scene, const scene::Camera& camera, Diagnostics& diagnostics) {
    auto world = std::make_shared<World>();
    const bool physical = scene::follows_paths(scene);
    const int bounces = scene::bounces_of(scene);
    const int most = scene::chosen_integrator(scene) == "direct" ? 1 : physical ? max_path_bounces : kernel::MAX_BOUNCES;
    if (bounces < 0 || bounces > most) {
        diagnostics.error({scene.file, 0, 0}, std::to_string(bounces) + " bounces: expected 0 to " + std::to_string(most));
    }
    if (scene.settings.wavelengths < 1) {
        diagnostics.error({scene.file, 0, 0}, std::to_string(scene.settings.wavelengths) + " wavelengths: expected 1 or more");
    }
    const std::string integrator = scene::chosen_integrator(scene);
    for (const scene::Obstacle& obstacle : scene::obstacles(scene, integrator)) {
        diagnostics.error(obstacle.position, "the " + integrator + " integrator can't render this: " + obstacle.what);
    }
    world->bounces = bounces;
    world->min_weight = static_cast<float>(scene.settings.min_weight);
    world->camera = compile_camera(camera, scene.settings.width, scene.settings.height, diagnostics);
    world->ambient = to_float(emitted(scene.ambient));
    for (const scene::Light& light : scene.lights) {
        world->lights.push_back(light_record(light));
    }
    if (diagnostics.has_errors()) {
        return nullptr;
    }
    Textures textures(*world, diagnostics);
    read_pictures(scene, physical, textures);
    Colors colors(*world);
    compile_materials(scene, *world, textures, colors, diagnostics);
    if (physical) {
        compile_physics(scene, *world);
        compile_surfaces(scene, *world, textures, colors, diagnostics);
        compile_volumes(scene, *world, colors, diagnostics);
        world->beam = world->textures.empty() ? 0.0f : world->beam;
    }
    const std::vector<FlatObject> flat = flatten(scene);
    compile_names(scene, flat, *world);
    compile_sky(scene.background, *world, colors, diagnostics);
    compile_shapes(flat, *world, diagnostics);
    if (physical && !diagnostics.has_errors()) {
        compile_emitters(scene, *world, textures, colors, diagnostics);
        compile_emission(*world);
        compile_wavelengths(*world);
        if (world->has_media) {
            world->camera_bodies = bodies_around(*world, camera.position);
        }
    }
    if (diagnostics.has_errors()) {
        return nullptr;
    }
    if (world->is_small()) {
        compile_bounds(*world);
    }
    return world;
}

}  // namespace lancer
