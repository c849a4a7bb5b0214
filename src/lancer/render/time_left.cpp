#include "lancer/render/time_left.h"

#include <algorithm>
#include <cmath>

namespace lancer {

TimeLeft::TimeLeft(const std::vector<double>& sizes) : tiles_(sizes.size()) {
    for (std::size_t tile = 0; tile < sizes.size(); ++tile) {
        tiles_[tile].size = sizes[tile];
        unknown_ += sizes[tile];
    }
}

void TimeLeft::expect(std::size_t tile, double samples) {
    unknown_ -= tiles_[tile].size;
    tiles_[tile].expected = samples;
    expected_ += samples;
}

void TimeLeft::add(std::size_t tile, double work, double samples, double samples_left) {
    Progress& progress = tiles_[tile];
    if (progress.samples == 0.0) {
        size_ += progress.size;
        skip(tile);
    }
    if (progress.samples > 0.0) {
        growth_ += work * std::log((progress.samples + samples + samples_left) / (progress.samples + progress.samples_left));
        samples_growth_ += work * std::log((progress.samples + samples) / progress.samples);
    }
    progress.work += work;
    progress.samples += samples;
    progress.samples_left = samples_left;
    const double left = progress.samples > 0.0 ? samples_left * progress.work / progress.samples : 0.0;
    work_ += work;
    samples_ += samples;
    left_ += left - progress.left;
    progress.left = left;
}

void TimeLeft::skip(std::size_t tile) {
    (tiles_[tile].expected < 0.0 ? unknown_ : expected_) -= tiles_[tile].expected < 0.0 ? tiles_[tile].size : tiles_[tile].expected;
}

double TimeLeft::work_left() const {
    // Tiles that nobody has worked on are as the others are on average.
    const double left = std::max(left_ + expected_ * work_ / samples_ + unknown_ * (work_ + left_) / size_, 0.0);
    // What is expected in all grows with a power of the work that is done, up to the end, where both are the same.
    constexpr double most = 0.5;
    const double power = samples_growth_ > 0.0 ? std::clamp(growth_ / samples_growth_, 0.0, most) : 0.0;
    return work_ * (std::pow(1.0 + left / work_, 1.0 / (1.0 - power)) - 1.0);
}

double TimeLeft::share_done() const { return work_ > 0.0 ? work_ / (work_ + work_left()) : 0.0; }

double TimeLeft::seconds(double since_start) const { return work_ > 0.0 ? work_left() * since_start / work_ : 0.0; }

}  // namespace lancer
