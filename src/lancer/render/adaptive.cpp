#include "lancer/render/adaptive.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <glm/common.hpp>

#include "lancer/render/blocks.h"

namespace lancer {

namespace {

float largest_difference(const glm::vec3& a, const glm::vec3& b) {
    const glm::vec3 d = glm::abs(a - b);
    return std::max({d.x, d.y, d.z});
}

}  // namespace

int AdaptiveSampler::tile_size(int depth) {
    // A lattice of 513 x 513 points takes 1 MiB a thread.
    constexpr int largest_tile = 32;
    constexpr int largest_lattice = 512;
    return std::clamp(largest_lattice >> depth, 1, largest_tile);
}

AdaptiveSampler::AdaptiveSampler(const Device& device, const AdaptiveOptions& options, const DisplayCurve& curve)
    : device_(device), curve_(curve), threshold_(static_cast<float>(options.threshold)), depth_(options.depth),
      stride_((tile_size(options.depth) << options.depth) + 1),
      index_at_(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(stride_), 0) {}

void AdaptiveSampler::begin_tile(const Tile& tile) {
    tile_ = tile;
    for (const Corner& corner : corners_) {
        index_at_[node(corner.place.x, corner.place.y)] = 0;
    }
    corners_.clear();
    points_.clear();
    followed_ = 0;
    cells_.clear();
    samples_.assign(static_cast<std::size_t>(tile.width()) * static_cast<std::size_t>(tile.height()), 0);
}

bool AdaptiveSampler::want(int x, int y) {
    std::uint32_t& index = index_at_[node(x, y)];
    if (index != 0) {
        return false;
    }
    const float unit = 1.0f / static_cast<float>(1 << depth_);
    points_.emplace_back(static_cast<float>(tile_.x0) + static_cast<float>(x) * unit,
                         static_cast<float>(tile_.y0) + static_cast<float>(y) * unit);
    corners_.push_back({{x, y}, glm::vec3(0.0f)});
    index = static_cast<std::uint32_t>(corners_.size());

    // A sample counts for the pixel it lies in; on the far borders of the tile for the last one.
    const int pixel_x = std::min(x >> depth_, tile_.width() - 1);
    const int pixel_y = std::min(y >> depth_, tile_.height() - 1);
    ++samples_[static_cast<std::size_t>(pixel_y) * static_cast<std::size_t>(tile_.width()) + static_cast<std::size_t>(pixel_x)];
    return true;
}

void AdaptiveSampler::want_on_edge(int x, int y, int beyond_x, int beyond_y) {
    const bool inside = beyond_x >= 0 && beyond_y >= 0 && beyond_x < tile_.width() << depth_ && beyond_y < tile_.height() << depth_;
    if (want(x, y) && inside) {
        witnesses_.push_back({{x, y}, {beyond_x, beyond_y}});
    }
}

void AdaptiveSampler::follow_wanted(RayCounts& counts) {
    radiance_.resize(std::max(radiance_.size(), points_.size()));
    const std::size_t count = points_.size() - followed_;
    device_.follow(std::span(points_).subspan(followed_, count), std::span(radiance_).subspan(followed_, count), counts);
    for (; followed_ < points_.size(); ++followed_) {
        corners_[followed_].display = curve_.encode(radiance_[followed_]);
    }
}

bool AdaptiveSampler::corners_differ(const Cell& cell) const {
    const auto& [x, y] = cell.corner;
    const glm::vec3& a = display(x, y);
    const glm::vec3& b = display(x + cell.size, y);
    const glm::vec3& c = display(x, y + cell.size);
    const glm::vec3& d = display(x + cell.size, y + cell.size);
    return largest_difference(glm::max(glm::max(a, b), glm::max(c, d)), glm::min(glm::min(a, b), glm::min(c, d))) > threshold_;
}

bool AdaptiveSampler::differs_from_ends(const Place& middle, const Place& a, const Place& b) const {
    const glm::vec3& m = display(middle.x, middle.y);
    return largest_difference(m, display(a.x, a.y)) > threshold_ || largest_difference(m, display(b.x, b.y)) > threshold_;
}

// A neighbour that was cut before has shown what lies in the middle of the edge between.
bool AdaptiveSampler::edges_differ(const Cell& cell) const {
    const auto& [x, y] = cell.corner;
    const int size = cell.size;
    const Place corner[4] = {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
    for (int i = 0; i < 4; ++i) {
        const Place& a = corner[i];
        const Place& b = corner[(i + 1) % 4];
        const Place middle = {(a.x + b.x) / 2, (a.y + b.y) / 2};
        if (is_followed(middle.x, middle.y) && differs_from_ends(middle, a, b)) {
            return true;
        }
    }
    return false;
}

void AdaptiveSampler::cut(const Cell& cell) {
    const auto& [x, y] = cell.corner;
    const int size = cell.size;
    const int half = size / 2;
    want_on_edge(x + half, y, x + half, y - 1);
    want_on_edge(x, y + half, x - 1, y + half);
    want(x + half, y + half);
    want_on_edge(x + size, y + half, x + size, y + half);
    want_on_edge(x + half, y + size, x + half, y + size);
    if (half > 1) {  // the smallest cells need not be looked at
        next_.push_back({{x, y}, half});
        next_.push_back({{x + half, y}, half});
        next_.push_back({{x, y + half}, half});
        next_.push_back({{x + half, y + half}, half});
    }
}

// The uncut cell that covers a unit square.
AdaptiveSampler::Cell AdaptiveSampler::leaf_at(const Place& unit) const {
    Cell cell;
    cell.size = 1 << depth_;
    for (;;) {
        cell.corner = {unit.x & -cell.size, unit.y & -cell.size};
        if (cell.size == 1 || !is_cut(cell)) {
            return cell;
        }
        cell.size /= 2;
    }
}

// A point in the middle of an edge that differs from the edge's ends shows that the cell beyond, though its corners agree, must be cut too.
void AdaptiveSampler::hear_witnesses() {
    revealed_.clear();
    std::erase_if(witnesses_, [&](const Witness& witness) {
        const Cell leaf = leaf_at(witness.beyond);
        const auto& [x, y] = witness.place;
        const auto& [left, top] = leaf.corner;
        const bool on_level_edge = y == top || y == top + leaf.size;
        const bool inside_edge = on_level_edge ? (x > left && x < left + leaf.size) : (y > top && y < top + leaf.size);
        if (!inside_edge) {
            return true;
        }
        const bool differs = on_level_edge ? differs_from_ends(witness.place, {left, y}, {left + leaf.size, y})
                                           : differs_from_ends(witness.place, {x, top}, {x, top + leaf.size});
        if (differs) {
            revealed_.push_back(leaf);
        }
        return !differs;
    });
    for (const Cell& cell : revealed_) {
        if (!is_cut(cell)) {
            cut(cell);
        }
    }
}

bool AdaptiveSampler::render_tile(const Tile& tile, Film& film, RayCounts& counts, const std::atomic<bool>* cancel) {
    begin_tile(tile);
    const int pixel = 1 << depth_;
    for_each_in_blocks(tile.width() + 1, tile.height() + 1, device_.lanes(), [&](int x, int y) { want(x * pixel, y * pixel); });
    follow_wanted(counts);
    if (depth_ > 0) {
        for_each_in_blocks(tile.width(), tile.height(), device_.lanes(), [&](int x, int y) {
            cells_.push_back({{x * pixel, y * pixel}, pixel});
        });
    }
    while (!cells_.empty()) {
        next_.clear();
        witnesses_.clear();
        for (const Cell& cell : cells_) {
            if (!is_cut(cell) && (corners_differ(cell) || edges_differ(cell))) {
                cut(cell);
            }
        }
        while (followed_ < points_.size()) {
            if (is_cancelled(cancel)) {
                return false;
            }
            follow_wanted(counts);
            hear_witnesses();
        }
        cells_.swap(next_);
    }
    put_pixels(film);
    return true;
}

glm::vec3 AdaptiveSampler::mean(const Cell& cell) const {
    const auto& [x, y] = cell.corner;
    const int size = cell.size;
    if (size == 1 || !is_cut(cell)) {
        const auto light = [&](int corner_x, int corner_y) -> const glm::vec3& { return radiance_[index(corner_x, corner_y)]; };
        return ((light(x, y) + light(x + size, y)) + (light(x, y + size) + light(x + size, y + size))) * 0.25f;
    }
    const int half = size / 2;
    return ((mean({{x, y}, half}) + mean({{x + half, y}, half})) + (mean({{x, y + half}, half}) + mean({{x + half, y + half}, half}))) *
           0.25f;
}

void AdaptiveSampler::put_pixels(Film& film) const {
    const int size = 1 << depth_;
    const std::uint32_t* samples = samples_.data();
    for (int y = 0; y < tile_.height(); ++y) {
        for (int x = 0; x < tile_.width(); ++x) {
            const std::size_t pixel = film.index(tile_.x0 + x, tile_.y0 + y);
            film.radiance[pixel] = mean({{x * size, y * size}, size});
            film.samples[pixel] = *samples++;
        }
    }
}

}  // namespace lancer
