// The scene of the report's Figure 1, which the program carries with it.
#pragma once

#include <optional>

#include "lancer/base/diagnostic.h"
#include "lancer/scene/scene.h"

namespace lancer::app {

std::optional<scene::Scene> import_default_scene(Diagnostics& diagnostics);

}  // namespace lancer::app
