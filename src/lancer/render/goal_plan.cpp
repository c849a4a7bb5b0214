#include "lancer/render/goal_plan.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "lancer/film/film_sums.h"
#include "lancer/film/interval.h"
#include "lancer/film/tiles.h"
#include "lancer/render/paths.h"
#include "lancer/render/threads.h"

namespace lancer {

namespace {

constexpr int samples_to_plan = first_decision * samples_of_level;
constexpr int samples_of_floor = 4;

// A pixel that is looked at.
struct Look {
    std::size_t tile = 0;
    double luminance = 0.0;
    double half_width = 0.0;
    double tail = 0.0;
    double need = 0.0;  // samples
};

double area(const Tile& tile) { return static_cast<double>(tile.width()) * tile.height(); }

// So many in each direction of a tile.
int looks_across(std::size_t tiles) {
    constexpr double wanted = 16384.0;  // of the picture
    return std::clamp(static_cast<int>(std::sqrt(wanted / static_cast<double>(tiles))), 2, 4);
}

// The pixels of a tile that are looked at: one in each part of it, at another place in each [Roberts 2018].
void look_at(const Device& device, const Tile& tile, int across, int samples, const IntervalRule& rule, std::span<Look> looks) {
    FilmLayers layers;
    layers.runs = true;
    Film film(across, across);
    FilmSums sums(across, across, layers);
    FilmState state(film, &sums, PathSampler::tile_size);
    PathTracer tracer(device, layers);
    RayCounts ignored;
    for (int i = 0; i < across * across; ++i) {
        const double number = static_cast<double>(looks[0].tile) * across * across + i;
        const auto place = [&](int part, int size, double step) {
            const double offset = number * step - std::floor(number * step);
            return std::min(static_cast<int>((part + offset) / across * size), size - 1);
        };
        const int column = i % across, row = i / across;
        const int x = tile.x0 + place(column, tile.width(), 0.7548776662466927);
        const int y = tile.y0 + place(row, tile.height(), 0.5698402909980532);
        tracer.trace({x, y, x + 1, y + 1, 0, samples}, ignored);
        tracer.put(state, x - column, y - row);
        const std::size_t pixel = film.index(column, row);
        const Interval interval = rule.alone(sums, pixel);
        Look& found = looks[static_cast<std::size_t>(i)];
        found.luminance = std::isfinite(interval.middle) ? std::max(interval.middle, 0.0) : 0.0;
        found.half_width = std::isfinite(interval.half_width) ? interval.half_width : 0.0;
        found.tail = interval.tail;
    }
}

double floor_of(const std::vector<Look>& looks) {
    double roots = 0.0;
    for (const Look& look : looks) {
        roots += std::sqrt(look.luminance);
    }
    const double root = roots / static_cast<double>(looks.size());
    return std::max(0.1 * root * root, 1e-30);
}

// The level at or above so many samples, in samples; four levels for each doubling.
double rounded_up(double samples) {
    const double level = std::max(samples, 1.0 * samples_to_plan) / samples_of_level;
    const double step = std::exp2(std::floor(std::log2(level)) - 2.0);
    return std::ceil(level / step) * step * samples_of_level;
}

// Errors fall with the root of the number of samples, one sample's part in them with the fourth root (error_goal.cpp). As in the picture, nobody is surer than
// those around: a pixel that no rare light has met yet looks easy.
void find_needs(const ErrorGoal& goal, std::span<Look> of_tile, int across) {
    std::vector<double> needs;
    for (const Look& look : of_tile) {
        const double error = look.half_width / (std::max(look.luminance, goal.floor) * goal.error);
        needs.push_back(samples_to_plan * std::max(error * error, look.tail > 1.0 ? std::pow(look.tail, 4.0) : 0.0));
    }
    const std::vector<double> around = squares_around(needs, static_cast<std::size_t>(across));
    for (std::size_t i = 0; i < needs.size(); ++i) {
        of_tile[i].need = std::max(needs[i], around[i]);
    }
}

// The easiest pixels that make up the share are those that are wanted. No tile has to have all of its pixels known: a few odd ones are not worth it.
GoalPlan plan_for(const ErrorGoal& goal, const std::vector<Look>& looks, const std::vector<Tile>& tiles, double limit) {
    const double of_each = static_cast<double>(looks.size() / tiles.size());
    const double most = std::max(0.5 * (1.0 + goal.confidence), 0.975) * of_each;
    double missing = 0.0;
    for (const Tile& tile : tiles) {
        missing += goal.confidence * area(tile);
    }
    std::vector<const Look*> easiest_first;
    for (const Look& look : looks) {
        easiest_first.push_back(&look);
    }
    std::stable_sort(easiest_first.begin(), easiest_first.end(), [](const Look* a, const Look* b) { return a->need < b->need; });
    GoalPlan plan;
    std::vector<double> shares(tiles.size(), 0.0);
    for (const Look* look : easiest_first) {
        if (missing <= 0.0) {
            break;
        }
        double& share = shares[look->tile];
        const double more = std::min(1.0, most - share);
        share += more;
        missing -= more / of_each * area(tiles[look->tile]);
        plan.end = look->need;
    }
    plan.end = std::min(rounded_up(std::min(plan.end, limit)), limit);
    plan.expected.assign(tiles.size(), 0.0);
    for (const Look& look : looks) {
        const double samples = std::pow(look.need, 0.75) * std::pow(plan.end, 0.25);
        plan.expected[look.tile] +=
            std::clamp(samples, std::min(1.0 * samples_to_plan, plan.end), plan.end) / of_each * area(tiles[look.tile]);
    }
    for (std::size_t tile = 0; tile < tiles.size(); ++tile) {
        plan.wanted.push_back(static_cast<int>(std::min(std::ceil(shares[tile] / of_each * area(tiles[tile])), area(tiles[tile]))));
    }
    return plan;
}

}  // namespace

ErrorGoal plan_goal(const Device& device, const RenderOptions& options) {
    ErrorGoal goal = options.goal;
    const std::vector<Tile> tiles = cut_tiles(options.width, options.height, PathSampler::tile_size);
    const int across = looks_across(tiles.size());
    const int samples = goal.error > 0.0 ? samples_to_plan : samples_of_floor;
    const std::size_t of_each = static_cast<std::size_t>(across) * static_cast<std::size_t>(across);
    std::vector<Look> looks(tiles.size() * of_each);
    const IntervalRule rule(goal.confidence, std::numeric_limits<double>::min());
    std::atomic<std::size_t> next = 0;
    run_on_threads(options.threads > 0 ? options.threads : hardware_threads(), [&] {
        for (std::size_t tile = next++; tile < tiles.size(); tile = next++) {
            const std::span<Look> of_tile = std::span(looks).subspan(tile * of_each, of_each);
            for (Look& one : of_tile) {
                one.tile = tile;
            }
            look_at(device, tiles[tile], across, samples, rule, of_tile);
        }
    });
    goal.floor = floor_of(looks);
    goal.plan = {};
    if (goal.error > 0.0) {
        for (std::size_t tile = 0; tile < tiles.size(); ++tile) {
            find_needs(goal, std::span(looks).subspan(tile * of_each, of_each), across);
        }
        goal.plan = plan_for(goal, looks, tiles, options.spp);
    }
    return goal;
}

}  // namespace lancer
