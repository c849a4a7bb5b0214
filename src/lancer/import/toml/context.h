// What the builders of a scene share.
#pragma once

#include "lancer/import/scene_files.h"
#include "lancer/import/toml/messages.h"
#include "lancer/scene/scene.h"

namespace lancer::notation {

struct Context {
    Messages& messages;
    SceneFiles& files;
    scene::Scene& scene;
};

}  // namespace lancer::notation
