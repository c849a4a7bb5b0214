// What belongs to the whole file: background, ambient light, how to render.
#pragma once

#include "lancer/import/toml/context.h"

namespace lancer::notation {

void read_settings(Context& context, const toml::table& root);

}  // namespace lancer::notation
