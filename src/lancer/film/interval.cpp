#include "lancer/film/interval.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lancer/image/probability.h"

namespace lancer {

namespace {

constexpr double heavy_share = 0.5;  // of the sum of squares, in one sample

// The t that is exceeded in size with chance 1 - confidence.
double student_quantile(double confidence, double freedom) {
    double low = 0.0, high = 1e6;
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        (student_two_sided(middle, freedom) > 1.0 - confidence ? low : high) = middle;
    }
    return high;
}

}  // namespace

std::size_t cells_across(const Tile& block) { return static_cast<std::size_t>((block.width() + interval_cell - 1) / interval_cell); }

std::size_t cells_in(const Tile& block) {
    return cells_across(block) * static_cast<std::size_t>((block.height() + interval_cell - 1) / interval_cell);
}

Tile cell_of(const Tile& block, std::size_t cell) {
    const int x = block.x0 + static_cast<int>(cell % cells_across(block)) * interval_cell;
    const int y = block.y0 + static_cast<int>(cell / cells_across(block)) * interval_cell;
    return {x, y, std::min(x + interval_cell, block.x1), std::min(y + interval_cell, block.y1)};
}

std::vector<double> squares_around(const std::vector<double>& of_cells, std::size_t across) {
    const std::size_t down = of_cells.size() / across;
    std::vector<double> means;
    means.reserve(of_cells.size());
    for (std::size_t row = 0; row < down; ++row) {
        for (std::size_t column = 0; column < across; ++column) {
            double sum = 0.0;
            int count = 0;
            for (std::size_t y = row - std::min<std::size_t>(row, 1); y <= std::min(row + 1, down - 1); ++y) {
                for (std::size_t x = column - std::min<std::size_t>(column, 1); x <= std::min(column + 1, across - 1); ++x, ++count) {
                    sum += std::sqrt(of_cells[y * across + x]);
                }
            }
            means.push_back(sum / count * (sum / count));
        }
    }
    return means;
}

IntervalRule::IntervalRule(double confidence, double floor) : floor_(floor) {
    for (int runs = least_runs; runs <= most_runs; ++runs) {
        quantiles_[static_cast<std::size_t>(runs - least_runs)] = student_quantile(confidence, runs - 1);
    }
}

double IntervalRule::relative(const Interval& interval) const { return interval.half_width / std::max(interval.middle, floor_); }

std::vector<Interval> IntervalRule::of(const FilmSums& sums, const Tile& block) const {
    const std::size_t width = static_cast<std::size_t>(block.width());
    std::vector<Interval> intervals(width * static_cast<std::size_t>(block.height()));
    std::vector<double> squares(cells_in(block), 0.0);  // of relative errors
    const auto each = [&](std::size_t cell, const auto& visit) {
        const Tile part = cell_of(block, cell);
        for (int y = part.y0; y < part.y1; ++y) {
            for (int x = part.x0; x < part.x1; ++x) {
                visit(static_cast<std::size_t>(y - block.y0) * width + static_cast<std::size_t>(x - block.x0),
                      static_cast<std::size_t>(y) * static_cast<std::size_t>(sums.width()) + static_cast<std::size_t>(x));
            }
        }
    };
    for (std::size_t cell = 0; cell < squares.size(); ++cell) {
        int count = 0;
        each(cell, [&](std::size_t place, std::size_t pixel) {
            intervals[place] = alone(sums, pixel);
            const double error = relative(intervals[place]);
            squares[cell] += error * error;
            ++count;
        });
        squares[cell] /= count;
    }
    const std::vector<double> around = squares_around(squares, cells_across(block));
    for (std::size_t cell = 0; cell < squares.size(); ++cell) {
        each(cell, [&](std::size_t place, std::size_t) {
            Interval& interval = intervals[place];
            interval.half_width = std::max(interval.half_width, std::sqrt(around[cell]) * std::max(interval.middle, floor_));
        });
    }
    return intervals;
}

Interval IntervalRule::alone(const FilmSums& sums, std::size_t pixel) const {
    const RunSums runs = sums.runs(pixel);
    Interval interval;
    interval.middle = runs.mean();
    if (runs.complete < least_runs) {
        interval.half_width = std::numeric_limits<double>::infinity();
        return interval;
    }
    const double count = runs.complete;
    double middle = 0.0;
    for (int i = 0; i < runs.complete; ++i) {
        middle += static_cast<double>(runs.sums[static_cast<std::size_t>(i)]);
    }
    middle /= count;
    double spread = 0.0;
    for (int i = 0; i < runs.complete; ++i) {
        const double off = static_cast<double>(runs.sums[static_cast<std::size_t>(i)]) - middle;
        spread += off * off;
    }
    spread /= count - 1.0;
    interval.half_width = quantiles_[static_cast<std::size_t>(runs.complete - least_runs)] * std::sqrt(spread / count) / runs.length;
    const double largest = static_cast<double>(runs.largest);
    interval.tail = runs.squares > 0.0 ? largest * largest / (heavy_share * runs.squares) : 0.0;
    return interval;
}

}  // namespace lancer
