// The tree of a file to a scene.
#pragma once

#include "lancer/import/toml/context.h"

namespace lancer::notation {

// Fills context.scene. What it holds means nothing when there were errors.
void build(Context& context, const toml::table& root);

}  // namespace lancer::notation
