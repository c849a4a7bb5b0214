#include "lancer/render/uniform.h"

#include <algorithm>

#include "lancer/render/blocks.h"

namespace lancer {

namespace {

constexpr int batch_samples = 4096;

}  // namespace

SamplePattern::SamplePattern(int width, int height, int ssaa, int lanes) {
    const int fine_width = width * ssaa;
    const int fine_height = height * ssaa;
    points.reserve(static_cast<std::size_t>(fine_width) * static_cast<std::size_t>(fine_height));
    std::vector<std::uint32_t> slot_at(points.capacity());
    for_each_in_blocks(fine_width, fine_height, lanes, [&](int x, int y) {
        slot_at[static_cast<std::size_t>(y) * static_cast<std::size_t>(fine_width) + static_cast<std::size_t>(x)] =
            static_cast<std::uint32_t>(points.size());
        points.emplace_back(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
    });

    slots.reserve(points.size());
    for (int pixel_y = 0; pixel_y < height; ++pixel_y) {
        for (int pixel_x = 0; pixel_x < width; ++pixel_x) {
            for (int y = pixel_y * ssaa; y < (pixel_y + 1) * ssaa; ++y) {
                for (int x = pixel_x * ssaa; x < (pixel_x + 1) * ssaa; ++x) {
                    slots.push_back(
                        slot_at[static_cast<std::size_t>(y) * static_cast<std::size_t>(fine_width) + static_cast<std::size_t>(x)]);
                }
            }
        }
    }
}

UniformPatterns::UniformPatterns(int width, int height, int ssaa, int lanes) : ssaa_(ssaa) {
    const int pixels = std::max(1, batch_samples / (ssaa * ssaa));
    batch_width_ = std::min(tile_size, pixels);
    batch_height_ = std::clamp(pixels / batch_width_, 1, tile_size);

    // The sizes that occur: full batches, and what is left of a tile, for full tiles and for the last ones.
    const auto sizes = [](int picture, int batch) {
        std::vector<int> found;
        for (const int tile : {std::min(picture, tile_size), picture % tile_size}) {
            found.push_back(std::min(tile, batch));
            found.push_back(tile % batch);
        }
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        std::erase(found, 0);
        return found;
    };
    for (const int batch_height : sizes(height, batch_height_)) {
        for (const int batch_width : sizes(width, batch_width_)) {
            patterns_.try_emplace({batch_width, batch_height}, batch_width, batch_height, ssaa, lanes);
        }
    }
}

bool UniformSampler::render_tile(const Tile& tile, Film& film, RayCounts& counts, const std::atomic<bool>* cancel) {
    for (int y = tile.y0; y < tile.y1; y += patterns_.batch_height()) {
        for (int x = tile.x0; x < tile.x1; x += patterns_.batch_width()) {
            if (is_cancelled(cancel)) {
                return false;
            }
            render_batch({x, y, std::min(x + patterns_.batch_width(), tile.x1), std::min(y + patterns_.batch_height(), tile.y1)}, film,
                         counts);
        }
    }
    return true;
}

void UniformSampler::render_batch(const Tile& batch, Film& film, RayCounts& counts) {
    const SamplePattern& pattern = patterns_.pattern(batch.width(), batch.height());
    const int ssaa = patterns_.ssaa();
    const std::size_t count = pattern.points.size();
    if (points_.size() < count) {
        points_.resize(count);
        radiance_.resize(count);
    }

    // Places on the finer grid are exact in float; so a sample's place does not depend on the batch it belongs to.
    const glm::vec2 corner(static_cast<float>(batch.x0 * ssaa), static_cast<float>(batch.y0 * ssaa));
    const float scale = 1.0f / static_cast<float>(ssaa);
    for (std::size_t i = 0; i < count; ++i) {
        points_[i] = (corner + pattern.points[i]) * scale;
    }
    device_.follow(std::span(points_).first(count), std::span(radiance_).first(count), counts);

    // Sums of rows of samples, then the sum of these: one order, whatever the lanes, and less rounding than one long sum.
    const float weight = 1.0f / static_cast<float>(ssaa * ssaa);
    const std::uint32_t* slot = pattern.slots.data();
    for (int y = batch.y0; y < batch.y1; ++y) {
        for (int x = batch.x0; x < batch.x1; ++x) {
            glm::vec3 sum(0.0f);
            for (int sub_y = 0; sub_y < ssaa; ++sub_y) {
                glm::vec3 row(0.0f);
                for (int sub_x = 0; sub_x < ssaa; ++sub_x) {
                    row += radiance_[*slot++];
                }
                sum += row;
            }
            const std::size_t pixel = film.index(x, y);
            film.radiance[pixel] = sum * weight;
            film.samples[pixel] = static_cast<std::uint32_t>(ssaa * ssaa);
        }
    }
}

}  // namespace lancer
