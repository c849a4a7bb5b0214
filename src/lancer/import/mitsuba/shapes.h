// Shapes, groups of shapes and their instances.
#pragma once

#include <vector>

#include "lancer/import/mitsuba/builder.h"

namespace lancer::mitsuba {

// Where shapes are put: into the scene or into a group.
struct Place {
    std::vector<scene::Object>& objects;
    std::vector<scene::Placement>& placements;
};

void add_shape(Builder& builder, const Element& element, Place place);

}  // namespace lancer::mitsuba
