// Takes the samples of one tile and puts its pixels into the film. One object for each thread: it keeps its buffers from tile to tile.
#pragma once

#include <atomic>

#include "lancer/device/device.h"
#include "lancer/film/film.h"
#include "lancer/render/tiles.h"

namespace lancer {

// `cancel` may be null.
inline bool is_cancelled(const std::atomic<bool>* cancel) { return cancel != nullptr && cancel->load(std::memory_order_relaxed); }

class TileSampler {
public:
    virtual ~TileSampler() = default;

    // False when it was cancelled on the way; the tile's pixels then stay as they were, or are final.
    virtual bool render_tile(const Tile& tile, Film& film, RayCounts& counts, const std::atomic<bool>* cancel) = 0;
};

}  // namespace lancer
