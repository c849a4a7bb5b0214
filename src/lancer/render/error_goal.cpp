#include "lancer/render/error_goal.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lancer {

namespace {

// Before each replicate has so many samples nothing is decided.
constexpr int first_decision = 4;
// A pixel's half width scatters around what is true of its neighbourhood, as the root of chi-squared over its freedom does: 95 % stay below 1.29 times it.
constexpr double scatter = 25.0 / 15.0;  // squared

double relative_error(const ErrorGoal& goal, const Interval& interval) {
    return interval.half_width / std::max(interval.middle, goal.floor);
}

int cells_across(const Tile& tile) { return (tile.width() + cell_size - 1) / cell_size; }

}  // namespace

Tile cell_of(const Tile& tile, std::size_t cell) {
    const int across = cells_across(tile);
    const int x = tile.x0 + static_cast<int>(cell) % across * cell_size;
    const int y = tile.y0 + static_cast<int>(cell) / across * cell_size;
    return {x, y, std::min(x + cell_size, tile.x1), std::min(y + cell_size, tile.y1)};
}

std::size_t cells_in(const Tile& tile) {
    return static_cast<std::size_t>(cells_across(tile)) * static_cast<std::size_t>((tile.height() + cell_size - 1) / cell_size);
}

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

TileNeeds needs_of(const ErrorGoal& goal, const IntervalRule& rule, const FilmState& state, std::size_t tile, int limit) {
    const Tile& place = state.tiles()[tile];
    const Film& film = state.film();
    const std::size_t cells = cells_in(place);
    const int across = cells_across(place);
    const int down = static_cast<int>(cells) / across;
    std::vector<double> squares(cells, 0.0);  // mean square of the errors over the goal's
    std::vector<char> failing(cells, 0);
    std::vector<double> samples(cells, 0.0);  // of all the cell's pixels
    std::vector<char> full(cells, 0);
    std::size_t known = 0, pixels = 0;
    for (std::size_t cell = 0; cell < cells; ++cell) {
        const Tile part = cell_of(place, cell);
        for (int y = part.y0; y < part.y1; ++y) {
            for (int x = part.x0; x < part.x1; ++x) {
                const std::size_t pixel = film.index(x, y);
                const Interval interval = rule.of(*state.sums(), pixel);
                const double ratio = film.samples[pixel] < std::uint32_t{first_decision * error_replicates}
                                         ? std::numeric_limits<double>::infinity()
                                         : relative_error(goal, interval) / goal.error;
                const bool good = ratio <= 1.0 && !interval.heavy;
                known += good ? 1 : 0;
                ++pixels;
                failing[cell] = static_cast<char>(failing[cell] | (good ? 0 : 1));
                squares[cell] += ratio * ratio;
                samples[cell] += static_cast<double>(film.samples[pixel]);
            }
        }
        const double area = static_cast<double>(part.width()) * part.height();
        squares[cell] /= area;
        full[cell] = film.samples[film.index(part.x0, part.y0)] >= static_cast<std::uint32_t>(limit) ? 1 : 0;
    }
    TileNeeds needs;
    needs.reached = static_cast<double>(known) >= goal.confidence * static_cast<double>(pixels);
    for (std::size_t cell = 0; cell < cells; ++cell) {
        // What the neighbours find hard may be hard here, too, only not found yet.
        const int column = static_cast<int>(cell) % across, row = static_cast<int>(cell) / across;
        double around = 0.0;
        int count = 0;
        for (int y = std::max(row - 1, 0); y <= std::min(row + 1, down - 1); ++y) {
            for (int x = std::max(column - 1, 0); x <= std::min(column + 1, across - 1); ++x, ++count) {
                around += squares[static_cast<std::size_t>(y) * static_cast<std::size_t>(across) + static_cast<std::size_t>(x)];
            }
        }
        const double need = std::max(squares[cell], around / count) * scatter;
        const Tile part = cell_of(place, cell);
        const double most = static_cast<double>(limit) * part.width() * part.height();
        const bool wants = !needs.reached && need > 1.0;
        needs.expected += wants && std::isfinite(need) ? std::min(samples[cell] * need, std::max(most, samples[cell])) : samples[cell];
        if (wants && full[cell] == 0) {
            needs.cells.push_back(cell);
        }
    }
    if (!needs.reached && needs.cells.empty()) {  // all is well on average, but not well enough
        for (std::size_t cell = 0; cell < cells; ++cell) {
            if (failing[cell] != 0 && full[cell] == 0) {
                needs.cells.push_back(cell);
            }
        }
    }
    return needs;
}

ErrorReport report_errors(const ErrorGoal& goal, const FilmState& state) {
    ErrorReport report;
    if (state.sums() == nullptr || state.sums()->layers().replicates == 0) {
        return report;
    }
    const IntervalRule rule(goal.confidence);
    std::vector<double> errors;
    std::uint64_t known = 0, heavy = 0;
    for (std::size_t pixel = 0; pixel < state.film().samples.size(); ++pixel) {
        if (state.film().samples[pixel] == 0) {
            continue;
        }
        const Interval interval = rule.of(*state.sums(), pixel);
        const double error = relative_error(goal, interval);
        heavy += interval.heavy ? 1 : 0;
        known += error <= goal.error && !interval.heavy ? 1 : 0;
        errors.push_back(std::isnan(error) ? 0.0 : error);
    }
    report.pixels = errors.size();
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
