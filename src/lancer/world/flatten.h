// The scene's tree of groups as one list of objects with their maps to world space.
#pragma once

#include <vector>

#include "lancer/scene/scene.h"

namespace lancer {

struct FlatObject {
    const scene::Object* object = nullptr;
    glm::dmat4 to_world{1.0};
    int material = 0;
};

// In the order of the file: objects first, then each placement with its own.
std::vector<FlatObject> flatten(const scene::Scene& scene);

}  // namespace lancer
