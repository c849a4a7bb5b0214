#include "lancer/import/pbrt/facets.h"

#include <algorithm>
#include <cmath>

namespace lancer::pbrt {

double our_roughness(double value, bool remapped, bool version3) {
    double alpha = std::max(value, 0.0);
    if (remapped && version3) {
        const double x = std::log(std::max(alpha, 1e-3));
        alpha = 1.62142 + 0.819955 * x + 0.1734 * x * x + 0.0171201 * x * x * x + 0.000640711 * x * x * x * x;
    } else if (remapped) {
        alpha = std::sqrt(alpha);
    }
    return std::sqrt(std::clamp(alpha, 0.0, 1.0));
}

FacetValues read_facets(const Recipe& recipe, const Textures& textures, const std::string& prefix, double otherwise, bool version3) {
    const Parameters& parameters = recipe.parameters;
    const bool remapped = parameters.boolean("remaproughness", true);
    const auto change = [=](double value) { return our_roughness(value, remapped, version3); };
    const std::string both = prefix + "roughness", along_u = prefix + "uroughness", along_v = prefix + "vroughness";
    const bool has_u = parameters.has(along_u), has_v = parameters.has(along_v);
    parameters.has(both);
    FacetValues facets;
    facets.roughness = textures.value(recipe, has_u ? along_u : both, otherwise, change);
    if (!has_u && !has_v) {
        return facets;
    }
    const scene::Value v = textures.value(recipe, has_v ? along_v : both, otherwise, change);
    const double a = facets.roughness.number, b = v.number;
    if (facets.roughness.texture || v.texture) {
        if (!facets.roughness.texture) {
            facets.roughness = v;
        }
        parameters.context().report.approximated(parameters.owner() + ", rough in one direction by a texture", "the same in all directions",
                                                 parameters.position());
    } else if (a != b) {
        // Ours: alpha is r^2 aspect along u and r^2 / aspect along v, aspect^2 = 1 - 0.9 anisotropy, which may be negative.
        const double wanted = a * a / std::max(b * b, 1e-12), ratio = std::clamp(wanted, 0.01, 90.0);
        facets.roughness = std::sqrt(a * b);
        facets.anisotropy = (1.0 - ratio) / 0.9;
        if (ratio != wanted) {
            parameters.context().report.approximated(parameters.owner() + ", much rougher in one direction", "less so",
                                                     parameters.position());
        }
    }
    return facets;
}

}  // namespace lancer::pbrt
