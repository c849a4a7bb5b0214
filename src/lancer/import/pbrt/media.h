// Media of pbrt.
#pragma once

#include <optional>
#include <string>

#include <glm/mat4x4.hpp>

#include "lancer/import/pbrt/graphics_state.h"
#include "lancer/scene/media.h"

namespace lancer::pbrt {

// MakeNamedMedium `name`, in a space of its own. `brightness` is a factor for all light. Nothing where it can't be told; the report says so.
std::optional<scene::Medium> build_medium(const Recipe& recipe, const std::string& name, const glm::dmat4& to_scene, double brightness);

}  // namespace lancer::pbrt
