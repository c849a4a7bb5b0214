#include "lancer/render/paths.h"

#include <algorithm>
#include <bit>

namespace lancer {

namespace {

constexpr int most_samples = 16;  // of a pixel in one pass

}  // namespace

PathPass next_pass(int samples, int spp) {
    // 1, 1, 2, 4, 8, 16, 16, ...: every pass but the first begins at a multiple of its length, where sample points are spread best.
    const int end = samples < most_samples ? static_cast<int>(std::bit_ceil(static_cast<unsigned>(samples) + 1u))
                                           : (samples / most_samples + 1) * most_samples;
    return {samples, std::max(0, std::min(end, spp) - samples)};
}

void PathTracer::trace(const PathRange& range, RayCounts& counts) {
    range_ = range;
    radiance_.resize(range.paths());
    direct_.resize(layers_.direct ? range.paths() : 0);
    first_hits_.resize(layers_.first_hits() ? range.paths() : 0);
    spectra_.resize(layers_.spectral_bins > 0 ? range.paths() : 0);
    splats_.clear();
    device_.trace_paths(range, {radiance_, direct_, first_hits_, spectra_, layers_.splats ? &splats_ : nullptr}, counts);
}

void PathTracer::put(FilmState& state, int left, int top) {
    Film& film = state.film();
    FilmSums& sums = *state.sums();
    const PathSamples samples{radiance_, direct_, first_hits_, spectra_, nullptr};
    if (sums.splats() != nullptr) {
        sums.splats()->add(splats_, range_.paths());
    }
    const std::size_t count = static_cast<std::size_t>(range_.sample_count);
    std::size_t next = 0;
    for (int y = range_.y0; y < range_.y1; ++y) {
        for (int x = range_.x0; x < range_.x1; ++x) {
            const std::size_t pixel = film.index(x - left, y - top);
            sums.add(pixel, samples.part(next, count));
            next += count;
            film.radiance[pixel] = sums.mean(pixel);
            film.samples[pixel] = static_cast<std::uint32_t>(range_.first_sample + range_.sample_count);
        }
    }
}

RoundOutcome PathSampler::render_round(FilmState& state, std::size_t tile, RayCounts& counts, const std::atomic<bool>* cancel) {
    const Tile& place = state.tiles()[tile];
    const int samples = static_cast<int>(state.film().samples[state.film().index(place.x0, place.y0)]);
    const PathPass pass = next_pass(samples, spp_);
    if (pass.sample_count == 0) {
        return RoundOutcome::finished;
    }
    if (is_cancelled(cancel)) {
        return RoundOutcome::cancelled;
    }
    tracer_.trace({place.x0, place.y0, place.x1, place.y1, pass.first_sample, pass.sample_count}, counts);
    samples_left_ = static_cast<double>(spp_ - pass.first_sample - pass.sample_count) * place.width() * place.height();
    const auto lock = state.lock(tile);
    tracer_.put(state);
    state.add_round(tile);
    return pass.first_sample + pass.sample_count < spp_ ? RoundOutcome::unfinished : RoundOutcome::finished;
}

}  // namespace lancer
