// Sensors with their films and samplers, and the integrator: how the scene is seen and rendered.
#pragma once

#include "lancer/import/mitsuba/builder.h"

namespace lancer::mitsuba {

// The first one sets the picture's size, filter and samples.
void add_sensor(Builder& builder, const Element& element, bool first);

void set_integrator(Builder& builder, const Element& element);

}  // namespace lancer::mitsuba
