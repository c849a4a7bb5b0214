// All lights of a file.
#pragma once

#include "lancer/import/toml/includes.h"

namespace lancer::notation {

// Whitted intensities are shares: lights without one share what the others leave, and when the sum is not 1 all are scaled, with a note.
// Those of included files come first; where the file has a light of the same name, it stands in that one's place.
void read_lights(Context& context, const std::vector<Included>& included, const toml::table& root);

}  // namespace lancer::notation
