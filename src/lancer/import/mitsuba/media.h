// Media.
#pragma once

#include <optional>

#include "lancer/import/mitsuba/builder.h"

namespace lancer::mitsuba {

// A number of scene.media; nothing where it can't be told, and the report says so.
std::optional<int> medium_of(Builder& builder, const Element& element);

}  // namespace lancer::mitsuba
