#include "lancer/render/error_goal.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lancer {

int next_level(int level) {
    if (level < first_decision) {
        return level == 0 ? 1 : 2 * level;
    }
    int step = 1;  // a quarter of the power of two below
    while (8 * step <= level) {
        step *= 2;
    }
    return (level / step + 1) * step;
}

namespace {

// How well the pixels of a tile are known, cell by cell, and what follows from that.
class TileErrors {
public:
    TileErrors(const ErrorGoal& goal, const IntervalRule& rule, const FilmState& state, std::size_t tile, int limit);

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
        double around = 0.0;          // the square of the errors around it
    };
    // How many times the samples that it has a pixel needs to be known, as far as can be told; 1 or less where it is known.
    static double missing(const Cell& cell, std::size_t pixel) {
        const double tail = cell.tails[pixel];
        return std::max({cell.squares[pixel], cell.around, tail * tail * tail * tail});
    }
    void judge();
    // How much error a cell may have at a level, as a square: that of the goal at the end that is foreseen, and less before, so that what is easy ends
    // better than it must. That costs little and does more for the picture than the last samples of what is hard.
    // A cell may have been lucky. At first it has to be better by what the squared error of one pixel scatters, 25/15 (95 % of chi-squared with 15
    // degrees of freedom), and by less with more samples.
    double allowed(int level) const {
        const double luck = 1.0 + 2.0 / 3.0 * std::sqrt(static_cast<double>(first_decision) / level);
        return (end_ > 0.0 ? std::min(1.0, std::cbrt(level * samples_of_level / end_)) : 1.0) / luck;
    }

    double end_;
    int last_level_;
    std::size_t across_ = 0;
    std::vector<Cell> cells_;
    std::size_t wanted_ = 0;  // pixels
    std::size_t known_ = 0;
};

TileErrors::TileErrors(const ErrorGoal& goal, const IntervalRule& rule, const FilmState& state, std::size_t tile, int limit)
    : end_(goal.plan.end), last_level_(limit / samples_of_level) {
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
    }
    wanted_ = goal.plan.wanted.empty() ? static_cast<std::size_t>(std::ceil(goal.confidence * place.width() * place.height()))
                                       : static_cast<std::size_t>(goal.plan.wanted[tile]);
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
        cell.around = around[i];
        cell.need = std::max(means[i], around[i]);
        for (std::size_t k = 0; k < cell.squares.size(); ++k) {
            known_ += cell.level >= first_decision && missing(cell, k) <= 1.0 ? 1u : 0u;
        }
    }
}

std::vector<std::size_t> TileErrors::wanting() const {
    std::vector<std::size_t> cells;
    const bool reached = known_ >= wanted_;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        const Cell& cell = cells_[i];
        // Where the tile's part is reached, what is hard goes on to half of what is foreseen: it would stand out from its neighbours else.
        const bool goes_on = end_ > 0.0 ? cell.level * samples_of_level < (reached ? 0.5 : 1.0) * end_ : !reached;
        if (cell.level < last_level_ && (cell.level < first_decision || (goes_on && cell.need > allowed(cell.level)))) {
            cells.push_back(i);
        }
    }
    if (!cells.empty() || reached) {
        return cells;
    }
    // All is as it was foreseen on average, but not well enough: those go on that are nearest to it, as far as can be told.
    std::vector<std::pair<double, std::size_t>> nearest;  // of pixels that are not known: samples, cell
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        for (std::size_t k = 0; k < cells_[i].squares.size(); ++k) {
            if (const double more = missing(cells_[i], k); more > 1.0 && cells_[i].level < last_level_) {
                nearest.emplace_back(more * cells_[i].level, i);
            }
        }
    }
    std::sort(nearest.begin(), nearest.end());
    nearest.resize(std::min(nearest.size(), wanted_ - known_));
    for (const auto& [samples, cell] : nearest) {
        cells.push_back(cell);
    }
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
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
