// The unnamed camera and those with names.
#pragma once

#include "lancer/import/toml/context.h"

namespace lancer::notation {

// None are added when the file has none.
void read_cameras(Context& context, const toml::table& root);

}  // namespace lancer::notation
