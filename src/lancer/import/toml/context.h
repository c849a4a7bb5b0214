// What the builders of a scene share.
#pragma once

#include "lancer/import/reader.h"
#include "lancer/import/toml/messages.h"
#include "lancer/scene/scene.h"

namespace lancer::notation {

struct Context {
    Messages& messages;
    SceneFiles& files;
    scene::Scene& scene;
    ImportContext& import;
};

}  // namespace lancer::notation
