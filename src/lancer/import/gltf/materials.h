// Materials of glTF as principled ones.
#pragma once

#include <string>
#include <vector>

#include "lancer/import/gltf/document.h"
#include "lancer/import/gltf/geometry.h"
#include "lancer/import/gltf/textures.h"
#include "lancer/import/import.h"
#include "lancer/scene/scene.h"

namespace lancer::gltf {

class Materials {
public:
    Materials(Document& document, Textures& textures, const ImportOptions& options, scene::Scene& scene);

    // Index into the scene's materials of what a primitive is made of, and what that wants to know of the primitive's surface.
    int of(Json primitive, Wishes& wishes);

private:
    // Primitives with colours of their own need a material that looks at them.
    struct Made {
        int index[2] = {-1, -1};
        Wishes wishes[2];
    };

    Json choose(Json primitive);

    Document& document_;
    Textures& textures_;
    scene::Scene& scene_;
    double variant_ = -1.0;   // -1: the file's own materials
    std::vector<Made> made_;  // the last one for primitives without a material
};

// Adds a material of the file, and those that it mixes before it; its index. `has_colors`: of the primitive's vertices.
int make_material(Document& document, Textures& textures, Json material, bool has_colors, Wishes& wishes,
                  std::vector<scene::Material>& all);

}  // namespace lancer::gltf
