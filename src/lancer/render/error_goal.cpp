#include "lancer/render/error_goal.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lancer {

namespace {

// A pixel's half width scatters around what is true of its neighbourhood, as the root of chi-squared over its freedom does: 95 % stay below 1.29 times it.
constexpr double scatter = 25.0 / 15.0;  // squared

}  // namespace

int next_level(int level) {
    if (level < 2) {
        return level + 1;
    }
    int power = 2;
    while (2 * power <= level) {
        power *= 2;
    }
    // 2, 4, 6, 8, 12, 16: powers of two, and from 4 on what lies half way.
    return power == 2 ? 4 : level < power + power / 2 ? power + power / 2 : 2 * power;
}

namespace {

// How well the pixels of a tile are known, cell by cell, and what follows from that.
class TileErrors {
public:
    TileErrors(const ErrorGoal& goal, const IntervalRule& rule, const FilmState& state, std::size_t tile, int limit);

    bool reached() const { return static_cast<double>(known_) >= confidence_ * static_cast<double>(pixels_); }
    std::vector<std::size_t> wanting() const;

    // As it will be, as far as can be told, when these cells have their next level: errors fall with the root of the number of samples; the share of one
    // outstanding sample falls slowly (its fourth root, measured on the gallery), as others come. Returns how many samples that takes.
    double foresee(const std::vector<std::size_t>& cells);

private:
    struct Cell {
        std::vector<double> squares;  // of each pixel's error over the goal's
        std::vector<double> tails;    // of each pixel; 1 and less is trusted
        int level = 0;                // of samples
        double need = 0.0;            // mean of the squares, or what it is around, whichever is more
        bool failing = false;
    };
    void judge();

    double confidence_;
    int last_level_;
    std::size_t across_ = 0;
    std::vector<Cell> cells_;
    std::size_t known_ = 0;
    std::size_t pixels_ = 0;
};

TileErrors::TileErrors(const ErrorGoal& goal, const IntervalRule& rule, const FilmState& state, std::size_t tile, int limit)
    : confidence_(goal.confidence), last_level_(limit / samples_of_level) {
    const Tile& place = state.tiles()[tile];
    const Film& film = state.film();
    across_ = cells_across(place);
    cells_.resize(cells_in(place));
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        const Tile part = cell_of(place, i);
        cells_[i].level = static_cast<int>(film.samples[film.index(part.x0, part.y0)]) / samples_of_level;
        for (int y = part.y0; y < part.y1; ++y) {
            for (int x = part.x0; x < part.x1; ++x) {
                const Interval interval = rule.alone(*state.sums(), film.index(x, y));
                const double ratio = rule.relative(interval) / goal.error;
                cells_[i].squares.push_back(ratio * ratio);
                cells_[i].tails.push_back(interval.tail);
            }
        }
        pixels_ += cells_[i].squares.size();
    }
    judge();
}

void TileErrors::judge() {
    std::vector<double> means;
    for (const Cell& cell : cells_) {
        means.push_back(std::accumulate(cell.squares.begin(), cell.squares.end(), 0.0) / static_cast<double>(cell.squares.size()));
    }
    const std::vector<double> around = squares_around(means, across_);
    known_ = 0;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        Cell& cell = cells_[i];
        std::size_t known = 0;
        for (std::size_t k = 0; k < cell.squares.size(); ++k) {
            const bool good = cell.level >= first_decision && std::max(cell.squares[k], around[i]) <= 1.0 && cell.tails[k] <= 1.0;
            known += good ? 1u : 0u;
        }
        known_ += known;
        cell.failing = known < cell.squares.size();
        cell.need = std::max(means[i], around[i]);
    }
}

std::vector<std::size_t> TileErrors::wanting() const {
    std::vector<std::size_t> cells;
    if (reached()) {
        return cells;
    }
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        if ((cells_[i].need * scatter > 1.0 || cells_[i].level < first_decision) && cells_[i].level < last_level_) {
            cells.push_back(i);
        }
    }
    for (std::size_t i = 0, all = cells.empty() ? cells_.size() : 0; i < all; ++i) {  // all is well on average, but not well enough
        if (cells_[i].failing && cells_[i].level < last_level_) {
            cells.push_back(i);
        }
    }
    return cells;
}

double TileErrors::foresee(const std::vector<std::size_t>& cells) {
    double samples = 0.0;
    for (const std::size_t i : cells) {
        Cell& cell = cells_[i];
        const int level = std::min(next_level(cell.level), last_level_);
        const double less = static_cast<double>(cell.level) / level;
        for (double& square : cell.squares) {
            square *= less;
        }
        for (double& tail : cell.tails) {
            tail *= std::pow(less, 0.25);
        }
        samples += static_cast<double>(level - cell.level) * samples_of_level * static_cast<double>(cell.squares.size());
        cell.level = level;
    }
    judge();
    return samples;
}

}  // namespace

std::vector<std::size_t> wanting_cells(const ErrorGoal& goal, const IntervalRule& rule, const FilmState& state, std::size_t tile,
                                       int limit) {
    return TileErrors(goal, rule, state, tile, limit).wanting();
}

double foresee_samples(const ErrorGoal& goal, const IntervalRule& rule, const FilmState& state, std::size_t tile, int limit) {
    TileErrors errors(goal, rule, state, tile, limit);
    double samples = 0.0;
    for (std::vector<std::size_t> cells = errors.wanting(); !cells.empty(); cells = errors.wanting()) {
        samples += errors.foresee(cells);
    }
    return samples;
}

ErrorReport report_errors(const ErrorGoal& goal, const FilmState& state) {
    ErrorReport report;
    if (state.sums() == nullptr || !state.sums()->layers().runs) {
        return report;
    }
    const IntervalRule rule(goal.confidence, goal.floor);
    std::vector<double> errors;
    std::uint64_t known = 0, heavy = 0;
    for (const Tile& tile : state.tiles()) {
        if (state.film().samples[state.film().index(tile.x0, tile.y0)] == 0) {
            continue;
        }
        for (const Interval& interval : rule.of(*state.sums(), tile)) {
            const double error = rule.relative(interval);
            heavy += interval.heavy() ? 1u : 0u;
            known += error <= goal.error && !interval.heavy() ? 1u : 0u;
            errors.push_back(std::isnan(error) ? 0.0 : error);
        }
    }
    report.pixels = errors.size();
    for (const std::uint32_t samples : state.film().samples) {
        report.samples += static_cast<double>(samples);
    }
    if (errors.empty()) {
        return report;
    }
    const double pixels = static_cast<double>(errors.size());
    report.share = static_cast<double>(known) / pixels;
    report.heavy = static_cast<double>(heavy) / pixels;
    const auto place = errors.begin() + static_cast<std::ptrdiff_t>(std::min(std::ceil(goal.confidence * pixels), pixels) - 1.0);
    std::nth_element(errors.begin(), place, errors.end());
    report.reached = *place;
    return report;
}

}  // namespace lancer
