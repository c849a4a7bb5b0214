#include <algorithm>

#include "lancer/scene/scene.h"

namespace lancer::scene {

std::string chosen_integrator(const Scene& scene) {
    if (scene.settings.integrator != "auto") {
        return scene.settings.integrator;
    }
    const bool physical =
        std::any_of(scene.materials.begin(), scene.materials.end(), is_physical) ||
        std::any_of(scene.lights.begin(), scene.lights.end(), [](const Light& light) { return light.power.has_value(); }) ||
        scene.background.sky.has_value();
    return physical ? "path" : "whitted";
}

int bounces_of(const Scene& scene) {
    const std::string integrator = chosen_integrator(scene);
    return scene.settings.bounces.value_or(integrator == "whitted" ? 5 : integrator == "direct" ? 1 : 16);
}

bool follows_paths(const Scene& scene) { return chosen_integrator(scene) != "whitted"; }

}  // namespace lancer::scene
