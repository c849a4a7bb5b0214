// What rough surfaces reflect, tabulated: kernel/bsdf/albedo.h says how.
#pragma once

#include <span>

namespace lancer {

// Made when lancer was built.
std::span<const float> microfacet_albedo_table();

}  // namespace lancer
