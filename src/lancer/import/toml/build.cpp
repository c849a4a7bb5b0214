#include "lancer/import/toml/build.h"

#include <fmt/format.h>

#include <algorithm>

#include "lancer/import/default_view.h"
#include "lancer/import/toml/cameras.h"
#include "lancer/import/toml/groups.h"
#include "lancer/import/toml/lights.h"
#include "lancer/import/toml/materials.h"
#include "lancer/import/toml/media.h"
#include "lancer/import/toml/settings.h"
#include "lancer/scene/bounds.h"

namespace lancer::notation {

namespace {

constexpr double farthest = 1e15;  // metres: squares of distances stay finite in single precision

void complain_about_unknown_sections(Messages& messages, const toml::table& root) {
    std::vector<std::string> names;
    for (const Section& section : file_sections()) {
        names.emplace_back(section.name);
    }
    for (const auto& [key, value] : root) {
        const std::string word(key.str());
        if (std::find(names.begin(), names.end(), word) != names.end() || messages.full()) {
            continue;
        }
        std::string hint = did_you_mean(word, names);
        hint = hint.empty() ? fmt::format("; there may be {}", fmt::join(names, ", ")) : ";" + hint;
        for (const Table* table : {&render(), &camera()}) {
            if (table->find(word)) {
                hint = fmt::format("; it belongs below [{}]", table->name);
            }
        }
        messages.error(messages.at(key), fmt::format("a scene has no \"{}\"{}", word, hint));
    }
}

bool reaches_too_far(const scene::Bounds& bounds) {
    for (int axis = 0; !bounds.empty() && axis < 3; ++axis) {
        if (!(bounds.low[axis] >= -farthest && bounds.high[axis] <= farthest)) {
            return true;
        }
    }
    return false;
}

// Each transform alone is within limits; together they may still leave what single precision can hold.
void check_reach(Messages& messages, const std::vector<scene::Object>& objects, const std::vector<scene::Placement>& placements,
                 const std::vector<scene::Bounds>& groups) {
    const std::string message = fmt::format("this reaches further than {:g} m from the origin", farthest);
    for (const scene::Object& object : objects) {
        if (reaches_too_far(scene::transform(object.to_parent, scene::bounds(object.shape)))) {
            messages.error(object.position, message);
        }
    }
    for (const scene::Placement& placement : placements) {
        const scene::Bounds& inside = groups[static_cast<std::size_t>(placement.group)];
        if (!reaches_too_far(inside) && reaches_too_far(scene::transform(placement.to_parent, inside))) {
            messages.error(placement.position, message);
        }
    }
}

// What included files say about rendering and surroundings: the first one's word holds.
void take_settings(scene::Scene& scene, const std::vector<Included>& included) {
    const auto first_with = [&](const auto& member) {
        return std::find_if(included.begin(), included.end(), [&](const Included& each) { return (each.*member).has_value(); });
    };
    if (const auto i = first_with(&Included::settings); i != included.end()) {
        scene.settings = *i->settings;
    }
    if (const auto i = first_with(&Included::background); i != included.end()) {
        scene.background = *i->background;
    }
    if (const auto i = first_with(&Included::ambient); i != included.end()) {
        scene.ambient = *i->ambient;
    }
}

bool shows_something(const scene::Scene& scene) {
    std::vector<bool> groups;  // whether there is an object in it
    const auto any_placed = [&](const std::vector<scene::Placement>& placements) {
        return std::any_of(placements.begin(), placements.end(),
                           [&](const scene::Placement& p) { return groups[static_cast<std::size_t>(p.group)]; });
    };
    for (const scene::Group& group : scene.groups) {
        groups.push_back(!group.objects.empty() || any_placed(group.placements));
    }
    return !scene.objects.empty() || any_placed(scene.placements);
}

}  // namespace

void build(Context& context, const toml::table& root) {
    Messages& messages = context.messages;
    scene::Scene& scene = context.scene;
    const SourcePosition whole_file{messages.file(), 0, 0};
    complain_about_unknown_sections(messages, root);
    Materials materials(context);
    materials.read_names(root);
    read_media(context, root);
    const std::vector<Included> included = read_includes(context, materials, root);
    take_settings(scene, included);
    read_cameras(context, root);
    add_included_cameras(context, included);
    read_settings(context, root);
    materials.read_named();
    read_lights(context, included, root);
    read_groups_and_contents(context, materials, included, root);
    if (messages.diagnostics().has_errors()) {
        return;  // the rest would complain about what is missing because it was wrong
    }

    materials.warn_about_unused();
    warn_about_unused_media(context);
    const bool is_part = context.import.options.is_part;
    if (!is_part && !shows_something(scene)) {
        messages.error(whole_file,
                       "there is nothing to see: the scene needs a shape, such as [[sphere]], or a [[place]] of a group with shapes");
        return;
    }
    const std::vector<scene::Bounds> groups = scene::group_bounds(scene);
    for (const scene::Group& group : scene.groups) {
        check_reach(messages, group.objects, group.placements, groups);
    }
    check_reach(messages, scene.objects, scene.placements, groups);
    const bool shines = std::any_of(scene.materials.begin(), scene.materials.end(), [](const auto& m) { return m.emission.has_value(); });
    const bool glows = std::any_of(scene.media.begin(), scene.media.end(),
                                   [](const scene::Medium& m) { return m.emission.spectrum || m.emission.rgb != scene::Rgb(0.0); });
    const bool has_surroundings =
        std::any_of(included.begin(), included.end(), [](const Included& i) { return i.background || i.ambient; });
    if (!is_part && scene.lights.empty() && !shines && !glows && !has_surroundings && !root.contains("background") &&
        !root.contains("sky") && !root.contains("ambient")) {
        messages.error(whole_file,
                       "the scene is dark: it needs a [[light]], a material or medium with `emission`, a [background] or `ambient` light");
        return;
    }
    if (!is_part && scene.cameras.empty() && !messages.diagnostics().has_errors()) {
        messages.note(whole_file, "there is no [camera]: one that sees everything is used");
        scene.cameras.push_back(default_camera(scene::bounds(scene)));
    }
}

}  // namespace lancer::notation
