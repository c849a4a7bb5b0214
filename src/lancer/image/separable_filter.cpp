#include "lancer/image/separable_filter.h"

#include <algorithm>
#include <cstddef>

namespace lancer {

namespace {

// to[x] = sum of weights[i] * from[i][x]. In short pieces, whose sums the processor keeps in registers.
void sum_weighted(const std::vector<const float*>& from, const std::vector<float>& weights, float* to, std::size_t width) {
    constexpr std::size_t piece = 32;
    std::size_t x = 0;
    for (; x + piece <= width; x += piece) {
        float sums[piece] = {};
        for (std::size_t i = 0; i < weights.size(); ++i) {
            const float* source = from[i] + x;
            for (std::size_t k = 0; k < piece; ++k) {
                sums[k] += weights[i] * source[k];
            }
        }
        std::copy_n(sums, piece, to + x);
    }
    for (; x < width; ++x) {
        float sum = 0.0f;
        for (std::size_t i = 0; i < weights.size(); ++i) {
            sum += weights[i] * from[i][x];
        }
        to[x] = sum;
    }
}

}  // namespace

Plane filter_rows(const Plane& plane, const std::vector<float>& weights) {
    const std::size_t radius = weights.size() / 2, width = static_cast<std::size_t>(plane.width);
    Plane result(plane.width, plane.height);
    std::vector<float> padded(width + 2 * radius);
    std::vector<const float*> shifted;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        shifted.push_back(padded.data() + i);
    }
    for (int y = 0; y < plane.height; ++y) {
        const float* from = plane.row(y);
        std::fill_n(padded.data(), radius, from[0]);
        std::copy_n(from, width, padded.data() + radius);
        std::fill_n(padded.data() + radius + width, radius, from[width - 1]);
        sum_weighted(shifted, weights, result.row(y), width);
    }
    return result;
}

Plane filter_columns(const Plane& plane, const std::vector<float>& weights) {
    const int radius = static_cast<int>(weights.size() / 2);
    Plane result(plane.width, plane.height);
    std::vector<const float*> rows(weights.size());
    for (int y = 0; y < plane.height; ++y) {
        for (int i = -radius; i <= radius; ++i) {
            rows[static_cast<std::size_t>(i + radius)] = plane.row(std::clamp(y + i, 0, plane.height - 1));
        }
        sum_weighted(rows, weights, result.row(y), static_cast<std::size_t>(plane.width));
    }
    return result;
}

}  // namespace lancer
