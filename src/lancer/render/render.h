// Which work next: cuts the picture into tiles, has a device follow their samples on all threads, and keeps count.
// The same settings give the same bytes whatever the number of threads, the order of the tiles, and the machines that share them.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>

#include "lancer/device/device.h"
#include "lancer/film/film.h"
#include "lancer/film/film_state.h"
#include "lancer/film/film_sums.h"
#include "lancer/film/tiles.h"
#include "lancer/render/bad_samples.h"
#include "lancer/render/error_goal.h"

namespace lancer {

struct RenderOptions {
    int width = 1280;
    int height = 720;
    int threads = 0;                   // 0: as many as the machine has, one where that can't be known
    int spp = 0;                       // samples a pixel of the path integrator; 0: Whitted's, with what follows
    int ssaa = 1;                      // ssaa x ssaa samples a pixel on a regular grid
    bool adaptive = false;             // instead of ssaa: subdivide where neighbours differ
    double adaptive_threshold = 0.03;  // difference of display values in [0, 1] that makes a cell be cut in four
    int adaptive_depth = 3;            // how often at most
    double exposure = 0.0;             // stops; the comparison is made after it
    std::uint32_t shuffle = 0;         // 0: tiles row by row; otherwise the seed of another order. The picture is the same
    bool intervals = false;            // of the path integrator: the error is to be known
    ErrorGoal goal;                    // where goal.error > 0, `spp` is what is not exceeded
    double seconds = 0.0;              // after which the render ends; 0: none
    int shard = 1;                     // of `shards` shares of the tiles, only this one is rendered
    int shards = 1;
};

constexpr int max_ssaa = 64;
constexpr int max_adaptive_depth = 8;
constexpr int max_threads = 1024;
constexpr int max_shards = 1000000;

// The side of the tiles that a film is cut into for these options, in pixels.
int tile_size_for(const RenderOptions& options);

// Which of `shards` shares of the work each tile of a picture belongs to, from 1 on: as good as at random, so that each share has its part of what
// is hard, and as even as the number of tiles allows.
std::vector<int> shards_of_tiles(std::size_t tiles, int shards);

// Whether nothing is left to do for a tile.
bool is_finished(const RenderOptions& options, const FilmState& state, std::size_t tile);

// What a render tells while it runs. Called from worker threads, one call at a time.
struct RenderProgress {
    std::int64_t pixels_done = 0;    // paths: times the samples of each
    std::int64_t pixels_total = 0;   // at most
    std::uint64_t samples_done = 0;  // camera samples, since the start
    double share = 0.0;              // of all that is to be done, in [0, 1]; estimated where that is not known
    double seconds = 0.0;            // since the start
    double seconds_left = 0.0;       // estimated
    double error = 0.0;  // of a render with a goal, after each round: reached so far for the wanted share of pixels; 0: not known yet
};

struct RenderStatistics {
    RayCounts rays;
    std::uint64_t samples = 0;  // camera samples
    double seconds = 0.0;
    int threads = 0;
    bool finished = false;     // false when cancelled
    bool out_of_time = false;  // options.seconds were over first
    ErrorReport error;         // where it is known
    double clamped = 0.0;      // share of the picture's light that clamping took away

    // Samples of the path integrator that were left out of the picture.
    BadSamples bad_samples;

    // Pixels with a NaN or infinite channel: something is wrong with the scene or with us. `bad_x`, `bad_y`: the first of them, row by row.
    std::uint64_t bad_pixels = 0;
    int bad_x = -1;
    int bad_y = -1;
};

class RenderObserver {
public:
    virtual ~RenderObserver() = default;
    // The tile's pixels stand in `film`, final or as good as they are so far (paths); other pixels may be in the making.
    virtual void tile_done(const Film& film, const Tile& tile, const RenderProgress& progress) = 0;
};

// Goes on with a film, which has the options' size and tiles, and sums of samples for the path integrator alone: from nothing, or from what it has.
// Stops soon after `cancel` becomes true; all work that was done is in the film then. `observer` and `cancel` may be null. The options must be in
// range (ssaa, depth and threads up to the limits above, sizes at least 1).
RenderStatistics render(const Device& device, const RenderOptions& options, FilmState& state, RenderObserver* observer = nullptr,
                        const std::atomic<bool>* cancel = nullptr);

// From nothing into `film`. `sums`, if not null, empty and of the film's size, receives what the path integrator's picture rests on.
RenderStatistics render(const Device& device, const RenderOptions& options, Film& film, RenderObserver* observer = nullptr,
                        const std::atomic<bool>* cancel = nullptr, FilmSums* sums = nullptr);

// The machine's hardware threads, at least 1.
int hardware_threads();

}  // namespace lancer
