#include "lancer/render/bad_samples.h"

#include <algorithm>
#include <cmath>

namespace lancer {

BadSamples::BadSamples(const Device& device, const FilmState& state) {
    if (state.sums() == nullptr) {
        return;
    }
    const Film& film = state.film();
    for (int y = 0; y < film.height; ++y) {
        for (int x = 0; x < film.width; ++x) {
            const std::size_t pixel = film.index(x, y);
            const std::uint32_t bad = film.samples[pixel] - state.sums()->count(pixel);
            count_ += bad;
            if (bad > 0 && first_.size() < kept) {
                look_for(device, x, y, static_cast<int>(film.samples[pixel]));
            }
        }
    }
}

void BadSamples::look_for(const Device& device, int x, int y, int samples) {
    constexpr int at_once = 1024;
    for (int first = 0; first < samples && first_.size() < kept; first += at_once) {
        std::vector<glm::vec3> radiance(static_cast<std::size_t>(std::min(at_once, samples - first)));
        RayCounts ignored;
        device.follow_paths({x, y, x + 1, y + 1, first, static_cast<int>(radiance.size())}, radiance, ignored);
        for (std::size_t i = 0; i < radiance.size() && first_.size() < kept; ++i) {
            if (std::isnan(radiance[i].x)) {
                const int sample = first + static_cast<int>(i);
                first_.push_back({x, y, sample, device.find_fault(x, y, sample)});
            }
        }
    }
}

}  // namespace lancer
