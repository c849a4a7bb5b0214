#include "lancer/render/paths.h"

#include <algorithm>
#include <cmath>

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
    const FilmLayers& layers = sums_.layers();
    radiance_.resize(range.paths());
    direct_.resize(layers.direct ? range.paths() : 0);
    first_hits_.resize(layers.first_hits() ? range.paths() : 0);
    spectra_.resize(layers.spectral_bins > 0 ? range.paths() : 0);
    splats_.clear();
    SplatSums* const splats = sums_.splats();
    const PathSamples samples{radiance_, direct_, first_hits_, spectra_, splats != nullptr ? &splats_ : nullptr};
    device_.trace_paths(range, samples, counts);
    if (splats != nullptr) {
        splats->add(splats_, range.paths());
    }
    const std::size_t count = static_cast<std::size_t>(pass_.sample_count);
    std::size_t next = 0;
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            const std::size_t pixel = film.index(x, y);
            const std::uint32_t before = sums_.count(pixel);
            sums_.add(pixel, samples.part(next, count));
            if (sums_.count(pixel) - before < count) {
                note_bad(x, y, samples.radiance.subspan(next, count));
            }
            next += count;
            film.radiance[pixel] = sums_.mean(pixel);
            film.samples[pixel] = static_cast<std::uint32_t>(pass_.first_sample + pass_.sample_count);
        }
    }
    return true;
}

void PathSampler::note_bad(int x, int y, std::span<const glm::vec3> radiance) {
    for (std::size_t i = 0; i < radiance.size(); ++i) {
        if (std::isnan(radiance[i].x)) {
            bad_.add({x, y, pass_.first_sample + static_cast<int>(i), {}});
        }
    }
}

}  // namespace lancer
