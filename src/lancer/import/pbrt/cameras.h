// From a Camera directive, and the film behind it, to a camera of the scene.
#pragma once

#include <glm/mat4x4.hpp>

#include "lancer/import/pbrt/graphics_state.h"
#include "lancer/scene/camera.h"
#include "lancer/scene/render_settings.h"

namespace lancer::pbrt {

// For a right-handed world. `camera` and `film` are null where the file has none: then pbrt has a view of 90 degrees. The picture's size is in the settings.
scene::Camera build_camera(ImportContext& context, const Recipe* camera, const Recipe* film, const glm::dmat4& from_world,
                           scene::RenderSettings& settings);

}  // namespace lancer::pbrt
