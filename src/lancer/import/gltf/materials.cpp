#include "lancer/import/gltf/materials.h"

#include <algorithm>

#include <fmt/format.h>

namespace lancer::gltf {

Materials::Materials(Document& document, Textures& textures, const ImportOptions& options, scene::Scene& scene)
    : document_(document), textures_(textures), scene_(scene), made_(document.items("materials").size() + 1) {
    const Json variants = document.extension(document.root(), "KHR_materials_variants")["variants"];
    std::vector<std::string> names;
    for (const Json variant : variants) {
        if (!options.variant.empty() && variant.text("name") == options.variant) {
            variant_ = static_cast<double>(names.size());
            document.honoured("KHR_materials_variants", variant);
        }
        names.emplace_back(variant.text("name"));
    }
    if (!options.variant.empty() && variant_ < 0.0) {
        document.error(variants, fmt::format("there is no variant \"{}\"{}", options.variant, did_you_mean(options.variant, names)));
    }
}

Json Materials::choose(Json primitive) {
    if (variant_ >= 0.0) {
        for (const Json mapping : document_.extension(primitive, "KHR_materials_variants")["mappings"]) {
            const std::vector<double> variants = mapping.numbers("variants");
            if (std::find(variants.begin(), variants.end(), variant_) != variants.end()) {
                return document_.item("materials", mapping, "material");
            }
        }
    }
    return document_.item("materials", primitive, "material");
}

int Materials::of(Json primitive, Wishes& wishes) {
    const Json material = choose(primitive);
    const std::vector<Json>& all = document_.items("materials");
    const auto place = std::find_if(all.begin(), all.end(), [&](Json m) { return material && m.index() == material.index(); });
    Made& made = made_[static_cast<std::size_t>(place - all.begin())];
    const bool has_colors = static_cast<bool>(primitive["attributes"]["COLOR_0"]);
    int& index = made.index[has_colors ? 1 : 0];
    if (index < 0) {
        index = make_material(document_, textures_, material, has_colors, made.wishes[has_colors ? 1 : 0], scene_.materials);
    }
    wishes = made.wishes[has_colors ? 1 : 0];
    return index;
}

}  // namespace lancer::gltf
