#include "lancer/render/paths.h"

#include <algorithm>

namespace lancer {

namespace {

constexpr int most_samples = 16;  // of a pixel in one pass

}  // namespace

std::vector<PathPass> path_passes(int spp) {
    std::vector<PathPass> passes;
    for (int first = 0; first < spp;) {
        // 1, 1, 2, 4, 8, 16, 16, ...: every pass but the first begins at a multiple of its length, where sample points are spread best.
        const int count = std::min({std::max(first, 1), most_samples, spp - first});
        passes.push_back({first, count});
        first += count;
    }
    return passes;
}

bool PathSampler::render_tile(const Tile& tile, Film& film, RayCounts& counts, const std::atomic<bool>* cancel) {
    if (is_cancelled(cancel)) {
        return false;
    }
    const PathRange range{tile.x0, tile.y0, tile.x1, tile.y1, pass_.first_sample, pass_.sample_count};
    radiance_.resize(range.paths());
    device_.follow_paths(range, radiance_, counts);
    const double samples = static_cast<double>(pass_.first_sample) + static_cast<double>(pass_.sample_count);
    std::size_t next = 0;
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            glm::dvec3 sum(0.0);
            for (int i = 0; i < pass_.sample_count; ++i) {
                const glm::vec3& c = radiance_[next++];
                sum.x += static_cast<double>(c.x);
                sum.y += static_cast<double>(c.y);
                sum.z += static_cast<double>(c.z);
            }
            const std::size_t pixel = film.index(x, y);
            sums_[pixel] += sum;
            film.radiance[pixel] = glm::vec3(sums_[pixel] / samples);
            film.samples[pixel] = static_cast<std::uint32_t>(pass_.first_sample + pass_.sample_count);
        }
    }
    return true;
}

}  // namespace lancer
