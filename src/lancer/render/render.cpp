#include "lancer/render/render.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "lancer/film/display.h"
#include "lancer/render/adaptive.h"
#include "lancer/render/paths.h"
#include "lancer/render/threads.h"
#include "lancer/render/uniform.h"

namespace lancer {

namespace {

using Clock = std::chrono::steady_clock;

FilmLayers splat_layers(const Device& device) {
    FilmLayers layers;
    layers.splats = device.makes_splats();
    return layers;
}

// One render: the tiles that are left, and what the threads have found so far.
class Work {
public:
    Work(const Device& device, const RenderOptions& options, Film& film, RenderObserver* observer, const std::atomic<bool>* cancel,
         FilmSums* sums)
        : device_(device), options_(options), film_(film), observer_(observer), cancel_(cancel), curve_(options.exposure) {
        passes_ = options.spp > 0 ? path_passes(options.spp) : std::vector<PathPass>{{0, 1}};
        if (options.spp > 0) {
            sums_ = sums;
            if (sums == nullptr) {
                sums_ = &own_sums_.emplace(options.width, options.height, splat_layers(device));
            }
        } else if (!options.adaptive) {
            patterns_.emplace(options.width, options.height, options.ssaa, device.lanes());
        }
        tiles_ = cut_tiles(options.width, options.height,
                           options.spp > 0    ? PathSampler::tile_size
                           : options.adaptive ? AdaptiveSampler::tile_size(options.adaptive_depth)
                                              : UniformPatterns::tile_size);
        if (options.shuffle != 0) {
            shuffle_tiles(tiles_, options.shuffle);
        }
        progress_.pixels_total = static_cast<std::int64_t>(options.width) * options.height * std::max(options.spp, 1);
    }

    // All passes, one after another, each on all threads.
    void run(int threads) {
        for (const PathPass& pass : passes_) {
            pass_ = pass;
            next_tile_ = 0;
            run_on_threads(threads, [&] { take_tiles(); });
        }
        if (sums_ != nullptr && sums_->splats() != nullptr) {
            // What fell on a pixel after its own last sample.
            for (std::size_t i = 0; i < film_.radiance.size(); ++i) {
                film_.radiance[i] = sums_->mean(i);
            }
        }
    }

private:
    // What one thread does: takes tiles until none is left.
    void take_tiles() {
        RayCounts counts;
        BadSamples bad_samples;
        const std::unique_ptr<TileSampler> sampler = make_sampler(bad_samples);
        std::uint64_t bad = 0;
        std::size_t first_bad = no_pixel;
        while (!is_cancelled(cancel_)) {
            const std::size_t next = next_tile_.fetch_add(1, std::memory_order_relaxed);
            if (next >= tiles_.size()) {
                break;
            }
            const Tile& tile = tiles_[next];
            const std::uint64_t samples_before = counts.camera;
            if (!sampler->render_tile(tile, film_, counts, cancel_)) {
                break;
            }
            for (int y = tile.y0; y < tile.y1; ++y) {
                for (std::size_t i = film_.index(tile.x0, y); i < film_.index(tile.x0, y) + static_cast<std::size_t>(tile.width()); ++i) {
                    const glm::vec3& c = film_.radiance[i];
                    if (!(std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z))) {
                        ++bad;
                        first_bad = std::min(first_bad, i);
                    }
                }
            }
            tell(tile, counts.camera - samples_before);
        }
        const std::scoped_lock lock(mutex_);
        counts_ += counts;
        bad_samples_.add(bad_samples);
        bad_ += bad;
        first_bad_ = std::min(first_bad_, first_bad);
    }

public:
    RenderStatistics statistics() const {
        RenderStatistics result;
        result.rays = counts_;
        result.samples = progress_.samples_done;
        result.seconds = seconds();
        result.finished = progress_.pixels_done == progress_.pixels_total;
        result.bad_samples = bad_samples_;
        result.bad_samples.find_faults(device_);
        result.bad_pixels = bad_;
        if (first_bad_ != no_pixel) {
            result.bad_x = static_cast<int>(first_bad_ % static_cast<std::size_t>(options_.width));
            result.bad_y = static_cast<int>(first_bad_ / static_cast<std::size_t>(options_.width));
        }
        return result;
    }

private:
    static constexpr std::size_t no_pixel = std::numeric_limits<std::size_t>::max();

    std::unique_ptr<TileSampler> make_sampler(BadSamples& bad) {
        if (options_.spp > 0) {
            return std::make_unique<PathSampler>(device_, pass_, *sums_, bad);
        }
        if (options_.adaptive) {
            const AdaptiveOptions adaptive = {options_.adaptive_threshold, options_.adaptive_depth};
            return std::make_unique<AdaptiveSampler>(device_, adaptive, curve_);
        }
        return std::make_unique<UniformSampler>(device_, *patterns_);
    }

    void tell(const Tile& tile, std::uint64_t samples) {
        const std::scoped_lock lock(mutex_);
        progress_.pixels_done += static_cast<std::int64_t>(tile.width()) * tile.height() * pass_.sample_count;
        progress_.samples_done += samples;
        if (observer_ != nullptr) {
            progress_.seconds = seconds();
            const double left = static_cast<double>(progress_.pixels_total - progress_.pixels_done);
            progress_.seconds_left = progress_.seconds * left / static_cast<double>(progress_.pixels_done);
            observer_->tile_done(film_, tile, progress_);
        }
    }

    double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

    const Device& device_;
    const RenderOptions& options_;
    Film& film_;
    RenderObserver* observer_;
    const std::atomic<bool>* cancel_;
    DisplayCurve curve_;
    std::optional<UniformPatterns> patterns_;
    std::vector<PathPass> passes_;
    PathPass pass_;
    std::optional<FilmSums> own_sums_;  // where nobody else wants them
    FilmSums* sums_ = nullptr;
    std::vector<Tile> tiles_;
    Clock::time_point start_ = Clock::now();

    std::atomic<std::size_t> next_tile_{0};
    std::mutex mutex_;  // guards what follows, and lets one thread at a time speak to the observer
    RenderProgress progress_;
    RayCounts counts_;
    BadSamples bad_samples_;
    std::uint64_t bad_ = 0;
    std::size_t first_bad_ = no_pixel;
};

}  // namespace

int hardware_threads() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

RenderStatistics render(const Device& device, const RenderOptions& options, Film& film, RenderObserver* observer,
                        const std::atomic<bool>* cancel, FilmSums* sums) {
    assert(options.width >= 1 && options.height >= 1 && film.width == options.width && film.height == options.height);
    assert(options.ssaa >= 1 && options.ssaa <= max_ssaa);
    assert(options.adaptive_depth >= 0 && options.adaptive_depth <= max_adaptive_depth);
    assert(options.threads >= 0 && options.threads <= max_threads);

    assert(sums == nullptr || (sums->width() == options.width && sums->height() == options.height));

    Work work(device, options, film, observer, cancel, sums);
    const int threads = options.threads > 0 ? options.threads : hardware_threads();
    work.run(threads);
    RenderStatistics result = work.statistics();
    result.threads = threads;
    return result;
}

}  // namespace lancer
