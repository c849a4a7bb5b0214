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
    const std::size_t pixels = static_cast<std::size_t>(tile.width()) * static_cast<std::size_t>(tile.height());
    samples_.assign(pixels, 0);
    pixel_cut_.assign(pixels, 0);
    contrast_.assign(pixels, 0.0f);
}

// The pixel of a lattice point; on the far borders of the tile the last one.
std::size_t AdaptiveSampler::pixel_of(int x, int y) const {
    const int pixel_x = std::min(x >> depth_, tile_.width() - 1);
    const int pixel_y = std::min(y >> depth_, tile_.height() - 1);
    return static_cast<std::size_t>(pixel_y) * static_cast<std::size_t>(tile_.width()) + static_cast<std::size_t>(pixel_x);
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

    // A sample counts for the pixel it lies in: on the far borders of the tile, that is none of ours.
    if (x >> depth_ < tile_.width() && y >> depth_ < tile_.height()) {
        ++samples_[pixel_of(x, y)];
    }
    return true;
}

void AdaptiveSampler::want_on_edge(const Place& middle, const Place& step, const Place& beyond) {
    const bool inside = beyond.x >= 0 && beyond.y >= 0 && beyond.x < tile_.width() << depth_ && beyond.y < tile_.height() << depth_;
    if (want(middle.x, middle.y) && inside) {
        witnesses_.push_back({middle, step, beyond});
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
    pixel_cut_[pixel_of(x, y)] = 1;
    want_on_edge({x + half, y}, {half, 0}, {x + half, y - 1});
    want_on_edge({x, y + half}, {0, half}, {x - 1, y + half});
    want(x + half, y + half);
    want_on_edge({x + size, y + half}, {0, half}, {x + size, y + half});
    want_on_edge({x + half, y + size}, {half, 0}, {x + half, y + size});
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
    if (pixel_cut_[pixel_of(unit.x, unit.y)] == 0) {
        cell.corner = {unit.x & -cell.size, unit.y & -cell.size};
        return cell;
    }
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
        const auto& [x, y] = witness.place;
        const auto& [dx, dy] = witness.step;
        if (!differs_from_ends(witness.place, {x - dx, y - dy}, {x + dx, y + dy})) {
            return true;
        }
        const Cell leaf = leaf_at(witness.beyond);
        const auto& [left, top] = leaf.corner;
        const bool inside_edge = dx != 0 ? (x > left && x < left + leaf.size) : (y > top && y < top + leaf.size);
        if (inside_edge) {
            revealed_.push_back(leaf);
        }
        return !inside_edge;
    });
    for (const Cell& cell : revealed_) {
        if (!is_cut(cell)) {
            cut(cell);
        }
    }
}

void AdaptiveSampler::follow_pixel_corners(RayCounts& counts) {
    const int stride = tile_.width() + 1;
    for_each_in_blocks(stride, tile_.height() + 1, device_.lanes(), [&](int x, int y) { want(x << depth_, y << depth_); });
    follow_wanted(counts);
    for (int c = 0; c < 3; ++c) {
        corner_light_.channel[c].resize(corners_.size());
        corner_display_.channel[c].resize(corners_.size());
        for (std::size_t i = 0; i < corners_.size(); ++i) {
            const Place& place = corners_[i].place;
            const std::size_t at = static_cast<std::size_t>(place.y >> depth_) * static_cast<std::size_t>(stride) +
                                   static_cast<std::size_t>(place.x >> depth_);
            corner_light_.channel[c][at] = radiance_[i][c];
            corner_display_.channel[c][at] = corners_[i].display[c];
        }
    }
}

void AdaptiveSampler::cut_pixels() {
    const std::size_t width = static_cast<std::size_t>(tile_.width());
    for (const std::vector<float>& plane : corner_display_.channel) {
        for (std::size_t y = 0; y < static_cast<std::size_t>(tile_.height()); ++y) {
            const float* const upper = plane.data() + y * (width + 1);
            const float* const lower = upper + (width + 1);
            float* const contrast = contrast_.data() + y * width;
            for (std::size_t x = 0; x < width; ++x) {
                const float highest = std::max(std::max(upper[x], upper[x + 1]), std::max(lower[x], lower[x + 1]));
                const float lowest = std::min(std::min(upper[x], upper[x + 1]), std::min(lower[x], lower[x + 1]));
                contrast[x] = std::max(contrast[x], highest - lowest);
            }
        }
    }
    for_each_in_blocks(tile_.width(), tile_.height(), device_.lanes(), [&](int x, int y) {
        if (contrast_[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)] > threshold_) {
            cut({{x << depth_, y << depth_}, 1 << depth_});
        }
    });
}

bool AdaptiveSampler::render_tile(const Tile& tile, Film& film, RayCounts& counts, const std::atomic<bool>* cancel) {
    begin_tile(tile);
    follow_pixel_corners(counts);
    next_.clear();
    witnesses_.clear();
    if (depth_ > 0) {
        cut_pixels();
    }
    for (;;) {
        while (followed_ < points_.size()) {
            if (is_cancelled(cancel)) {
                return false;
            }
            follow_wanted(counts);
            hear_witnesses();
        }
        if (next_.empty()) {
            break;
        }
        cells_.swap(next_);
        next_.clear();
        witnesses_.clear();
        for (const Cell& cell : cells_) {
            if (!is_cut(cell) && (corners_differ(cell) || edges_differ(cell))) {
                cut(cell);
            }
        }
    }
    put_pixels(film);
    return true;
}

glm::vec3 AdaptiveSampler::mean_of_corners(int pixel_x, int pixel_y) const {
    const std::size_t stride = static_cast<std::size_t>(tile_.width()) + 1;
    const std::size_t upper = static_cast<std::size_t>(pixel_y) * stride + static_cast<std::size_t>(pixel_x);
    const std::size_t lower = upper + stride;
    glm::vec3 result;
    for (int c = 0; c < 3; ++c) {
        const float* const light = corner_light_.channel[c].data();
        result[c] = ((light[upper] + light[upper + 1]) + (light[lower] + light[lower + 1])) * 0.25f;
    }
    return result;
}

glm::vec3 AdaptiveSampler::mean(const Cell& cell) const {
    const auto& [x, y] = cell.corner;
    const int size = cell.size;
    const auto light = [&](int at_x, int at_y) -> const glm::vec3& { return radiance_[index(at_x, at_y)]; };
    if (size == 1 || !is_cut(cell)) {
        return ((light(x, y) + light(x + size, y)) + (light(x, y + size) + light(x + size, y + size))) * 0.25f;
    }
    const int half = size / 2;
    if (half == 1) {  // four of the smallest cells, in one go
        const glm::vec3 corners = (light(x, y) + light(x + 2, y)) + (light(x, y + 2) + light(x + 2, y + 2));
        const glm::vec3 edges = (light(x + 1, y) + light(x, y + 1)) + (light(x + 2, y + 1) + light(x + 1, y + 2));
        return ((corners + 2.0f * edges) + 4.0f * light(x + 1, y + 1)) * 0.0625f;
    }
    return ((mean({{x, y}, half}) + mean({{x + half, y}, half})) + (mean({{x, y + half}, half}) + mean({{x + half, y + half}, half}))) *
           0.25f;
}

void AdaptiveSampler::put_pixels(Film& film) const {
    const int size = 1 << depth_;
    for (int y = 0; y < tile_.height(); ++y) {
        for (int x = 0; x < tile_.width(); ++x) {
            const std::size_t pixel = film.index(tile_.x0 + x, tile_.y0 + y);
            const std::size_t i = static_cast<std::size_t>(y) * static_cast<std::size_t>(tile_.width()) + static_cast<std::size_t>(x);
            film.radiance[pixel] = pixel_cut_[i] != 0 ? mean({{x * size, y * size}, size}) : mean_of_corners(x, y);
            film.samples[pixel] = samples_[i];
        }
    }
}

}  // namespace lancer
