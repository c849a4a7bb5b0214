// From LightSource directives to the scene's lights and surroundings.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include <glm/mat4x4.hpp>

#include "lancer/import/pbrt/environments.h"
#include "lancer/import/pbrt/graphics_state.h"
#include "lancer/import/pbrt/light_power.h"
#include "lancer/scene/scene.h"

namespace lancer::pbrt {

class Lights {
public:
    Lights(ImportContext& context, scene::Scene& scene) : context_(context), scene_(scene) {}

    void set_version3(bool version3) { version3_ = version3; }

    void add(const Recipe& light, const glm::dmat4& to_world);

    // `brightness` is a factor for all light. A scene that is dark gets light from everywhere, and a word about it.
    void finish(double brightness);

private:
    void add_point(const Recipe& light, const glm::dmat4& to_world);
    void add_spot(const Recipe& light, const glm::dmat4& to_world);
    void add_distant(const Recipe& light, const glm::dmat4& to_world);
    void add_infinite(const Recipe& light, const glm::dmat4& to_world);
    void add_surroundings(const Recipe& light, const LightColor& color, const glm::dmat4& to_world);
    void place_surroundings(double brightness);
    void add_goniometric(const Recipe& light, const glm::dmat4& to_world);
    void add_projection(const Recipe& light, const glm::dmat4& to_world);
    std::optional<Environment> thrown_picture(const Parameters& parameters);
    void push(const Recipe& light, decltype(scene::Light::model) model, const Color& power);

    ImportContext& context_;
    scene::Scene& scene_;
    bool version3_ = false;
    std::vector<Color> powers_;      // of the scene's lights
    std::vector<Color> everywhere_;  // light that comes from everywhere
    std::vector<Environment> environments_;
};

}  // namespace lancer::pbrt
