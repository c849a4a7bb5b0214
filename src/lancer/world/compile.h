// From what the author wrote to what the kernel reads.
#pragma once

#include <memory>

#include "lancer/base/diagnostic.h"
#include "lancer/scene/scene.h"
#include "lancer/world/world.h"

namespace lancer {

constexpr int max_path_bounces = 1024;

// Groups and placements are flattened, transforms composed, names resolved, images loaded. `camera` and scene.settings (size, bounces,
// wavelengths) are built in. Null when there are errors: an image that can't be read, a map that flattens space, too many bounces.
std::shared_ptr<const World> compile_world(const scene::Scene& scene, const scene::Camera& camera, Diagnostics& diagnostics);

}  // namespace lancer
