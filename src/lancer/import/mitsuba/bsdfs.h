// BSDFs that stand for themselves, as materials of ours; what wraps others is in materials.cpp.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lancer/import/mitsuba/builder.h"

namespace lancer::mitsuba {

// Nothing for a type that is not known.
std::optional<scene::Material> bsdf_of(Builder& builder, Plugin& plugin);

// For "did you mean".
std::vector<std::string> bsdf_names();

}  // namespace lancer::mitsuba
