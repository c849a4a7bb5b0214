// Hairs and ropes: curves with a radius, as tubes of triangles.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lancer/base/diagnostic.h"
#include "lancer/scene/shapes.h"

namespace lancer::mitsuba {

// A text of control points, x y z radius on each line; an empty line begins another curve. `smooth` ones are cubic B-splines, others lines from point
// to point. Nothing when there are errors, or too much to be made.
std::optional<scene::TriangleMesh> read_curves(std::string_view text, bool smooth, const std::string& file, Diagnostics& diagnostics);

}  // namespace lancer::mitsuba
