#include "lancer/import/pbrt/light_power.h"

#include <glm/common.hpp>

namespace lancer::pbrt {

LightColor read_light_color(const Recipe& light, std::string_view name, bool version3) {
    LightColor result;
    result.color = scene::Rgb(glm::max(light_to_srgb(light.space, scene::Rgb(1.0)), 0.0));
    if (const Parameter* parameter = light.parameters.find(name)) {
        result.color = read_light(light.parameters, *parameter, light.space, version3).value_or(result.color);
    }
    const Parameter* scale = light.parameters.find("scale");
    if (scale != nullptr && scale->type != "float") {  // version 3: a colour
        const auto times = read_light(light.parameters, *scale, light.space, true);
        result.color = visible_light(result.color) * (times ? visible_light(*times) : scene::Rgb(1.0));
    } else {
        result.scale = light.parameters.number("scale", 1.0);
    }
    return result;
}

}  // namespace lancer::pbrt
