#include "lancer/base/embedded_table.h"
#include "lancer/spectrum/upsample.h"

LANCER_EMBED_TABLE(lancer_upsampling_table, LANCER_TABLE_FILE);  // by generator/make_upsampling_table.cpp

namespace lancer {

std::span<const float> upsampling_table() { return {lancer_upsampling_table, static_cast<std::size_t>(upsampling_values)}; }

}  // namespace lancer
