// Emitters.
#pragma once

#include <optional>

#include "lancer/import/mitsuba/builder.h"

namespace lancer::mitsuba {

// Of a shape.
std::optional<scene::Emission> emission_of(Builder& builder, const Element& element);

// One that stands alone in the scene.
void add_emitter(Builder& builder, const Element& element);

}  // namespace lancer::mitsuba
