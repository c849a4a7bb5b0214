#include "lancer/film/display.h"

#include <cmath>

#include "lancer/image/image.h"

namespace lancer {

DisplayCurve::DisplayCurve(double exposure) : scale_(static_cast<float>(std::exp2(exposure))) {
    for (int i = 0; i <= steps; ++i) {
        table_[static_cast<std::size_t>(i)] = srgb_encode(static_cast<float>(i) / static_cast<float>(steps));
    }
    table_[steps + 1] = 1.0f;  // place may round up to `steps`
}

}  // namespace lancer
