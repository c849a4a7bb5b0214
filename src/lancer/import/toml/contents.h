// The shapes and placements of a file or a group.
#pragma once

#include <string>
#include <vector>

#include "lancer/import/toml/context.h"
#include "lancer/import/toml/materials.h"

namespace lancer::notation {

// A placement whose group is still a name.
struct NamedPlacement {
    std::string group;
    SourcePosition group_position;
    scene::Placement placement;
};

// In the order of the file, whatever their kinds.
struct Contents {
    std::vector<scene::Object> objects;
    std::vector<NamedPlacement> placements;
};

Contents read_contents(Context& context, Materials& materials, const toml::table& table);

// The tables of [[name]]; errors for what is none.
std::vector<const toml::table*> tables_of(Messages& messages, const toml::table& parent, std::string_view name);

}  // namespace lancer::notation
