#include "lancer/scene/lamps.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <variant>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "lancer/base/overloaded.h"
#include "lancer/scene/bounds.h"

namespace lancer::scene {

namespace {

constexpr double small = 0.03;  // of the scene's size

// Scenes of more parts are not looked through: whoever has so many waits for other things, but not for this.
constexpr int most_parts = 100'000;
constexpr std::size_t most_lamps = 64;
constexpr std::size_t most_triangles = 100'000;

double diagonal(const Bounds& box) { return box.empty() ? 0.0 : glm::length(box.high - box.low); }

double brightness(const Color& color) {
    return color.spectrum ? color.spectrum->scale * color.spectrum->luminance.value_or(1.0)
                          : (color.rgb.r + color.rgb.g + color.rgb.b) / 3.0;
}

double brightness(const Emission& emission) {
    const Color* color = std::get_if<Color>(&emission.radiance);
    return emission.strength * (color != nullptr ? brightness(*color) : 1.0);
}

// The surfaces that shine.
class Shining {
public:
    explicit Shining(const Scene& scene) : scene_(scene) { look(scene.objects, scene.placements, glm::dmat4(1.0), std::nullopt); }

    bool found_all() const { return parts_ <= most_parts; }
    double largest() const { return largest_; }
    double light() const { return light_; }  // radiance times area, about

private:
    void look(const std::vector<Object>& objects, const std::vector<Placement>& placements, const glm::dmat4& to_world,
              std::optional<int> instead) {
        for (const Object& object : objects) {
            const Material& material = scene_.materials[static_cast<std::size_t>(instead.value_or(object.material))];
            if (++parts_ <= most_parts && material.emission) {
                const double size = diagonal(transform(to_world * object.to_parent, bounds(object.shape)));
                largest_ = std::max(largest_, size);
                light_ += brightness(*material.emission) * size * size;
            }
        }
        for (const Placement& placement : placements) {
            if (++parts_ <= most_parts) {
                const Group& group = scene_.groups[static_cast<std::size_t>(placement.group)];
                look(group.objects, group.placements, to_world * placement.to_parent, instead ? instead : placement.material);
            }
        }
    }

    const Scene& scene_;
    int parts_ = 0;
    double largest_ = 0.0;
    double light_ = 0.0;
};

std::optional<glm::dvec3> place_of(const Light& light) {
    return std::visit(Overloaded{[](const DirectionalLight&) { return std::optional<glm::dvec3>(); },
                                 [](const auto& lamp) { return std::optional<glm::dvec3>(lamp.position); }},
                      light.model);
}

double distance_to(const Object& object, const glm::dvec3& place) {
    constexpr double nowhere = std::numeric_limits<double>::infinity();
    if (const Plane* plane = std::get_if<Plane>(&object.shape)) {
        const glm::dvec3 point(object.to_parent * glm::dvec4(plane->point, 1.0));
        const glm::dvec3 normal = glm::inverse(glm::transpose(glm::dmat3(object.to_parent))) * plane->normal;
        return std::abs(glm::dot(place - point, glm::normalize(normal)));
    }
    if (const Mesh* mesh = std::get_if<Mesh>(&object.shape); mesh != nullptr && mesh->data->triangles.size() > most_triangles) {
        return nowhere;
    }
    const Bounds box = transform(object.to_parent, bounds(object.shape));
    const double distance = glm::length(glm::max(glm::max(box.low - place, place - box.high), glm::dvec3(0.0)));
    return box.empty() || distance == 0.0 ? nowhere : distance;
}

}  // namespace

bool has_small_lamps_only(const Scene& scene) {
    const Background& around = scene.background;
    const Shining shining(scene);
    if (shining.largest() == 0.0 || !shining.found_all() || around.image || around.sky) {
        return false;
    }
    const double size = diagonal(bounds(scene));
    const double sky = around.strength * std::max({brightness(around.zenith), brightness(around.horizon), brightness(around.nadir)});
    return shining.largest() < small * size && shining.light() > sky * size * size;
}

double nearest_to_lamp(const Scene& scene) {
    double nearest = std::numeric_limits<double>::infinity();
    if (scene.lights.size() > most_lamps || scene.objects.size() > most_parts / most_lamps) {
        return nearest;
    }
    for (const Light& light : scene.lights) {
        if (const auto place = place_of(light)) {
            for (const Object& object : scene.objects) {
                const double far = glm::length(scene.cameras.front().position - *place);
                nearest = far > 0.0 ? std::min(nearest, distance_to(object, *place) / far) : nearest;
            }
        }
    }
    return nearest;
}

}  // namespace lancer::scene
