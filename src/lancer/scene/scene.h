// What the author of a scene wrote, as plain structs: names, units, source positions. Nothing here knows a file format or a ray.
//
// Units: metres for lengths, degrees for angles as written. Colours are linear RGB with sRGB (Rec. 709) primaries and a D65 white.
// The space is right-handed; +y is up by default.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "lancer/scene/camera.h"
#include "lancer/scene/color.h"
#include "lancer/scene/lights.h"
#include "lancer/scene/materials.h"
#include "lancer/scene/media.h"
#include "lancer/scene/render_settings.h"
#include "lancer/scene/shapes.h"

namespace lancer::scene {

// A file that the scene was read from.
struct InputFile {
    std::string path;  // as named, from where the program was started
    std::string hash;  // hexadecimal, of its bytes
};

struct Scene {
    std::string file;               // as named by the user
    std::string hash;               // hexadecimal, over the scene file and everything it reads
    std::vector<InputFile> inputs;  // the scene file and everything it reads, in the order of reading
    std::vector<Camera> cameras;    // at least one
    std::vector<Material> materials;
    std::vector<Medium> media;
    std::optional<int> medium;  // what is everywhere outside of bodies: index into `media`
    std::vector<Group> groups;  // a group comes after every group it places
    std::vector<Object> objects;
    std::vector<Placement> placements;
    std::vector<Light> lights;
    Background background;
    Color ambient = Rgb(1.0);  // light that reaches every point, times each material's `ambient`
    RenderSettings settings;
};

// The integrator that "auto" stands for.
std::string chosen_integrator(const Scene& scene);
int bounces_of(const Scene& scene);
// Whether light follows physics, along paths: any integrator but whitted.
bool follows_paths(const Scene& scene);

}  // namespace lancer::scene
