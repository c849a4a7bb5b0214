// Does the work on one tile and puts its pixels into the film. One object for each thread: it keeps its buffers from tile to tile.
#pragma once

#include <atomic>

#include "lancer/device/device.h"
#include "lancer/film/film_state.h"

namespace lancer {

// `cancel` may be null.
inline bool is_cancelled(const std::atomic<bool>* cancel) { return cancel != nullptr && cancel->load(std::memory_order_relaxed); }

enum class RoundOutcome { cancelled, unfinished, finished };

class TileSampler {
public:
    virtual ~TileSampler() = default;

    // One more round of work on a tile, or none where it is finished. When cancelled on the way, the tile's pixels count as before. Nobody else works
    // on the tile meanwhile; others may read it under its lock.
    virtual RoundOutcome render_round(FilmState& state, std::size_t tile, RayCounts& counts, const std::atomic<bool>* cancel) = 0;

    // How many samples that tile will still take, as far as can be told after that round.
    virtual double samples_left() const = 0;
};

// Work that is done in one round.
class WholeTileSampler : public TileSampler {
public:
    RoundOutcome render_round(FilmState& state, std::size_t tile, RayCounts& counts, const std::atomic<bool>* cancel) final {
        if (state.rounds(tile) == 0) {
            if (!render_tile(state.tiles()[tile], state.film(), counts, cancel)) {
                return RoundOutcome::cancelled;
            }
            const auto lock = state.lock(tile);
            state.add_round(tile);
        }
        return RoundOutcome::finished;
    }

    double samples_left() const final { return 0.0; }

    // False when it was cancelled on the way.
    virtual bool render_tile(const Tile& tile, Film& film, RayCounts& counts, const std::atomic<bool>* cancel) = 0;
};

}  // namespace lancer
