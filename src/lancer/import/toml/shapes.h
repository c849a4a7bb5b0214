// One shape with its material and place.
#pragma once

#include <optional>

#include "lancer/import/toml/context.h"
#include "lancer/import/toml/materials.h"

namespace lancer::notation {

// `kind` counts as in shapes(). Nothing when there is no shape to make, after an error.
std::optional<scene::Object> read_object(Context& context, Materials& materials, const toml::table& table, std::size_t kind);

}  // namespace lancer::notation
