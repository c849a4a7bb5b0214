// How much of a render's work is done, and how long the rest will take.
//
// Work is what threads spend: tiles cost as much a sample as they did so far, and more where more samples are expected. How fast work goes by the
// clock, with all threads and whatever else the machine does, is what it was so far. Where a goal is to be reached, what is expected grows as more
// samples find what is rare; how much it has grown for the samples so far says how much it will.
#pragma once

#include <cstddef>
#include <vector>

namespace lancer {

class TimeLeft {
public:
    // Nothing is known of any tile. `sizes`: in pixels; 0 where a tile is not to be rendered.
    explicit TimeLeft(const std::vector<double>& sizes);

    // Before the start, where it is known: how many samples a tile is to get.
    void expect(std::size_t tile, double samples);

    // A round of work on a tile is done: it took `work` (seconds of a thread) for so many samples, and so many are expected to follow.
    void add(std::size_t tile, double work, double samples, double samples_left);

    // There is nothing to do for a tile that was not worked on.
    void skip(std::size_t tile);

    // Of the work; 0 as long as nothing is known.
    double share_done() const;

    // After so many seconds. 0 as long as nothing is known.
    double seconds(double since_start) const;

private:
    struct Progress {
        double size = 0.0;
        double work = 0.0;
        double samples = 0.0;
        double samples_left = 0.0;
        double left = 0.0;       // work
        double expected = -1.0;  // samples of a tile that has none; below 0: not known
    };
    double work_left() const;

    std::vector<Progress> tiles_;
    // Sums over the tiles that were worked on.
    double work_ = 0.0;
    double samples_ = 0.0;
    double left_ = 0.0;
    double size_ = 0.0;
    // Logarithms of the growth of what was expected of a tile, and of its samples meanwhile, weighted by work.
    double growth_ = 0.0;
    double samples_growth_ = 0.0;
    // And over those that were not: samples where these are known, size where they are not.
    double expected_ = 0.0;
    double unknown_ = 0.0;
};

}  // namespace lancer
