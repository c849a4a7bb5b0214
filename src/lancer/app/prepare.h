// From a scene and what the command line asks of it to a device that is ready to render it.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "lancer/app/cli/render_arguments.h"
#include "lancer/base/diagnostic.h"
#include "lancer/device/device.h"
#include "lancer/film/layered_picture.h"
#include "lancer/image/image.h"
#include "lancer/image/view.h"
#include "lancer/render/render.h"
#include "lancer/scene/scene.h"
#include "lancer/world/world.h"

namespace lancer::app {

// What files are made of, besides a film.
struct Presentation {
    Metadata metadata;  // for every picture made of it
    ViewTransform view;
    PictureContents contents;  // of EXR files
    PictureNames names;        // where these contents need them
    int threads = 0;           // that develop it; 0: all
};

struct Prepared : Presentation {
    scene::Scene scene;  // as it is rendered: its settings, cameras and lights are those asked for
    RenderOptions options;
    std::unique_ptr<Device> device;
    std::shared_ptr<const World> world;
};

// How many samples a pixel gets, and where.
std::string antialiasing_in_words(const scene::Scene& scene);

// Puts what the arguments say into the scene: its settings, one camera, only the lights that were named.
void apply_arguments(scene::Scene& scene, const RenderArguments& arguments, Diagnostics& diagnostics);

// Nothing is returned when there are errors. `command` is what a person would type for the same picture.
std::optional<Prepared> prepare(scene::Scene scene, const RenderArguments& arguments, const std::string& command, Diagnostics& diagnostics);

// As `lancer render SCENE ...` would be typed, without what does not change the picture.
std::string render_command(const std::string& scene_file, const RenderArguments& arguments);

}  // namespace lancer::app
