#include "lancer/world/names.h"

#include <array>
#include <map>
#include <string>

namespace lancer {

const char* kind_of(const scene::Shape& shape) {
    static constexpr std::array<const char*, 7> kinds = {"sphere", "box", "plane", "disk", "cylinder", "cone", "mesh"};
    static_assert(std::variant_size_v<scene::Shape> == kinds.size(), "each kind of shape has its word");
    return kinds.at(shape.index());
}

void compile_names(const scene::Scene& scene, const std::vector<FlatObject>& flat, World& world) {
    // The same object placed several times has one name.
    std::map<const scene::Object*, std::string> known;
    std::map<std::string, int> numbers;
    for (const FlatObject& object : flat) {
        std::string& name = known[object.object];
        if (name.empty()) {
            const std::string kind = kind_of(object.object->shape);
            const int number = ++numbers[kind];
            name = object.object->name.empty() ? kind + " " + std::to_string(number) : object.object->name;
        }
        world.names.push_back(name);
    }
    for (const scene::Material& material : scene.materials) {
        world.material_names.push_back(!material.name.empty() ? material.name
                                       : material.is_default  ? "default"
                                                              : "material " + std::to_string(world.material_names.size() + 1));
    }
}

}  // namespace lancer
