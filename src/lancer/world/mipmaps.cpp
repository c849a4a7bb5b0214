#include "lancer/world/mipmaps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace lancer {

namespace {

// The old pixels that a new one covers, and how much of each: sizes that are odd make three.
struct Cover {
    int first = 0;
    int count = 0;
    float weights[4] = {};
};

std::vector<Cover> covers(int old_size, int new_size) {
    std::vector<Cover> all(static_cast<std::size_t>(new_size));
    const double ratio = static_cast<double>(old_size) / new_size;  // 1 to 3
    for (int i = 0; i < new_size; ++i) {
        const double begin = i * ratio;
        const double end = std::min((i + 1) * ratio, static_cast<double>(old_size));
        Cover& cover = all[static_cast<std::size_t>(i)];
        cover.first = static_cast<int>(begin);
        for (int k = cover.first; k < end && cover.count < 4; ++k) {
            const double part = std::min(end, k + 1.0) - std::max(begin, static_cast<double>(k));
            cover.weights[cover.count++] = static_cast<float>(part / ratio);
        }
    }
    return all;
}

}  // namespace

MipLevel half_as_large(const MipLevel& level) {
    MipLevel wide{std::max(level.width / 2, 1), level.height, {}};
    const auto old_row = static_cast<std::size_t>(level.width) * 4;
    const auto row = static_cast<std::size_t>(wide.width) * 4;
    wide.pixels.assign(row * static_cast<std::size_t>(level.height), 0.0f);
    const std::vector<Cover> columns = covers(level.width, wide.width);
    for (std::size_t y = 0; y < static_cast<std::size_t>(level.height); ++y) {
        for (std::size_t x = 0; x < columns.size(); ++x) {
            const Cover& cover = columns[x];
            for (int k = 0; k < cover.count; ++k) {
                for (std::size_t c = 0; c < 4; ++c) {
                    wide.pixels[y * row + 4 * x + c] +=
                        cover.weights[k] * level.pixels[y * old_row + 4 * static_cast<std::size_t>(cover.first + k) + c];
                }
            }
        }
    }
    MipLevel result{wide.width, std::max(level.height / 2, 1), {}};
    result.pixels.assign(row * static_cast<std::size_t>(result.height), 0.0f);
    const std::vector<Cover> rows = covers(level.height, result.height);
    for (std::size_t y = 0; y < rows.size(); ++y) {
        for (int k = 0; k < rows[y].count; ++k) {
            const float* from = &wide.pixels[static_cast<std::size_t>(rows[y].first + k) * row];
            for (std::size_t i = 0; i < row; ++i) {
                result.pixels[y * row + i] += rows[y].weights[k] * from[i];
            }
        }
    }
    return result;
}

}  // namespace lancer
