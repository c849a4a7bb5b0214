// Filters of a plane of floats by the product of a row's and a column's weights.
#pragma once

#include <vector>

namespace lancer {

struct Plane {
    int width = 0;
    int height = 0;
    std::vector<float> values;  // row-major, top row first

    Plane(int width_, int height_)
        : width(width_), height(height_), values(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)) {}
    float* row(int y) { return values.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width); }
    const float* row(int y) const { return values.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width); }
};

// An odd number of weights, the middle one for the pixel itself. The weights are correlated with the plane: weights[i] goes with the pixel that
// lies i - size/2 further to the right (further down). Beyond the edge the nearest pixel is repeated.
Plane filter_rows(const Plane& plane, const std::vector<float>& weights);
Plane filter_columns(const Plane& plane, const std::vector<float>& weights);

}  // namespace lancer
