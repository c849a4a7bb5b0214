// Media, by name.
#pragma once

#include "lancer/import/toml/context.h"
#include "lancer/import/toml/table_reader.h"

namespace lancer::notation {

// All [medium.NAME] of the file, in its order. Before the materials, which name them.
void read_media(Context& context, const toml::table& root);

// The value of the key `interior`: an index into Scene::media; nothing when it is not written or wrong.
std::optional<int> read_interior(Context& context, TableReader& reader);

void warn_about_unused_media(Context& context);

}  // namespace lancer::notation
