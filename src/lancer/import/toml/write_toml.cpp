#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "lancer/import/mesh/mesh_file.h"
#include "lancer/import/toml/write_context.h"

namespace lancer {

namespace notation {

std::vector<std::string> distinct_names(const std::vector<std::string>& names, const std::string& for_empty,
                                        const std::vector<std::string>& taken) {
    std::set<std::string> used(taken.begin(), taken.end());
    std::vector<std::string> distinct;
    for (const std::string& name : names) {
        const std::string base = name.empty() ? for_empty : name;
        std::string candidate = base;
        for (int number = 2; !used.insert(candidate).second; ++number) {
            candidate = fmt::format("{} {}", base, number);
        }
        distinct.push_back(candidate);
    }
    return distinct;
}

namespace {

// Materials that something has, is placed with, mixes, or shows behind.
std::vector<bool> used_materials(const scene::Scene& scene) {
    std::vector<bool> used(scene.materials.size(), false);
    std::vector<int> waiting;
    const auto use = [&](int material) {
        if (!used[static_cast<std::size_t>(material)]) {
            used[static_cast<std::size_t>(material)] = true;
            waiting.push_back(material);
        }
    };
    const auto use_all = [&](const std::vector<scene::Object>& objects, const std::vector<scene::Placement>& placements) {
        for (const scene::Object& object : objects) {
            use(object.material);
        }
        for (const scene::Placement& placement : placements) {
            if (placement.material) {
                use(*placement.material);
            }
        }
    };
    for (const scene::Group& group : scene.groups) {
        use_all(group.objects, group.placements);
    }
    use_all(scene.objects, scene.placements);
    while (!waiting.empty()) {
        const scene::Material& material = scene.materials[static_cast<std::size_t>(waiting.back())];
        waiting.pop_back();
        if (material.behind) {
            use(*material.behind);
        }
        if (const auto* mix = std::get_if<scene::MixMaterial>(&material.model)) {
            use(mix->first);
            use(mix->second);
        }
    }
    return used;
}

template <class Thing>
std::vector<std::string> names_of(const std::vector<Thing>& things) {
    std::vector<std::string> names;
    for (const Thing& thing : things) {
        names.push_back(thing.name);
    }
    return names;
}

std::string write_contents(WriteContext& context, const std::vector<scene::Object>& objects,
                           const std::vector<scene::Placement>& placements, const std::string& prefix) {
    std::string text;
    for (const scene::Object& object : objects) {
        text += write_object(context, object, prefix);
    }
    for (const scene::Placement& placement : placements) {
        text += write_placement(context, placement, prefix);
    }
    return text;
}

}  // namespace

}  // namespace notation

WrittenScene write_toml(const scene::Scene& written, const std::string& path) {
    using namespace notation;
    const auto& [file, hash, inputs, cameras, materials, media, medium, groups, objects, placements, lights, background, ambient,
                 settings] = written;
    static_cast<void>(hash), static_cast<void>(inputs);
    const std::filesystem::path target(path);
    WrittenScene result;
    WriteContext context{written,
                         target.parent_path(),
                         target.stem().string(),
                         result,
                         distinct_names(names_of(materials), "material"),
                         distinct_names(names_of(groups), "group"),
                         distinct_names(names_of(media), "medium")};
    const std::string origin = std::filesystem::path(file).filename().string();
    std::string& text = result.toml;
    text = "# Written by lancer convert, from " + quoted_text(origin) + "\n";
    text += write_settings(settings);
    text += write_cameras(cameras);
    for (const scene::Light& light : lights) {
        text += write_light(context, light);
    }
    text += write_background(context, background);
    if (ambient != scene::Color(scene::Rgb(1.0))) {
        text += "\n[ambient]\ncolor = " + write_color(ambient) + "\n";
    }
    for (std::size_t i = 0; i < media.size(); ++i) {
        text += write_medium(context, media[i], context.media[i], medium == static_cast<int>(i));
    }
    const std::vector<bool> used = used_materials(written);
    for (std::size_t i = 0; i < materials.size(); ++i) {
        if (used[i] && !materials[i].is_default) {
            text += write_material(context, materials[i], context.materials[i]);
        }
    }
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const auto& [name, group_objects, group_placements] = groups[i];
        static_cast<void>(name);
        text += fmt::format("\n[[group]]\nname = {}\n", quoted_text(context.groups[i]));
        text += write_contents(context, group_objects, group_placements, "group.");
    }
    text += write_contents(context, objects, placements, "");
    if (!context.meshes.empty()) {
        result.mesh_file = context.mesh_file();
        result.meshes = write_meshes(context.meshes);
    }
    return result;
}

}  // namespace lancer
