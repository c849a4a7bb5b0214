#include "lancer/world/flatten.h"

#include <optional>

namespace lancer {

namespace {

void add_objects(const std::vector<scene::Object>& objects, const glm::dmat4& to_world, std::optional<int> material,
                 std::vector<FlatObject>& flat) {
    for (const scene::Object& object : objects) {
        flat.push_back({&object, to_world * object.to_parent, material.value_or(object.material)});
    }
}

// Groups only place groups that come before them, so this ends; readers bound the depth.
void add_placement(const scene::Scene& scene, const scene::Placement& placement, const glm::dmat4& to_world, std::optional<int> material,
                   std::vector<FlatObject>& flat) {
    const scene::Group& group = scene.groups[static_cast<std::size_t>(placement.group)];
    const glm::dmat4 map = to_world * placement.to_parent;
    const std::optional<int> override_material = material ? material : placement.material;  // the outermost wins
    add_objects(group.objects, map, override_material, flat);
    for (const scene::Placement& inner : group.placements) {
        add_placement(scene, inner, map, override_material, flat);
    }
}

}  // namespace

std::vector<FlatObject> flatten(const scene::Scene& scene) {
    std::vector<FlatObject> flat;
    add_objects(scene.objects, glm::dmat4(1.0), std::nullopt, flat);
    for (const scene::Placement& placement : scene.placements) {
        add_placement(scene, placement, glm::dmat4(1.0), std::nullopt, flat);
    }
    return flat;
}

}  // namespace lancer
