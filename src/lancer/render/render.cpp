#include "lancer/render/render.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <chrono>
#include <cmath>
#include <memory>
#include <mutex>
#include <numeric>
#include <optional>
#include <thread>
#include <vector>

#include "lancer/base/thread_clock.h"
#include "lancer/film/display.h"
#include "lancer/film/luminance.h"
#include "lancer/render/adaptive.h"
#include "lancer/render/goal_paths.h"
#include "lancer/render/paths.h"
#include "lancer/render/threads.h"
#include "lancer/render/time_left.h"
#include "lancer/render/uniform.h"

namespace lancer {

namespace {

using Clock = std::chrono::steady_clock;

// Samples of a pixel that are not exceeded: whole levels where there is a goal. 0 where paths are not what is followed.
int samples_limit(const RenderOptions& options) {
    return options.goal.error > 0.0 ? std::max(1, (options.spp + samples_of_level - 1) / samples_of_level) * samples_of_level : options.spp;
}

// One render: the tiles that are left, and what the threads have found so far.
class Work {
public:
    Work(const Device& device, const RenderOptions& options, FilmState& state, RenderObserver* observer, const std::atomic<bool>* cancel)
        : device_(device), options_(options), state_(state), observer_(observer), cancel_(cancel), curve_(options.exposure) {
        if (options.spp == 0 && !options.adaptive) {
            patterns_.emplace(options.width, options.height, options.ssaa, device.lanes());
        }
        left_ = own_tiles();
        for (const std::size_t tile : left_) {
            const Tile& place = state.tiles()[tile];
            progress_.pixels_total += area(place) * std::max(samples_limit(options_), 1);
            progress_.pixels_done += done_before(tile);
        }
        begin_to_foresee();
    }

    // Round after round, each on all threads, until no tile is left.
    void run(int threads) {
        while (!left_.empty() && !stops()) {
            next_ = 0;
            unfinished_.assign(left_.size(), 1);
            run_on_threads(threads, [&] { take_tiles(); });
            std::size_t kept = 0;
            for (std::size_t i = 0; i < left_.size(); ++i) {
                if (unfinished_[i] != 0) {
                    left_[kept++] = left_[i];
                }
            }
            left_.resize(kept);
            if (options_.goal.error > 0.0 && observer_ != nullptr) {
                progress_.error = report_errors(options_.goal, state_).reached;
            }
        }
        state_.show_splats();  // what fell on a pixel after its own last sample
    }

    RenderStatistics statistics() const {
        RenderStatistics result;
        result.rays = counts_;
        result.samples = progress_.samples_done;
        result.seconds = seconds();
        result.out_of_time = !left_.empty() && is_out_of_time();
        result.finished = left_.empty() || (result.out_of_time && !is_cancelled(cancel_));
        result.error = report_errors(options_.goal, state_);
        result.clamped = clamped_share();
        result.bad_samples = BadSamples(device_, state_);
        const Film& film = state_.film();
        for (int y = 0; y < film.height; ++y) {
            for (int x = 0; x < film.width; ++x) {
                const glm::vec3& c = film.radiance[film.index(x, y)];
                if (!(std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z)) && result.bad_pixels++ == 0) {
                    result.bad_x = x;
                    result.bad_y = y;
                }
            }
        }
        return result;
    }

private:
    bool is_out_of_time() const { return options_.seconds > 0.0 && seconds() >= options_.seconds; }
    bool stops() const { return is_cancelled(cancel_) || is_out_of_time(); }

    double clamped_share() const {
        double removed = 0.0, kept = 0.0;
        for (std::size_t pixel = 0; options_.spp > 0 && pixel < state_.film().radiance.size(); ++pixel) {
            removed += state_.sums()->clamped(pixel);
            const glm::vec3 light = state_.sums()->mean(pixel);
            kept += luminance(glm::dvec3(light));
        }
        return removed > 0.0 ? removed / (removed + kept) : 0.0;
    }

    static std::int64_t area(const Tile& tile) { return static_cast<std::int64_t>(tile.width()) * tile.height(); }

    std::vector<std::size_t> own_tiles() const {
        std::vector<std::size_t> order(state_.tiles().size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        if (options_.shuffle != 0) {
            shuffle(order, options_.shuffle);
        }
        const std::vector<int> shards = shards_of_tiles(order.size(), options_.shards);
        std::erase_if(order, [&](std::size_t tile) { return shards[tile] != options_.shard; });
        return order;
    }

    std::int64_t done_before(std::size_t tile) const {
        const Tile& place = state_.tiles()[tile];
        if (options_.spp == 0) {
            return state_.rounds(tile) > 0 ? area(place) : 0;
        }
        std::int64_t samples = 0;
        for (int y = place.y0; y < place.y1; ++y) {
            for (int x = place.x0; x < place.x1; ++x) {
                samples += std::min(static_cast<std::int64_t>(state_.film().samples[state_.film().index(x, y)]),
                                    std::int64_t{samples_limit(options_)});
            }
        }
        return samples;
    }

    // What one thread does: takes tiles until none is left.
    void take_tiles() {
        RayCounts counts;
        const std::unique_ptr<TileSampler> sampler = make_sampler();
        while (!stops()) {
            const std::size_t next = next_.fetch_add(1, std::memory_order_relaxed);
            if (next >= left_.size()) {
                break;
            }
            const std::uint64_t rays_before = counts.camera;
            const std::int64_t done = done_before(left_[next]);
            const double worked = thread_seconds();
            const RoundOutcome outcome = sampler->render_round(state_, left_[next], counts, cancel_);
            if (outcome == RoundOutcome::cancelled) {
                break;
            }
            unfinished_[next] = outcome == RoundOutcome::unfinished ? 1 : 0;
            if (const std::int64_t more = done_before(left_[next]) - done; more > 0) {
                // Of paths the samples count, and not the rays: those that start at lamps reach the camera by many.
                const std::uint64_t samples = options_.spp > 0 ? static_cast<std::uint64_t>(more) : counts.camera - rays_before;
                tell(left_[next], more, samples, thread_seconds() - worked, sampler->samples_left());
            } else {
                const std::scoped_lock lock(mutex_);
                time_left_.skip(left_[next]);
            }
        }
        const std::scoped_lock lock(mutex_);
        counts_ += counts;
    }

    std::unique_ptr<TileSampler> make_sampler() {
        if (options_.goal.error > 0.0) {
            return std::make_unique<GoalPathSampler>(device_, state_, options_.goal, samples_limit(options_));
        }
        if (options_.spp > 0) {
            return std::make_unique<PathSampler>(device_, state_, options_.spp);
        }
        if (options_.adaptive) {
            const AdaptiveOptions adaptive = {options_.adaptive_threshold, options_.adaptive_depth};
            return std::make_unique<AdaptiveSampler>(device_, adaptive, curve_);
        }
        return std::make_unique<UniformSampler>(device_, *patterns_);
    }

    void tell(std::size_t tile, std::int64_t pixels, std::uint64_t samples, double work, double samples_left) {
        const std::scoped_lock lock(mutex_);
        progress_.pixels_done += pixels;
        progress_.samples_done += samples;
        time_left_.add(tile, work, static_cast<double>(pixels), samples_left);
        if (observer_ != nullptr) {
            progress_.seconds = seconds();
            progress_.seconds_left = time_left_.seconds(progress_.seconds);
            if (options_.seconds > 0.0) {
                progress_.seconds_left = std::clamp(options_.seconds - progress_.seconds, 0.0, progress_.seconds_left);
            }
            progress_.share = share_done();
            observer_->tile_done(state_.film(), state_.tiles()[tile], progress_);
        }
    }

    // Where the number of samples is known, all that are there count; otherwise the work.
    double share_done() const {
        if (options_.goal.error == 0.0 && options_.seconds == 0.0) {
            return static_cast<double>(progress_.pixels_done) / static_cast<double>(progress_.pixels_total);
        }
        return std::max(progress_.seconds / std::max(progress_.seconds + progress_.seconds_left, 1e-9), progress_.share);
    }

    void begin_to_foresee() {
        std::vector<double> sizes(state_.tiles().size(), 0.0);
        for (const std::size_t tile : left_) {
            sizes[tile] = static_cast<double>(area(state_.tiles()[tile]));
        }
        time_left_ = TimeLeft(sizes);
        const std::vector<double>& expected = options_.goal.plan.expected;
        if (options_.goal.error > 0.0 && expected.empty()) {
            return;
        }
        for (const std::size_t tile : left_) {
            const double all =
                options_.goal.error > 0.0 ? expected[tile] : static_cast<double>(area(state_.tiles()[tile])) * std::max(options_.spp, 1);
            time_left_.expect(tile, std::max(all - static_cast<double>(done_before(tile)), 0.0));
        }
    }

    double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

    const Device& device_;
    const RenderOptions& options_;
    FilmState& state_;
    RenderObserver* observer_;
    const std::atomic<bool>* cancel_;
    DisplayCurve curve_;
    std::optional<UniformPatterns> patterns_;
    std::vector<std::size_t> left_;  // tiles that are not finished, in the order of work
    std::vector<char> unfinished_;   // of these: whether they are left after this round
    Clock::time_point start_ = Clock::now();

    std::atomic<std::size_t> next_{0};
    std::mutex mutex_;  // guards what follows, and lets one thread at a time speak to the observer
    RenderProgress progress_;
    TimeLeft time_left_{{}};
    RayCounts counts_;
};

}  // namespace

int hardware_threads() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

int tile_size_for(const RenderOptions& options) {
    return options.spp > 0    ? PathSampler::tile_size
           : options.adaptive ? AdaptiveSampler::tile_size(options.adaptive_depth)
                              : UniformPatterns::tile_size;
}

std::vector<int> shards_of_tiles(std::size_t tiles, int shards) {
    constexpr std::uint32_t deal = 0x5eed;  // one for all: every machine deals the same way
    std::vector<std::size_t> order(tiles);
    std::iota(order.begin(), order.end(), std::size_t{0});
    shuffle(order, deal);
    std::vector<int> owners(tiles, 1);
    for (std::size_t i = 0; i < tiles && shards > 1; ++i) {
        owners[order[i]] = static_cast<int>(i % static_cast<std::size_t>(shards)) + 1;
    }
    return owners;
}

bool is_finished(const RenderOptions& options, const FilmState& state, std::size_t tile) {
    const Tile& place = state.tiles()[tile];
    if (const ErrorGoal& goal = options.goal; goal.error > 0.0) {
        return wanting_cells(goal, IntervalRule(goal.confidence, goal.floor), state, tile, samples_limit(options)).empty();
    }
    return options.spp == 0 ? state.rounds(tile) > 0
                            : state.film().samples[state.film().index(place.x0, place.y0)] >= static_cast<std::uint32_t>(options.spp);
}

RenderStatistics render(const Device& device, const RenderOptions& options, FilmState& state, RenderObserver* observer,
                        const std::atomic<bool>* cancel) {
    assert(options.width >= 1 && options.height >= 1 && state.film().width == options.width && state.film().height == options.height);
    assert(options.ssaa >= 1 && options.ssaa <= max_ssaa);
    assert(options.adaptive_depth >= 0 && options.adaptive_depth <= max_adaptive_depth);
    assert(options.threads >= 0 && options.threads <= max_threads);
    assert(options.shard >= 1 && options.shard <= options.shards && options.shards <= max_shards);
    assert((state.sums() != nullptr) == (options.spp > 0) && state.tile_size() == tile_size_for(options));
    assert(options.goal.error == 0.0 || options.intervals);
    assert(!options.intervals || options.goal.floor > 0.0);
    assert(options.spp == 0 || state.sums()->layers().runs == options.intervals);

    Work work(device, options, state, observer, cancel);
    const int threads = options.threads > 0 ? options.threads : hardware_threads();
    work.run(threads);
    RenderStatistics result = work.statistics();
    result.threads = threads;
    return result;
}

RenderStatistics render(const Device& device, const RenderOptions& options, Film& film, RenderObserver* observer,
                        const std::atomic<bool>* cancel, FilmSums* sums) {
    std::optional<FilmSums> own;  // where nobody else wants them
    if (options.spp > 0 && sums == nullptr) {
        FilmLayers layers;
        layers.splats = device.makes_splats();
        layers.runs = options.intervals;
        sums = &own.emplace(options.width, options.height, layers);
    }
    FilmState state(film, options.spp > 0 ? sums : nullptr, tile_size_for(options));
    return render(device, options, state, observer, cancel);
}

}  // namespace lancer
