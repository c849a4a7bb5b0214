#include "lancer/app/smaller_film.h"

#include <algorithm>
#include <vector>

namespace lancer::app {

void SmallerFilm::follow(std::span<const glm::vec2> points, std::span<glm::vec3> radiance, RayCounts& counts) const {
    std::vector<glm::vec2> scaled(points.begin(), points.end());
    for (glm::vec2& point : scaled) {
        point *= static_cast<float>(factor_);
    }
    device_.follow(scaled, radiance, counts);
}

// A pixel stands for the block of pixels around it.
void SmallerFilm::trace_paths(const PathRange& range, const PathSamples& samples, RayCounts& counts) const {
    std::size_t next = 0;
    for (int y = range.y0; y < range.y1; ++y) {
        for (int x = range.x0; x < range.x1; ++x) {
            const PathRange one{x * factor_, y * factor_, x * factor_ + 1, y * factor_ + 1, range.first_sample, range.sample_count};
            device_.trace_paths(one, samples.part(next, one.paths()), counts);
            next += one.paths();
        }
    }
}

Preview render_preview(const Prepared& prepared, int factor, const std::atomic<bool>* cancel) {
    RenderOptions coarse = prepared.options;
    coarse.width = (coarse.width + factor - 1) / factor;
    coarse.height = (coarse.height + factor - 1) / factor;
    coarse.ssaa = 1;
    coarse.spp = std::min(coarse.spp, 1);
    coarse.adaptive = false;
    Preview preview{Film(coarse.width, coarse.height), {}};
    preview.statistics = render(SmallerFilm(*prepared.device, factor), coarse, preview.film, nullptr, cancel);
    return preview;
}

}  // namespace lancer::app
