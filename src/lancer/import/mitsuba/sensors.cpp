#include "lancer/import/mitsuba/sensors.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "lancer/import/mesh/mesh_messages.h"
#include "lancer/import/mitsuba/values.h"

namespace lancer::mitsuba {

namespace {

constexpr int largest_side = 65536;

void set_filter(Builder& builder, const Element& element) {
    Plugin plugin = builder.plugin(element);
    scene::RenderSettings& settings = builder.scene.settings;
    bool same = true;
    if (plugin.type() == "box") {
        settings.filter = scene::PixelFilter::box;
        settings.filter_radius = plugin.number("radius", 0.5, 0.01, 32.0);
    } else if (plugin.type() == "tent") {
        settings.filter = scene::PixelFilter::tent;
        settings.filter_radius = plugin.number("radius", 1.0, 0.01, 32.0);
    } else if (plugin.type() == "gaussian") {
        // Four standard deviations here, three with us.
        const double deviation = plugin.number("stddev", 0.5, 0.01, 8.0);
        settings.filter = scene::PixelFilter::gaussian;
        settings.filter_radius = 3.0 * deviation;
    } else if (plugin.type() == "mitchell") {
        settings.filter = scene::PixelFilter::mitchell;
        settings.filter_radius = 2.0;
        same = plugin.number("A", 1.0 / 3.0) == 1.0 / 3.0 && plugin.number("B", 1.0 / 3.0) == 1.0 / 3.0;
    } else {
        settings.filter = scene::PixelFilter::mitchell;
        settings.filter_radius = 2.0;
        same = false;
        plugin.ignore("lobes");
    }
    plugin.finish();
    if (same) {
        builder.honoured(plugin);
    } else {
        builder.approximated(plugin, "Mitchell and Netravali's filter");
    }
}

// A window of the film is a smaller film behind a lens that is shifted.
struct Window {
    glm::ivec2 whole{0};  // pixels of the film
    glm::ivec2 from{0};   // its upper left corner
    glm::ivec2 size{0};
};

Window window_of(Builder& builder, const Element& element) {
    Plugin plugin = builder.plugin(element);
    Window window;
    window.whole = {plugin.integer("width", 768), plugin.integer("height", 576)};
    window.from = {plugin.integer("crop_offset_x", 0), plugin.integer("crop_offset_y", 0)};
    window.size = {plugin.integer("crop_width", window.whole.x), plugin.integer("crop_height", window.whole.y)};
    if (window.from.x < 0 || window.from.y < 0 || window.size.x < 1 || window.size.y < 1 ||
        window.size.x > window.whole.x - window.from.x || window.size.y > window.whole.y - window.from.y) {
        builder.error(plugin.position(), "the crop window does not lie on the film");
        window.from = {0, 0};
        window.size = window.whole;
    }
    return window;
}

void set_film(Builder& builder, const Element& element, const Window& window) {
    Plugin plugin = builder.plugin(element);
    scene::RenderSettings& settings = builder.scene.settings;
    const int width = plugin.integer("width", 768), height = plugin.integer("height", 576);
    if (width < 1 || height < 1 || width > largest_side || height > largest_side) {
        builder.error(plugin.position(), fmt::format("a film of {} x {} pixels: expected 1 to {}", width, height, largest_side));
        return;
    }
    settings.width = window.size.x;
    settings.height = window.size.y;
    settings.filter = scene::PixelFilter::gaussian;
    settings.filter_radius = 1.5;
    for (const auto& [name, filter] : plugin.children({"rfilter"})) {
        set_filter(builder, *filter);
    }
    for (const std::string_view name :
         {"crop_width", "crop_height", "crop_offset_x", "crop_offset_y", "pixel_format", "component_format", "file_format", "sample_border",
          "compensate", "banner", "attach_log", "high_quality_edges", "gamma", "exposure", "tonemap_method", "label"}) {
        plugin.ignore(name);
    }
    if (plugin.type() == "hdrfilm" || plugin.type() == "ldrfilm") {
        builder.honoured(plugin);
    } else {
        builder.approximated(plugin, "a picture in linear sRGB");
    }
    plugin.finish();
}

void set_sampler(Builder& builder, const Element& element) {
    Plugin plugin = builder.plugin(element);
    builder.scene.settings.spp = std::clamp(plugin.integer("sample_count", 4), 1, 1 << 20);
    builder.scene.settings.seed = std::max(plugin.integer("seed", 0), 0);
    plugin.ignore("jitter");
    plugin.ignore("dimension");
    plugin.ignore("scramble");
    plugin.finish();
    builder.honoured(plugin);
}

void place_camera(Builder& builder, Plugin& plugin, const glm::dmat4& to_world, scene::Camera& camera) {
    camera.position = glm::dvec3(to_world[3]);
    camera.direction = glm::dvec3(to_world[2]);
    camera.up = glm::dvec3(to_world[1]);
    if (!(glm::length(glm::cross(camera.direction, camera.up)) > 0.0)) {
        builder.error(plugin.position(), "the sensor's transform is singular");
        camera.direction = {0.0, 0.0, 1.0};
        camera.up = {0.0, 1.0, 0.0};
    } else if (glm::determinant(glm::dmat3(to_world)) < 0.0) {
        builder.context.report.approximated(fmt::format("{}: a mirroring transform", plugin.title()), "the picture is not mirrored",
                                            plugin.position());
    }
}

// From the whole film to the window.
void look_through(const Window& window, scene::Camera& camera) {
    const glm::dvec2 whole(window.whole), size(window.size), middle = glm::dvec2(window.from) + 0.5 * size;
    const double share = camera.fov_axis == scene::FovAxis::width ? size.x / whole.x : size.y / whole.y;
    camera.fov = glm::degrees(2.0 * std::atan(std::tan(glm::radians(camera.fov) / 2.0) * share));
    camera.extent *= share;
    const glm::dvec2 off = (middle - 0.5 * whole) / size;  // to the right and down
    camera.shift = camera.shift * whole / size + glm::dvec2(off.x, -off.y);
}

}  // namespace

FieldOfView field_of_view(Builder& builder, Plugin& plugin, double width, double height) {
    FieldOfView view;
    std::string axis = plugin.text("fov_axis", "x");
    if (plugin.has("fov")) {
        view.degrees = plugin.number("fov", 50.0, 1e-4, 179.9999);
    } else {
        // In millimetres, for a film of 36 x 24 mm.
        const std::string text = plugin.text("focal_length", "50mm");
        const double millimetres = parse_number(text.substr(0, text.find("mm"))).value_or(0.0);
        if (!(millimetres > 0.0)) {
            builder.error(plugin.position(), fmt::format("\"focal_length\": expected millimetres, as \"50mm\", found {}", quoted(text)));
            return view;
        }
        view.degrees = glm::degrees(2.0 * std::atan(0.5 * std::hypot(36.0, 24.0) / millimetres));
        axis = "diagonal";
    }
    if (axis == "smaller") {
        axis = width > height ? "y" : "x";
    } else if (axis == "larger") {
        axis = width > height ? "x" : "y";
    }
    if (axis == "diagonal") {
        const double half = std::tan(0.5 * glm::radians(view.degrees)) * width / std::hypot(width, height);
        view.degrees = glm::degrees(2.0 * std::atan(half));
        axis = "x";
    }
    if (axis != "x" && axis != "y") {
        builder.error(plugin.position(), fmt::format("\"fov_axis\" is {}: expected x, y, diagonal, smaller or larger", quoted(axis)));
    }
    view.by_height = axis == "y";
    return view;
}

void add_sensor(Builder& builder, const Element& element, bool first) {
    Plugin plugin = builder.plugin(element);
    const scene::RenderSettings before = builder.scene.settings;
    Window window{{768, 576}, {0, 0}, {768, 576}};
    for (const auto& [name, film] : plugin.children({"film"})) {
        window = window_of(builder, *film);
        set_film(builder, *film, window);
    }
    for (const auto& [name, sampler] : plugin.children({"sampler"})) {
        set_sampler(builder, *sampler);
    }
    for (const auto& [name, medium] : plugin.children({"medium"})) {
        builder.around_camera = first ? medium : builder.around_camera;
    }
    scene::Camera camera;
    camera.name = first ? "" : plugin.id();
    camera.source = plugin.position();
    const glm::dmat4 to_world = plugin.transform("to_world").value_or(glm::dmat4(1.0));
    place_camera(builder, plugin, to_world, camera);
    camera.focus_distance = plugin.number("focus_distance", 1.0);
    const std::string& type = plugin.type();
    bool known = true;
    if (type == "perspective" || type == "thinlens") {
        const FieldOfView view = field_of_view(builder, plugin, window.whole.x, window.whole.y);
        camera.fov = view.degrees;
        camera.fov_axis = view.by_height ? scene::FovAxis::height : scene::FovAxis::width;
        camera.shift = {plugin.number("principal_point_offset_x", 0.0), -plugin.number("principal_point_offset_y", 0.0)};
        if (type == "thinlens") {
            camera.aperture = 2.0 * plugin.number("aperture_radius", 0.0, 0.0, 1e9);
        }
    } else if (type == "orthographic" || type == "telecentric") {
        camera.projection = scene::Projection::orthographic;
        camera.extent = 2.0 * glm::length(glm::dvec3(to_world[0]));
        plugin.ignore("aperture_radius");
        known = type == "orthographic";
    } else if (type == "spherical") {
        camera.projection = scene::Projection::panorama;
    } else {
        known = false;
        camera.fov = 50.0;
    }
    if (window.size != window.whole && camera.projection != scene::Projection::panorama) {
        look_through(window, camera);
    } else if (window.size != window.whole) {
        builder.context.report.dropped(fmt::format("{}: a crop window", plugin.title()), "the whole panorama is squeezed into it",
                                       plugin.position());
    }
    for (const std::string_view name : {"near_clip", "far_clip", "shutter_open", "shutter_close", "srf"}) {
        plugin.ignore(name);
    }
    if (known) {
        builder.honoured(plugin);
    } else {
        builder.approximated(plugin, type == "telecentric" ? "an orthographic camera" : "a perspective camera");
    }
    plugin.finish();
    builder.scene.cameras.push_back(camera);
    if (!first) {
        builder.scene.settings = before;
    }
}

void set_integrator(Builder& builder, const Element& element) {
    const Nesting nesting(builder, element.position);
    Plugin plugin = builder.plugin(element);
    const auto inner = plugin.children({"integrator"});
    scene::RenderSettings& settings = builder.scene.settings;
    settings.integrator = "path";
    if (!inner.empty() && !nesting.too_deep()) {
        // "aov", "moment" and "stokes" add to what another one renders.
        plugin.ignore("aovs");
        plugin.finish();
        builder.honoured(plugin);
        set_integrator(builder, *inner.front().element);
        return;
    }
    constexpr int endless = 1024;
    const std::string& type = plugin.type();
    if (type == "direct") {
        settings.bounces = 1;
        plugin.ignore("shading_samples");
        plugin.ignore("emitter_samples");
        plugin.ignore("bsdf_samples");
    } else {
        const int depth = plugin.integer("max_depth", -1);
        settings.bounces = depth < 0 ? endless : std::clamp(depth - 1, 0, endless);
    }
    plugin.ignore("rr_depth");
    if (plugin.flag("hide_emitters", false)) {
        builder.scene.background.visible = false;
        builder.context.report.approximated(fmt::format("{}: \"hide_emitters\"", plugin.title()),
                                            "the surroundings are not seen, shapes that shine are", plugin.position());
    }
    plugin.ignore("strict_normals");
    if (type == "path" || type == "direct") {
        builder.honoured(plugin);
    } else {
        builder.approximated(plugin, "the path integrator");
    }
    plugin.finish();
}

}  // namespace lancer::mitsuba
