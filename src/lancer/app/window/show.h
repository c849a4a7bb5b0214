// Shows a scene: in a window, or as a file where there is no display.
#pragma once

#include <optional>
#include <string>

#include "lancer/app/cli/render_arguments.h"

namespace lancer::app {

// Both return the exit status and throw MachineFailure.
int show_default_scene(const std::optional<int>& threads);
int show_scene(const std::string& path, const RenderArguments& arguments);

}  // namespace lancer::app
