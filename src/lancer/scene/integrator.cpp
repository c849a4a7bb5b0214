#include "lancer/scene/integrator.h"

#include <algorithm>
#include <variant>

namespace lancer::scene {

namespace {

// Facets that spread light less than this throw patterns of light that paths from the camera hardly ever find.
constexpr double shiny = 0.15;  // roughness

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

IntegratorChoice suit(const Scene& scene) {
    if (!is_physical_scene(scene)) {
        return {"whitted", "nothing in the scene follows physics"};
    }
    const bool throws = std::any_of(scene.materials.begin(), scene.materials.end(),
                                    [](const Material& material) { return std::visit(ThrowsLight{}, material.model); });
    if (!throws) {
        return {"path", "no glass or mirror throws light on other surfaces"};
    }
    if (scene.lights.empty()) {
        return {"path", "its lamps can be met by chance"};
    }
    const std::vector<Obstacle> against = obstacles(scene, "vcm");
    if (!against.empty()) {
        return {"path", "vcm, which would find the light that glass and mirrors throw, can't: " + against.front().what};
    }
    if (!scene.settings.aovs.empty() || scene.settings.spectral_bins > 0) {
        return {"path", "AOVs and spectra are its own"};
    }
    return {"vcm", "glass or mirrors throw the light of lights without size, which paths from the camera alone never find"};
}

}  // namespace

bool starts_at_lamps(const std::string& integrator) { return integrator == "light" || integrator == "bdpt" || integrator == "vcm"; }

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
    for (const Material& material : scene.materials) {
        if (std::holds_alternative<NullMaterial>(material.model) || material.interior || material.priority != 0) {
            found.push_back({"media that scatter, and bodies that overlap by priority, are followed by path only", material.position});
            break;
        }
    }
    if (scene.medium) {
        found.push_back({"media that scatter are followed by path only", {scene.file, 0, 0}});
    }
    const RenderSettings& settings = scene.settings;
    if (settings.diffuse_bounces || settings.glossy_bounces || settings.transmission_bounces) {
        found.push_back({"bounces are limited by kind", {scene.file, 0, 0}});
    }
    if (integrator == "light") {
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
