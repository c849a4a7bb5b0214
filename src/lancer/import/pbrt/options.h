// What stands before WorldBegin: camera, film, filter, sampler, integrator.
#pragma once

#include <map>
#include <optional>

#include <glm/mat4x4.hpp>

#include "lancer/import/pbrt/graphics_state.h"
#include "lancer/import/pbrt/syntax.h"
#include "lancer/scene/scene.h"

namespace lancer::pbrt {

class Options {
public:
    explicit Options(ImportContext& context) : context_(context) {}

    void set_version3(bool version3) { version3_ = version3; }

    // Of each kind the last one counts. `from_world`: the transform that is in force there.
    void set(Keyword keyword, Recipe recipe, const glm::dmat4& from_world);

    // Fills in the camera and the settings. Returns the factor that the film's exposure puts on all light.
    double finish(scene::Scene& scene);

private:
    const Recipe* find(Keyword keyword) const;
    double set_film(scene::RenderSettings& settings);
    void set_filter(scene::RenderSettings& settings);
    void set_sampler(scene::RenderSettings& settings);
    void set_integrator(scene::RenderSettings& settings);

    ImportContext& context_;
    bool version3_ = false;
    std::map<Keyword, Recipe> recipes_;
    std::optional<glm::dmat4> from_world_;  // where the camera stands
};

}  // namespace lancer::pbrt
