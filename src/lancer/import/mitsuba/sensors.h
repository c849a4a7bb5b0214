// Sensors with their films and samplers, and the integrator: how the scene is seen and rendered.
#pragma once

#include "lancer/import/mitsuba/builder.h"

namespace lancer::mitsuba {

// The first one sets the picture's size, filter and samples.
void add_sensor(Builder& builder, const Element& element, bool first);

void set_integrator(Builder& builder, const Element& element);

// Of perspective cameras and projectors, by "fov" and "fov_axis" or by "focal_length": degrees across the picture's width or height.
struct FieldOfView {
    double degrees = 50.0;
    bool by_height = false;
};

FieldOfView field_of_view(Builder& builder, Plugin& plugin, double width, double height);

}  // namespace lancer::mitsuba
