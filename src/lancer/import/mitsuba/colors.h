// Colours and spectra.
#pragma once

#include <optional>

#include "lancer/import/mitsuba/builder.h"

namespace lancer::mitsuba {

// What a colour is the colour of. Spectra mean different things: light is weighed by the eye, shares are seen under daylight, and an index may be
// above 1.
enum class Role { share, light, index };

using Color = scene::Rgb;

// Of <rgb>, <srgb>, <spectrum>, <blackbody>, <float> or a <texture> that is the same everywhere. Nothing for what is no such thing; errors in one
// are diagnostics, and it is black then.
std::optional<scene::Color> color_of(Builder& builder, const Element& element, Role role);

// The property of this name; `preset` when it is not written.
scene::Color color_or(Builder& builder, Plugin& plugin, std::string_view name, const Color& preset, Role role);

// The same at every wavelength; white where light is red, green and blue.
scene::Color equal_energy(double value);

// What a colour looks like: a light by itself, all else under daylight.
Color visible(const scene::Color& color, Role role);

// Part of a complex index of refraction, divided by that of what is outside.
std::optional<scene::Index> index_curve_or_nothing(Builder& builder, Plugin& plugin, std::string_view name, double outside);

}  // namespace lancer::mitsuba
