// What is odd about media.
#pragma once

#include "lancer/base/diagnostic.h"
#include "lancer/scene/scene.h"

namespace lancer::app {

// Warnings: media that do nothing, grids that lie elsewhere, light that can't arrive, coefficients of another unit, borders around nothing.
void find_media_oddities(const scene::Scene& scene, Diagnostics& diagnostics);

}  // namespace lancer::app
