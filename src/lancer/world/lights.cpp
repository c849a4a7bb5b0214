#include "lancer/world/lights.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "lancer/world/spectra.h"

namespace lancer {

SpotCone spot_cone(const scene::SpotLight& spot) {
    SpotCone cone;
    cone.cos_outer = static_cast<float>(std::cos(glm::radians(spot.angle)));
    const auto inner = static_cast<float>(std::cos(glm::radians(std::max(0.0, spot.angle - spot.falloff))));
    cone.cos_inner = std::max(inner, std::nextafter(cone.cos_outer, 2.0f));
    return cone;
}

int fade_of(const scene::SpotLight& spot) {
    switch (spot.fade) {
        case scene::SpotFade::even:
            return kernel::FADE_EVEN;
        case scene::SpotFade::square:
            return kernel::FADE_SQUARE;
        default:
            return kernel::FADE_SMOOTH;
    }
}

kernel::LightRecord light_record(const scene::Light& light) {
    kernel::LightRecord record{};
    record.radiance = kernel::vec3(emitted(light.color) * light.intensity);
    record.direction = kernel::vec3(0.0f, -1.0f, 0.0f);
    if (const auto* point = std::get_if<scene::PointLight>(&light.model)) {
        record.kind = kernel::LIGHT_POINT;
        record.position = kernel::vec3(point->position);
    } else if (const auto* spot = std::get_if<scene::SpotLight>(&light.model)) {
        record.kind = kernel::LIGHT_SPOT;
        record.position = kernel::vec3(spot->position);
        record.direction = kernel::vec3(glm::normalize(spot->direction));
        const SpotCone cone = spot_cone(*spot);
        record.cos_outer = cone.cos_outer;
        record.cos_inner = cone.cos_inner;
        record.fade = fade_of(*spot);
    } else if (const auto* sun = std::get_if<scene::DirectionalLight>(&light.model)) {
        record.kind = kernel::LIGHT_DIRECTIONAL;
        record.direction = kernel::vec3(glm::normalize(sun->direction));
    }
    return record;
}

}  // namespace lancer
