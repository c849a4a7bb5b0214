// Where a thing stands in its parent's space.
#pragma once

#include <glm/mat4x4.hpp>

#include "lancer/import/toml/table_reader.h"

namespace lancer::notation {

// From the keys scale, rotate and translate, applied in this order.
glm::dmat4 read_transform(TableReader& reader);

}  // namespace lancer::notation
