// Supersampling on a regular grid, k x k samples a pixel (report 4.2).
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lancer/render/sampler.h"

namespace lancer {

// The samples of a small rectangle of pixels, in the order in which a device likes them: blocks of neighbours, each as large as the device's lanes.
struct SamplePattern {
    std::vector<glm::vec2> points;     // in the k times finer grid, from the rectangle's corner: (0.5, 0.5) is the first
    std::vector<std::uint32_t> slots;  // pixel by pixel, row by row inside a pixel: which of `points`

    SamplePattern(int width, int height, int ssaa, int lanes);
};

// Patterns for all rectangles that the tiles of a picture are made of. Made once, read by all threads.
class UniformPatterns {
public:
    static constexpr int tile_size = 16;

    UniformPatterns(int width, int height, int ssaa, int lanes);

    int ssaa() const { return ssaa_; }
    // A tile is followed in rectangles of at most this many pixels, so that their samples stay in the nearest caches.
    int batch_width() const { return batch_width_; }
    int batch_height() const { return batch_height_; }
    const SamplePattern& pattern(int width, int height) const { return patterns_.at({width, height}); }

private:
    int ssaa_;
    int batch_width_;
    int batch_height_;
    std::map<std::pair<int, int>, SamplePattern> patterns_;
};

class UniformSampler : public WholeTileSampler {
public:
    UniformSampler(const Device& device, const UniformPatterns& patterns) : device_(device), patterns_(patterns) {}
    bool render_tile(const Tile& tile, Film& film, RayCounts& counts, const std::atomic<bool>* cancel) override;

private:
    void render_batch(const Tile& batch, Film& film, RayCounts& counts);

    const Device& device_;
    const UniformPatterns& patterns_;
    std::vector<glm::vec2> points_;
    std::vector<glm::vec3> radiance_;
};

}  // namespace lancer
