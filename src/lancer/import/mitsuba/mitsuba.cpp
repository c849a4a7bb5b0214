#include "lancer/import/mitsuba/mitsuba.h"

#include <algorithm>

#include <fmt/format.h>

#include "lancer/import/default_view.h"
#include "lancer/import/mesh/mesh_messages.h"
#include "lancer/import/mitsuba/builder.h"
#include "lancer/import/mitsuba/emitters.h"
#include "lancer/import/mitsuba/media.h"
#include "lancer/import/mitsuba/sensors.h"
#include "lancer/import/mitsuba/shapes.h"

namespace lancer {

using namespace mitsuba;

void read_mitsuba(ImportContext& context, scene::Scene& scene) {
    Document document(context);
    const auto root = document.read();
    if (!root) {
        return;
    }
    Builder builder{context, scene, document, {}, {}, {}, {}, {}, {}, nullptr, 0};
    builder.ids.add(*root, context.diagnostics);
    scene.settings.integrator = "path";
    scene.settings.spp = 16;
    bool has_sensor = false;
    // Films first: cameras need their shape, and what is met later may need the camera.
    for (const Element& element : root->children) {
        if (element.tag == "sensor") {
            add_sensor(builder, element, !has_sensor);
            has_sensor = true;
        }
    }
    for (const Element& element : root->children) {
        if (element.tag == "integrator") {
            set_integrator(builder, element);
        } else if (element.tag == "emitter") {
            add_emitter(builder, element);
        } else if (element.tag == "shape") {
            add_shape(builder, element, {scene.objects, scene.placements});
        } else if (element.tag != "sensor" && element.tag != "bsdf" && element.tag != "texture" && element.tag != "medium" &&
                   element.tag != "phase" && element.tag != "volume" && element.tag != "spectrum" && element.tag != "ref" &&
                   element.tag != "alias" && element.tag != "film" && element.tag != "sampler" && element.tag != "rfilter") {
            context.diagnostics.warning(element.position, fmt::format("<{}> means nothing here", element.tag));
            context.report.dropped(fmt::format("<{}>", element.tag), "unknown here", element.position);
        }
    }
    if (builder.around_camera) {
        // Where a body around the camera is filled with it, that is where it is.
        const std::optional<int> number = medium_of(builder, *builder.around_camera);
        const auto has_it = [&](const scene::Material& material) { return material.interior == number; };
        if (std::none_of(scene.materials.begin(), scene.materials.end(), has_it)) {
            scene.medium = number;
        }
    }
    if (!has_sensor) {
        context.diagnostics.note(root->position, "the scene has no sensor: the camera shows all of it");
        scene.cameras.push_back(default_camera(scene::bounds(scene)));
    }
}

}  // namespace lancer
