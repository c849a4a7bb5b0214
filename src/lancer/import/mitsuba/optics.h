// Indices of refraction and metals by the names that Mitsuba has for them.
#pragma once

#include <optional>
#include <string_view>

#include "lancer/import/mitsuba/builder.h"

namespace lancer::mitsuba {

// Index of a transparent material at all wavelengths alike.
std::optional<double> find_index(std::string_view name);

// Written as a number or a name; `preset` is a name.
double index_or(Builder& builder, Plugin& plugin, std::string_view name, std::string_view preset);

}  // namespace lancer::mitsuba
