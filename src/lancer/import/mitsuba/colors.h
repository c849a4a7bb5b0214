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
std::optional<Color> color_of(Builder& builder, const Element& element, Role role);

// The property of this name; `preset` when it is not written.
Color color_or(Builder& builder, Plugin& plugin, std::string_view name, const Color& preset, Role role);

}  // namespace lancer::mitsuba
