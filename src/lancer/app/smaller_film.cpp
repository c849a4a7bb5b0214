#include "lancer/app/smaller_film.h"

#include <vector>

namespace lancer::app {

void SmallerFilm::follow(std::span<const glm::vec2> points, std::span<glm::vec3> radiance, RayCounts& counts) const {
    std::vector<glm::vec2> scaled(points.begin(), points.end());
    for (glm::vec2& point : scaled) {
        point *= factor_;
    }
    device_.follow(scaled, radiance, counts);
}

Preview render_preview(const Prepared& prepared, int factor, const std::atomic<bool>* cancel) {
    RenderOptions coarse = prepared.options;
    coarse.width = (coarse.width + factor - 1) / factor;
    coarse.height = (coarse.height + factor - 1) / factor;
    coarse.ssaa = 1;
    coarse.adaptive = false;
    Preview preview{Film(coarse.width, coarse.height), {}};
    preview.statistics = render(SmallerFilm(*prepared.device, factor), coarse, preview.film, nullptr, cancel);
    return preview;
}

}  // namespace lancer::app
