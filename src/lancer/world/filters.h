// Pixel filters as tables to draw from.
#pragma once

#include "lancer/scene/render_settings.h"
#include "lancer/world/world.h"

namespace lancer {

// One coordinate of a filter of the given radius (pixels), at a distance from the middle; not normalised, 0 beyond the radius.
double filter_value(scene::PixelFilter filter, double radius, double distance);

// What the filter reaches if nobody says.
double usual_radius(scene::PixelFilter filter);

// Fills world.filter and filter_places.
void compile_filter(const scene::RenderSettings& settings, World& world);

}  // namespace lancer
