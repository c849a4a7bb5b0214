#include "lancer/scene/integrator.h"

#include <algorithm>
#include <variant>

#include "lancer/scene/lamps.h"

namespace lancer::scene {

namespace {

// Facets that spread light less than this throw patterns of light that paths from the camera hardly ever find.
constexpr double shiny = 0.15;  // roughness

// What stands so close to a lamp without size, in parts of the distance of the camera from it, is a bright spot that paths hardly ever find.
constexpr double close = 0.015;

// With more bounces in media than these, what joints cost grows as their square.
constexpr int most_joined = 32;

bool is_physical_scene(const Scene& scene) {
    return std::any_of(scene.materials.begin(), scene.materials.end(), is_physical) ||
           std::any_of(scene.lights.begin(), scene.lights.end(), [](const Light& light) { return light.power.has_value(); }) ||
           scene.background.sky.has_value();
}

bool is_shiny(const Value& roughness) { return !roughness.texture && roughness.number < shiny; }

// Whether the material throws light on: bundles it, bent or mirrored.
struct ThrowsLight {
    bool operator()(const DielectricMaterial& m) const { return !m.thin && is_shiny(m.roughness); }
    bool operator()(const ConductorMaterial& m) const { return is_shiny(m.roughness); }
    bool operator()(const PrincipledMaterial& m) const {
        return is_shiny(m.roughness) && ((m.transmission.most() > 0.5 && !m.thin) || m.metalness.most() > 0.5);
    }
    template <class Other>
    bool operator()(const Other&) const {
        return false;
    }
};

bool has_plane(const std::vector<Object>& objects) {
    return std::any_of(objects.begin(), objects.end(), [](const Object& object) { return std::holds_alternative<Plane>(object.shape); });
}

bool has_plane(const Scene& scene) {
    return has_plane(scene.objects) ||
           std::any_of(scene.groups.begin(), scene.groups.end(), [](const Group& group) { return has_plane(group.objects); });
}

bool is_bright(const Color& color) { return color.spectrum != nullptr || color.rgb.r > 0.0 || color.rgb.g > 0.0 || color.rgb.b > 0.0; }

bool has_sky(const Scene& scene) {
    const Background& b = scene.background;
    return b.image.has_value() || is_bright(b.zenith) || is_bright(b.horizon) || is_bright(b.nadir);
}

// `path` where what suits better can't render the scene.
IntegratorChoice unless_it_cant(const Scene& scene, const std::string& name, const std::string& why) {
    if (!scene.media.empty() && scene.settings.bounces.value_or(0) > most_joined) {
        return {"path", "of paths that media scatter so often, joining each vertex with each other costs more than it brings"};
    }
    if (const std::vector<Obstacle> against = obstacles(scene, name); !against.empty()) {
        return {"path", name + ", which would suit it better, can't: " + against.front().what};
    }
    if (const std::string lacks = lacking(scene, name); !lacks.empty()) {
        return {"path", name + ", which would suit it better, does not make " + lacks};
    }
    return {name, why};
}

IntegratorChoice suit(const Scene& scene) {
    if (!is_physical_scene(scene)) {
        return {"whitted", "nothing in the scene follows physics"};
    }
    const bool throws = std::any_of(scene.materials.begin(), scene.materials.end(),
                                    [](const Material& material) { return std::visit(ThrowsLight{}, material.model); });
    if (!throws) {
        return nearest_to_lamp(scene) < close
                   ? unless_it_cant(scene, "bdpt",
                                    "what stands close to a lamp without size lights the rest, and paths from the camera hardly meet it")
                   : IntegratorChoice{"path", "no glass or mirror throws light on other surfaces"};
    }
    if (scene.lights.empty() && !has_small_lamps_only(scene)) {
        return {"path", "its lamps can be met by chance"};
    }
    return unless_it_cant(scene, "vcm",
                          scene.lights.empty()
                              ? "glass or mirrors throw the light of small lamps, which paths from the camera alone hardly ever find"
                              : "glass or mirrors throw the light of lights without size, which paths from the camera alone never find");
}

}  // namespace

bool starts_at_lamps(const std::string& integrator) { return integrator == "light" || integrator == "bdpt" || integrator == "vcm"; }

std::string lacking(const Scene& scene, const std::string& integrator) {
    if (!starts_at_lamps(integrator)) {
        return "";
    }
    if (scene.settings.spectral_bins > 0) {
        return "spectral bins";
    }
    for (const std::string& aov : scene.settings.aovs) {
        // Of light that falls anywhere nobody knows how often it was scattered, nor what it would have been in another run. Paths of light alone see
        // nothing first.
        const bool of_light = aov == "direct" || aov == "indirect" || aov == "variance" || aov == "interval";
        if (of_light || (integrator == "light" && aov != "samples")) {
            return "the AOV " + aov;
        }
    }
    return "";
}

IntegratorChoice choose_integrator(const Scene& scene) {
    if (scene.settings.integrator != "auto") {
        return {scene.settings.integrator, "the scene or the command line says so"};
    }
    return suit(scene);
}

std::vector<Obstacle> obstacles(const Scene& scene, const std::string& integrator) {
    std::vector<Obstacle> found;
    if (!starts_at_lamps(integrator)) {
        return found;
    }
    for (const Material& material : scene.materials) {
        if (material.open_behind) {
            found.push_back(
                {"a material that is not there when seen from within looks different to light than to a camera", material.position});
        }
    }
    const RenderSettings& settings = scene.settings;
    if (settings.diffuse_bounces || settings.glossy_bounces || settings.transmission_bounces) {
        found.push_back({"bounces are limited by kind", {scene.file, 0, 0}});
    }
    if (integrator == "light") {
        for (const Medium& medium : scene.media) {
            if (is_bright(medium.emission) && medium.emission_strength > 0.0) {
                found.push_back({"light that a medium gives off by itself is found by paths from the camera only", medium.position});
            }
        }
        const bool far = has_sky(scene) || std::any_of(scene.lights.begin(), scene.lights.end(), [](const Light& light) {
                             return std::holds_alternative<DirectionalLight>(light.model);
                         });
        if (far && has_plane(scene)) {
            found.push_back({"far light on an infinite plane has no place to begin", {scene.file, 0, 0}});
        }
    }
    return found;
}

std::string chosen_integrator(const Scene& scene) { return choose_integrator(scene).name; }

int bounces_of(const Scene& scene) {
    const std::string integrator = chosen_integrator(scene);
    return scene.settings.bounces.value_or(integrator == "whitted" ? 5 : integrator == "direct" ? 1 : 16);
}

bool follows_paths(const Scene& scene) { return chosen_integrator(scene) != "whitted"; }

}  // namespace lancer::scene
