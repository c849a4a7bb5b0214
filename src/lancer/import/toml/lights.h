// All lights of a file.
#pragma once

#include "lancer/import/toml/context.h"

namespace lancer::notation {

// Whitted intensities are shares: lights without one share what the others leave, and when the sum is not 1 all are scaled, with a note.
void read_lights(Context& context, const toml::table& root);

}  // namespace lancer::notation
