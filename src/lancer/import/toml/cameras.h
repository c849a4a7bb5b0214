// The unnamed camera and those with names.
#pragma once

#include "lancer/import/toml/includes.h"

namespace lancer::notation {

// None are added when the file has none.
void read_cameras(Context& context, const toml::table& root);

// Behind those of the file. The file's own stand for those of the same name; unnamed ones are taken where the file has none at all.
void add_included_cameras(Context& context, const std::vector<Included>& included);

}  // namespace lancer::notation
