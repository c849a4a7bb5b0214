// TOML text to a tree of values with positions.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <toml++/toml.h>

#include "lancer/base/diagnostic.h"

namespace lancer::notation {

// Nothing when the text is not TOML; the diagnostics then list what is wrong, more than the first mistake where the rest still makes sense.
std::optional<toml::table> parse(std::string_view text, const std::string& file, Diagnostics& diagnostics);

}  // namespace lancer::notation
