// Samples of the path integrator where the error is, until a goal is reached.
#pragma once

#include <optional>

#include "lancer/render/error_goal.h"
#include "lancer/render/paths.h"

namespace lancer {

class GoalPathSampler : public TileSampler {
public:
    // `state` has sums with runs. `limit`: samples a pixel that are not exceeded, a multiple of samples_of_level.
    GoalPathSampler(const Device& device, const FilmState& state, const ErrorGoal& goal, int limit);

    RoundOutcome render_round(FilmState& state, std::size_t tile, RayCounts& counts, const std::atomic<bool>* cancel) override;
    double samples_left() const override { return samples_left_; }

private:
    // The whole round takes place on a copy of the tile, and shows all at once: a round is decided by the tile as the round before has left it.
    bool extend(const Tile& part, int to_level, const Tile& whole, FilmState& copy, RayCounts& counts, const std::atomic<bool>* cancel);

    PathTracer tracer_;
    ErrorGoal goal_;
    IntervalRule rule_;
    FilmLayers layers_;
    int limit_;
    double samples_left_ = 0.0;
};

}  // namespace lancer
