#include "lancer/render/goal_paths.h"

#include <algorithm>
#include <vector>

namespace lancer {

static_assert(PathSampler::tile_size == interval_block);  // so that tiles are decided by what the picture says of itself

GoalPathSampler::GoalPathSampler(const Device& device, const FilmState& state, const ErrorGoal& goal, int limit)
    : tracer_(device, state.sums()->layers()), goal_(goal), rule_(goal.confidence, goal.floor), layers_(state.sums()->layers()),
      limit_(limit) {}

bool GoalPathSampler::extend(const Tile& part, int to_level, const Tile& whole, FilmState& copy, RayCounts& counts,
                             const std::atomic<bool>* cancel) {
    // Not too many at once, for the memory's sake.
    constexpr int at_once = 8 * samples_of_level;
    int samples = static_cast<int>(copy.film().samples[copy.film().index(part.x0 - whole.x0, part.y0 - whole.y0)]);
    const int end = std::min(to_level * samples_of_level, limit_);
    while (samples < end) {
        if (is_cancelled(cancel)) {
            return false;
        }
        const int count = std::min(at_once, end - samples);
        tracer_.trace({part.x0, part.y0, part.x1, part.y1, samples, count}, counts);
        tracer_.put(copy, whole.x0, whole.y0);
        samples += count;
    }
    return true;
}

RoundOutcome GoalPathSampler::render_round(FilmState& state, std::size_t tile, RayCounts& counts, const std::atomic<bool>* cancel) {
    const Tile& place = state.tiles()[tile];
    const Film& film = state.film();
    const auto level_of = [&](const Tile& part) { return static_cast<int>(film.samples[film.index(part.x0, part.y0)]) / samples_of_level; };
    const bool whole = level_of(place) < first_decision;
    std::vector<std::size_t> cells;
    if (!whole) {
        cells = wanting_cells(goal_, rule_, state, tile, limit_);
    }
    samples_left_ = 0.0;
    if (whole ? level_of(place) * samples_of_level >= limit_ : cells.empty()) {
        return RoundOutcome::finished;
    }
    Film copied(place.width(), place.height());
    FilmSums sums(place.width(), place.height(), layers_);
    FilmState copy(copied, &sums, state.tile_size());
    ByteWriter before;
    state.save(tile, before);
    ByteReader reader(before.bytes());
    copy.load(0, 0, reader);
    bool complete = true;
    if (whole) {
        complete = extend(place, next_level(level_of(place)), place, copy, counts, cancel);
    }
    for (const std::size_t cell : cells) {
        const Tile part = cell_of(place, cell);
        complete = complete && extend(part, next_level(level_of(part)), place, copy, counts, cancel);
    }
    if (!complete) {
        return RoundOutcome::cancelled;
    }
    ByteWriter after;
    copy.save(0, after);
    {
        const auto lock = state.lock(tile);
        ByteReader back(after.bytes());
        state.load(tile, state.rounds(tile) + 1, back);
    }
    samples_left_ = foresee_samples(goal_, rule_, state, tile, limit_);
    return samples_left_ == 0.0 ? RoundOutcome::finished : RoundOutcome::unfinished;
}

}  // namespace lancer
