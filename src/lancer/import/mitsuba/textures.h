// Textures: what a material's colour or number is at each point.
#pragma once

#include <functional>

#include "lancer/import/mitsuba/builder.h"
#include "lancer/import/mitsuba/colors.h"

namespace lancer::mitsuba {

// Of a colour or a texture.
scene::Texture texture_of(Builder& builder, const Element& element, Role role, bool gives_numbers = false);
scene::Texture texture_or(Builder& builder, Plugin& plugin, std::string_view name, const Color& preset, Role role);

// A number, the same everywhere or by a texture. `preset` when it is not written.
scene::Value value_or(Builder& builder, Plugin& plugin, std::string_view name, double preset);
scene::Value value_of(Builder& builder, const Element& element);

// As above, each number after `change`.
scene::Value changed_value_or(Builder& builder, Plugin& plugin, std::string_view name, double preset,
                              const std::function<double(double)>& change);

// One number for a texture where there is no room for a texture: its mean.
double number_or(Builder& builder, Plugin& plugin, std::string_view name, double preset);

// Name of the mesh attribute that a BSDF asks for, on vertices ("vertex_...") or faces ("face_..."); empty when it asks for none.
std::string attribute_used(Builder& builder, const Element* bsdf);

}  // namespace lancer::mitsuba
