// BSDFs.
#pragma once

#include "lancer/import/mitsuba/builder.h"

namespace lancer::mitsuba {

// The material of a shape with this BSDF (null: none is written) that is this area light (null: none). A number of scene.materials.
int material_of(Builder& builder, const Element* bsdf, const Element* emitter, const SourcePosition& shape);

// The same material with a medium inside of it; of a null BSDF, its border.
int filled_material(Builder& builder, int material, int medium);

// Whether it is nothing: light goes through it straight on.
bool is_nothing(const Element* bsdf);

}  // namespace lancer::mitsuba
