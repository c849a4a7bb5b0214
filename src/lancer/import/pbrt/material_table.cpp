#include "lancer/import/pbrt/material_table.h"

#include <algorithm>
#include <numbers>

#include <fmt/format.h>

#include "lancer/import/pbrt/light_power.h"
#include "lancer/import/pbrt/materials.h"
#include "lancer/import/pbrt/media.h"

namespace lancer::pbrt {

int MaterialTable::add(Recipe material) {
    recipes_.push_back(std::move(material));
    return static_cast<int>(recipes_.size()) - 1;
}

void MaterialTable::add_named(const std::string& name, Recipe material) { named_[name].push_back(add(std::move(material))); }

int MaterialTable::add_area_light(Recipe light) {
    area_lights_.push_back(std::move(light));
    return static_cast<int>(area_lights_.size()) - 1;
}

int MaterialTable::material_for(Choice choice, const Recipe& shape, double area) {
    const Parameter* alpha = shape.parameters.find("alpha");
    choice.alpha = alpha != nullptr ? alpha->values : std::string_view();
    // Only of a light with a total power the brightness depends on the area.
    const bool has_power = choice.area_light >= 0 && area_lights_[static_cast<std::size_t>(choice.area_light)].parameters.has("power");
    const auto [found, is_new] = numbers_.try_emplace(std::make_pair(choice, has_power ? area : 0.0), static_cast<int>(wanted_.size()));
    if (is_new) {
        wanted_.push_back({choice, area, shape});
    }
    return found->second;
}

const Recipe* MaterialTable::find(const MaterialChoice& choice, const SourcePosition& position) const {
    if (choice.recipe >= 0) {
        return &recipes_[static_cast<std::size_t>(choice.recipe)];
    }
    if (choice.name.empty()) {
        return nullptr;
    }
    const auto found = named_.find(choice.name);
    if (found == named_.end()) {
        std::vector<std::string> known;
        for (const auto& [name, recipes] : named_) {
            known.push_back(name);
        }
        context_.diagnostics.warning(position, fmt::format("there is no material \"{}\": a grey diffuse one stands for it{}", choice.name,
                                                           did_you_mean(choice.name, known)));
        context_.report.dropped(fmt::format("NamedMaterial \"{}\"", choice.name), "there is no such material", position);
        return nullptr;
    }
    const Recipe* best = &recipes_[static_cast<std::size_t>(found->second.front())];
    for (const int number : found->second) {
        const Recipe& recipe = recipes_[static_cast<std::size_t>(number)];
        best = recipe.sequence < choice.sequence ? &recipe : best;
    }
    return best;
}

std::optional<scene::Emission> MaterialTable::emission(const Wanted& wanted, double brightness) const {
    if (wanted.choice.area_light < 0) {
        return std::nullopt;
    }
    const Recipe& light = area_lights_[static_cast<std::size_t>(wanted.choice.area_light)];
    const Parameters& parameters = light.parameters;
    if (light.type != "diffuse" && !(version3_ && light.type == "area")) {
        context_.diagnostics.error(parameters.position(), "the only area light is \"diffuse\"");
        return std::nullopt;
    }
    scene::Emission emission;
    const LightColor color = read_light_color(light, "L", version3_);
    emission.radiance = color.color;
    emission.strength = color.scale * brightness;
    emission.both_sides = parameters.boolean("twosided", false);
    if (const auto power = parameters.number("power"); power && *power > 0.0) {
        const double sides = emission.both_sides ? 2.0 : 1.0;
        emission.strength *= *power / (std::numbers::pi * wanted.area * sides);
    }
    if (parameters.has("filename")) {
        context_.report.approximated(parameters.owner() + " with \"filename\"", "the same light everywhere", parameters.position());
    }
    parameters.pass_over({"nsamples", "samples"});
    context_.report.honoured(parameters.owner(), parameters.position());
    return emission;
}

std::optional<int> MaterialTable::medium(const std::string& name, const SourcePosition& position, scene::Scene& scene, double brightness) {
    const auto found = media_.find(name);
    if (found == media_.end()) {
        std::vector<std::string> known;
        for (const auto& [other, medium] : media_) {
            known.push_back(other);
        }
        context_.diagnostics.warning(position,
                                     fmt::format("there is no medium \"{}\": nothing stands for it{}", name, did_you_mean(name, known)));
        context_.report.dropped(fmt::format("MediumInterface \"{}\"", name), "there is no such medium", position);
        return std::nullopt;
    }
    WrittenMedium& written = found->second;
    if (!written.built) {
        written.built = true;
        if (auto medium = build_medium(written.recipe, name, written.to_scene, brightness)) {
            written.number = static_cast<int>(scene.media.size());
            scene.media.push_back(std::move(*medium));
        }
        written.recipe.parameters.warn_of_unused();
    }
    return written.number;
}

// Interfaces, and bodies that light enters. Others only tell what is around them, and that is told by the borders that light has passed.
void MaterialTable::fill_with_medium(const Wanted& wanted, scene::Material& material, scene::Scene& scene, double brightness) {
    const bool is_interface = material.opacity.number == 0.0 && !material.opacity.texture;
    const auto* glass = std::get_if<scene::DielectricMaterial>(&material.model);
    const bool is_body = is_interface || (glass != nullptr && !glass->thin);
    const std::string& inside = wanted.choice.inside;
    if (is_interface && !(inside.empty() && wanted.choice.outside.empty())) {
        material.model = scene::NullMaterial{};
        material.opacity = 1.0;
    }
    if (is_body && !inside.empty() && inside != wanted.choice.outside) {
        material.interior = medium(inside, wanted.shape.parameters.position(), scene, brightness);
    }
}

void MaterialTable::surround_camera(const std::string& name, scene::Scene& scene, double brightness) {
    if (name.empty()) {
        return;
    }
    const std::optional<int> number = medium(name, {context_.path, 0, 0}, scene, brightness);
    const bool is_inside = std::any_of(scene.materials.begin(), scene.materials.end(),
                                       [&](const scene::Material& m) { return number && m.interior == number; });
    if (!is_inside) {
        scene.medium = number;
    }
}

int MaterialTable::part_of_mix(const std::string& name, const Recipe& asking, scene::Scene& scene) {
    const SourcePosition& position = asking.parameters.position();
    const Recipe* recipe = find({-1, name, asking.sequence}, position);
    if (const auto known = parts_.find(recipe); known != parts_.end()) {
        return known->second;
    }
    constexpr std::size_t deepest = 64;
    scene::Material material = grey_material(position);
    if (std::find(being_built_.begin(), being_built_.end(), recipe) != being_built_.end() || being_built_.size() > deepest) {
        context_.diagnostics.error(position, fmt::format("the material \"{}\" is mixed from itself, or from too many others", name));
    } else {
        material = built(recipe, position, scene);
        material.name = name;
    }
    const int number = static_cast<int>(scene.materials.size());
    scene.materials.push_back(std::move(material));
    parts_.emplace(recipe, number);
    return number;
}

scene::Material MaterialTable::built(const Recipe* recipe, const SourcePosition& position, scene::Scene& scene) {
    if (recipe == nullptr) {
        return grey_material(position);
    }
    const FindMaterial find_part = [&](const std::string& name, const Recipe& asking) { return part_of_mix(name, asking, scene); };
    being_built_.push_back(recipe);
    scene::Material material =
        version3_ ? build_old_material(*recipe, textures_, find_part) : build_material(*recipe, textures_, find_part);
    add_relief(*recipe, textures_, material);
    recipe->parameters.pass_over({"type"});
    being_built_.pop_back();
    return material;
}

void MaterialTable::finish(scene::Scene& scene, double brightness) {
    // The numbers of these are in use already; parts of mixes come after them.
    scene.materials.resize(wanted_.size());
    for (std::size_t i = 0; i < wanted_.size(); ++i) {
        const Wanted& wanted = wanted_[i];
        const SourcePosition& position = wanted.shape.parameters.position();
        scene::Material material = built(find(wanted.choice.material, position), position, scene);
        material.name = wanted.choice.material.name;
        material.emission = emission(wanted, brightness);
        fill_with_medium(wanted, material, scene, brightness);
        if (!wanted.choice.alpha.empty()) {
            material.opacity = textures_.value(wanted.shape, "alpha", 1.0, [](double share) { return std::clamp(share, 0.0, 1.0); });
            context_.report.honoured("\"alpha\"", position);
        }
        scene.materials[i] = std::move(material);
    }
    for (const Recipe& recipe : recipes_) {
        recipe.parameters.warn_of_unused();
    }
}

}  // namespace lancer::pbrt
