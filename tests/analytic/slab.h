// Light scattered by a flat layer, by adding and doubling [van de Hulst 1980]: for comparison, and with nothing in common with the renderer.
#pragma once

#include <vector>

namespace lancer::tests {

struct Layer {
    double thickness = 1.0;  // optical
    double albedo = 1.0;
    double asymmetry = 0.0;  // Henyey and Greenstein's
};

// Radiance under `cosine` to the layer's normal, on the side that is lit (`reflected`) and on the other, where light of irradiance 1 falls on it
// along the normal.
struct SlabLight {
    double reflected = 0.0;
    double transmitted = 0.0;  // without what has not been scattered
};
SlabLight light_of_slab(const Layer& layer, double cosine);

}  // namespace lancer::tests
