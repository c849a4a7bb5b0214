// The scene's materials: what pbrt puts together at each shape from a material, an area light and the media on both sides.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lancer/import/pbrt/graphics_state.h"
#include "lancer/import/pbrt/textures.h"
#include "lancer/scene/scene.h"

namespace lancer::pbrt {

class MaterialTable {
public:
    MaterialTable(ImportContext& context, const Textures& textures) : context_(context), textures_(textures) {}

    void set_version3(bool version3) { version3_ = version3; }

    int add(Recipe material);
    void add_named(const std::string& name, Recipe material);
    int add_area_light(Recipe light);
    void add_medium(const std::string& name, Recipe medium, const glm::dmat4& to_scene) {
        media_.insert_or_assign(name, WrittenMedium{std::move(medium), to_scene, {}, false});
    }

    // What is around the camera, where no body around it is filled with that.
    void surround_camera(const std::string& medium, scene::Scene& scene, double brightness);

    struct Choice {
        MaterialChoice material;
        int area_light = -1;
        std::string inside;
        std::string outside;
        std::string_view alpha = {};  // of the shape, as written

        auto operator<=>(const Choice&) const = default;
    };

    // The number that the material will have in the scene. `area`: of the shape in square metres, where it shines.
    int material_for(Choice choice, const Recipe& shape, double area);

    // Makes all of them; named ones may have been defined after their use. `brightness` is a factor for all light.
    void finish(scene::Scene& scene, double brightness);

private:
    struct Wanted {
        Choice choice;
        double area = 0.0;
        Recipe shape;  // the first one
    };

    const Recipe* find(const MaterialChoice& choice, const SourcePosition& position) const;
    scene::Material built(const Recipe* recipe, const SourcePosition& position, scene::Scene& scene);
    int part_of_mix(const std::string& name, const Recipe& asking, scene::Scene& scene);
    std::optional<scene::Emission> emission(const Wanted& wanted, double brightness) const;
    std::optional<int> medium(const std::string& name, const SourcePosition& position, scene::Scene& scene, double brightness);
    void fill_with_medium(const Wanted& wanted, scene::Material& material, scene::Scene& scene, double brightness);

    struct WrittenMedium {
        Recipe recipe;
        glm::dmat4 to_scene;
        std::optional<int> number;  // in the scene
        bool built;
    };

    ImportContext& context_;
    const Textures& textures_;
    bool version3_ = false;
    std::vector<Recipe> recipes_;
    std::map<std::string, std::vector<int>, std::less<>> named_;  // in the order of their definitions
    std::vector<Recipe> area_lights_;
    std::map<std::string, WrittenMedium, std::less<>> media_;
    std::vector<Wanted> wanted_;
    std::map<std::pair<Choice, double>, int> numbers_;
    std::map<const Recipe*, int> parts_;      // of mixes: numbers in the scene
    std::vector<const Recipe*> being_built_;  // none may be a part of itself
};

}  // namespace lancer::pbrt
