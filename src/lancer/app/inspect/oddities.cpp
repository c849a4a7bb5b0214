#include "lancer/app/inspect/oddities.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <variant>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "lancer/app/inspect/media_oddities.h"
#include "lancer/app/inspect/mesh_facts.h"
#include "lancer/scene/bounds.h"
#include "lancer/world/flatten.h"
#include "lancer/world/spectra.h"

namespace lancer::app {

namespace {

constexpr double largest_scene = 1000.0;  // metres across; more is a landscape, or millimetres
constexpr double smallest_scene = 0.002;

bool lies_in(const scene::Sphere& sphere, const glm::dvec3& p) { return glm::distance(sphere.center, p) < sphere.radius; }

bool lies_in(const scene::Box& box, const glm::dvec3& p) {
    return glm::all(glm::greaterThan(p, box.min)) && glm::all(glm::lessThan(p, box.max));
}

bool lies_in_round(const glm::dvec3& from, const glm::dvec3& to, double radius, double top_radius, const glm::dvec3& p) {
    const glm::dvec3 axis = to - from;
    const double share = glm::dot(p - from, axis) / glm::dot(axis, axis);
    return share > 0.0 && share < 1.0 && glm::distance(p, from + axis * share) < radius + (top_radius - radius) * share;
}

bool lies_in(const scene::Cylinder& c, const glm::dvec3& p) { return c.capped && lies_in_round(c.from, c.to, c.radius, c.radius, p); }
bool lies_in(const scene::Cone& c, const glm::dvec3& p) { return c.capped && lies_in_round(c.from, c.to, c.radius, c.top_radius, p); }
bool lies_in(const scene::Plane&, const glm::dvec3&) { return false; }
bool lies_in(const scene::Disk&, const glm::dvec3&) { return false; }

class Oddities {
public:
    Oddities(const scene::Scene& scene, Diagnostics& diagnostics) : scene_(scene), diagnostics_(diagnostics), objects_(flatten(scene)) {}

    void find() {
        for (const FlatObject& flat : objects_) {
            look_at_mesh(flat);
        }
        for (const scene::Material& material : scene_.materials) {
            look_at_material(material);
        }
        for (const scene::Light& light : scene_.lights) {
            look_at_light(light);
        }
        look_at_cameras();
        look_at_size();
    }

private:
    const scene::Material& material_of(const FlatObject& flat) const { return scene_.materials[static_cast<std::size_t>(flat.material)]; }

    static bool is_clear(const scene::Material& material) {
        if (const auto* glass = std::get_if<scene::DielectricMaterial>(&material.model)) {
            return !glass->thin;
        }
        if (const auto* principled = std::get_if<scene::PrincipledMaterial>(&material.model)) {
            return principled->transmission.most() > 0.0 && !principled->thin;
        }
        if (const auto* burley = std::get_if<scene::BurleyMaterial>(&material.model)) {
            return burley->transmission.most() > 0.0 && !burley->thin;
        }
        if (const auto* whitted = std::get_if<scene::WhittedMaterial>(&material.model)) {
            return whitted->transparency > 0.0;
        }
        return std::holds_alternative<scene::NullMaterial>(material.model);
    }

    const MeshFacts& facts(const scene::TriangleMesh& mesh) {
        const auto [found, is_new] = facts_.try_emplace(&mesh);
        if (is_new) {
            found->second = examine(mesh);
        }
        return found->second;
    }

    static std::string name_of(const scene::Object& object) { return object.name.empty() ? "a mesh" : "\"" + object.name + "\""; }

    // Each object once, however often it is placed.
    void look_at_mesh(const FlatObject& flat) {
        const auto* mesh = std::get_if<scene::Mesh>(&flat.object->shape);
        if (mesh == nullptr || !told_.insert(flat.object).second) {
            return;
        }
        const MeshFacts& facts = this->facts(*mesh->data);
        if (facts.closed && facts.volume < 0.0) {
            diagnostics_.warning(flat.object->position, fmt::format("the faces of {} point inwards", name_of(*flat.object)));
        } else if (!facts.closed && is_clear(material_of(flat))) {
            diagnostics_.warning(flat.object->position,
                                 fmt::format("{} is a clear body with holes: light that enters may never leave it", name_of(*flat.object)));
        }
    }

    template <class Color>
    void look_at_color(const Color& color, const scene::Material& material) {
        const auto* plain = std::get_if<scene::Color>(&color);
        if (plain != nullptr && !plain->spectrum && std::max({plain->rgb.x, plain->rgb.y, plain->rgb.z}) > 1.0) {
            diagnostics_.warning(material.position,
                                 fmt::format("material {} reflects more light than it gets: its colour is above 1", said(material.name)));
        }
    }

    static std::string said(const std::string& name) { return name.empty() ? "without a name" : "\"" + name + "\""; }

    void look_at_material(const scene::Material& material) {
        std::visit(
            [&](const auto& model) {
                if constexpr (requires { model.color; }) {
                    look_at_color(model.color, material);
                }
            },
            material.model);
        if (material.emission && !(material.emission->strength > 0.0)) {
            diagnostics_.warning(material.position, fmt::format("material {} shines with a strength of 0", said(material.name)));
        }
    }

    // The opaque closed body around a point, or null.
    const FlatObject* body_around(const glm::dvec3& point) {
        for (const FlatObject& flat : objects_) {
            const glm::dvec3 local(glm::inverse(flat.to_world) * glm::dvec4(point, 1.0));
            const bool inside = std::visit(
                [&](const auto& shape) {
                    if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, scene::Mesh>) {
                        const MeshFacts& known = facts(*shape.data);
                        const bool is_near = glm::all(glm::greaterThan(local, glm::dvec3(known.low))) &&
                                             glm::all(glm::lessThan(local, glm::dvec3(known.high)));
                        return is_near && known.closed && lies_inside(*shape.data, local);
                    } else {
                        return lies_in(shape, local);
                    }
                },
                flat.object->shape);
            if (inside && !is_clear(material_of(flat))) {
                return &flat;
            }
        }
        return nullptr;
    }

    // Nothing: it is infinitely far away.
    static std::optional<glm::dvec3> place_of(const scene::Light& light) {
        return std::visit(
            [](const auto& model) -> std::optional<glm::dvec3> {
                if constexpr (std::is_same_v<std::decay_t<decltype(model)>, scene::DirectionalLight>) {
                    return std::nullopt;
                } else {
                    return model.position;
                }
            },
            light.model);
    }

    void look_at_light(const scene::Light& light) {
        const scene::Rgb power = light.power ? emitted(*light.power) : emitted(light.color) * light.intensity;
        if (!(std::max({power.x, power.y, power.z}) > 0.0)) {
            diagnostics_.warning(light.position, fmt::format("light {} gives no light", said(light.name)));
        }
        const std::optional<glm::dvec3> place = place_of(light);
        if (!place) {
            return;
        }
        const FlatObject* body = body_around(*place);
        // In a room somebody is there to see its light.
        const bool room = std::any_of(scene_.cameras.begin(), scene_.cameras.end(),
                                      [&](const scene::Camera& camera) { return body_around(camera.position) == body; });
        if (body != nullptr && !room) {
            diagnostics_.warning(light.position, fmt::format("light {} is shut in by an opaque body", said(light.name)));
        }
    }

    void look_at_cameras() {
        for (const scene::Camera& camera : scene_.cameras) {
            const FlatObject* body = body_around(camera.position);
            // A room is a body around its cameras: seen from within it is lit.
            const bool room = body != nullptr && std::any_of(scene_.lights.begin(), scene_.lights.end(), [&](const scene::Light& light) {
                                  const std::optional<glm::dvec3> place = place_of(light);
                                  return place && body_around(*place) == body;
                              });
            if (body != nullptr && !room) {
                diagnostics_.warning(camera.source, fmt::format("camera {} is inside of an opaque body", said(camera.name)));
            }
        }
    }

    void look_at_size() {
        const scene::Bounds all = scene::bounds(scene_);
        if (all.empty()) {
            return;
        }
        const double across = glm::distance(all.low, all.high);
        if (across > largest_scene) {
            diagnostics_.warning({scene_.file, 0, 0},
                                 fmt::format("the scene is {:.3g} m across: were millimetres taken for metres?", across));
        } else if (across < smallest_scene) {
            diagnostics_.warning({scene_.file, 0, 0},
                                 fmt::format("the scene is {:.3g} m across: were metres taken for millimetres?", across));
        }
    }

    const scene::Scene& scene_;
    Diagnostics& diagnostics_;
    std::vector<FlatObject> objects_;
    std::map<const scene::TriangleMesh*, MeshFacts> facts_;
    std::set<const scene::Object*> told_;
};

}  // namespace

void find_oddities(const scene::Scene& scene, Diagnostics& diagnostics) {
    Oddities(scene, diagnostics).find();
    find_media_oddities(scene, diagnostics);
}

}  // namespace lancer::app
