#include "lancer/world/albedo_table.h"

#include "lancer/base/embedded_table.h"
#include "lancer/kernel/bsdf/albedo.h"

LANCER_EMBED_TABLE(lancer_albedo_table, LANCER_TABLE_FILE);  // by generator/make_albedo_table.cpp

namespace lancer {

std::span<const float> microfacet_albedo_table() { return {lancer_albedo_table, static_cast<std::size_t>(kernel::ALBEDO_VALUES)}; }

}  // namespace lancer
