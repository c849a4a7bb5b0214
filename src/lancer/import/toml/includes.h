// Other scene files as parts of this one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lancer/import/toml/materials.h"

namespace lancer::notation {

// One [[include]]: its shapes are a group of the scene already, with its materials.
struct Included {
    std::string name;  // empty: seen once, where it is placed
    SourcePosition position;
    scene::Placement placement;
    int depth = 1;              // of groups in groups
    std::uint64_t objects = 0;  // with those of groups, and one for each placement
    // As they are in this scene; empty where they are not wanted.
    std::vector<scene::Light> lights;
    std::vector<scene::Camera> cameras;
    std::optional<scene::Background> background;
    std::optional<scene::Color> ambient;
    std::optional<scene::RenderSettings> settings;
};

// Reads them all. Of their materials, those that the file has a name for are the file's.
std::vector<Included> read_includes(Context& context, Materials& materials, const toml::table& root);

}  // namespace lancer::notation
