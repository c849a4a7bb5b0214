// When a picture is good enough, and where samples are missing: decided tile by tile, from the tile's own sums.
#pragma once

#include <cstdint>
#include <vector>

#include "lancer/film/film_state.h"
#include "lancer/film/interval.h"

namespace lancer {

// Samples a pixel grow by levels: level 1 has this many, the others as many times that.
constexpr int samples_of_level = 16;
// Before this level nothing is decided.
constexpr int first_decision = 4;

// What a look at the whole picture, before the start, expects of a goal (render/goal_plan.h). Tiles of 32 x 32 pixels in the order of a film's.
struct GoalPlan {
    double end = 0.0;              // samples that the hardest of the pixels that are to be known will take; 0: nobody has looked
    std::vector<int> wanted;       // pixels of each tile that are to be known
    std::vector<double> expected;  // samples of each tile, of all its pixels; empty where nobody will ask
};

// Of a picture, the share `confidence` of the pixels is to be known within `error` of its luminance, at that confidence. Dark pixels count as if they
// had luminance `floor`. Without a plan that share is to be known in each tile.
//
// Cells of pixels (film/interval.h) get samples together: large enough that luck averages out, small enough to follow what is hard.
struct ErrorGoal {
    double error = 0.0;  // relative; 0: none
    double confidence = 0.95;
    double floor = 0.0;
    GoalPlan plan;
};

// The cells of a tile that need more samples, row by row; none where its part of the goal is reached. `limit`: samples a pixel that are not exceeded.
std::vector<std::size_t> wanting_cells(const ErrorGoal& goal, const IntervalRule& rule, const FilmState& state, std::size_t tile,
                                       int limit);

// And how many samples the tile will take until its end, as far as can be told; 0 where no cell needs any.
double foresee_samples(const ErrorGoal& goal, const IntervalRule& rule, const FilmState& state, std::size_t tile, int limit);

// The levels are 1, 2, 4, 5, 6, 7, 8, 10, 12, 14, 16, 20, ...
int next_level(int level);

// What can be said of a whole film.
struct ErrorReport {
    std::uint64_t pixels = 0;  // that have samples
    double samples = 0.0;      // of all of them
    double share = 0.0;        // of them, known within the goal's error
    double heavy = 0.0;        // share of them with a heavy tail, which count as not known
    double reached = 0.0;      // the relative half width that the share `confidence` of all stays below
};
ErrorReport report_errors(const ErrorGoal& goal, const FilmState& state);

}  // namespace lancer
