#define LANCER_DOUBLE
#include "analytic/kernel_shapes.inc"

namespace lancer::tests {

const Kernel in_double{unit, meet, surface, leave, mirror, fresnel, refracted, index};

}  // namespace lancer::tests
