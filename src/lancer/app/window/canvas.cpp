#include "lancer/app/window/canvas.h"

#include <algorithm>
#include <utility>

#include "lancer/image/encode.h"

namespace lancer::app {

Canvas::Canvas(int width, int height, const ViewTransform& view)
    : width_(width), height_(height), view_(view), shown_(width, height), pixels_(shown_.radiance.size(), 0xff000000u) {}

// The pixels of a row from x on.
void Canvas::put_row(int x, int y, std::vector<glm::vec3> radiance) {
    const std::size_t first = shown_.index(x, y);
    std::copy(radiance.begin(), radiance.end(), shown_.radiance.begin() + static_cast<std::ptrdiff_t>(first));
    view_.apply(radiance);
    const auto byte = [](float light) { return std::uint32_t{quantise_srgb(light)}; };
    for (std::size_t i = 0; i < radiance.size(); ++i) {
        pixels_[first + i] = 0xff000000u | byte(radiance[i].x) << 16 | byte(radiance[i].y) << 8 | byte(radiance[i].z);
    }
}

void Canvas::mark(const Tile& tile) {
    if (!changed_) {
        changed_ = tile;
        return;
    }
    changed_->x0 = std::min(changed_->x0, tile.x0);
    changed_->y0 = std::min(changed_->y0, tile.y0);
    changed_->x1 = std::max(changed_->x1, tile.x1);
    changed_->y1 = std::max(changed_->y1, tile.y1);
}

void Canvas::tile_done(const Film& film, const Tile& tile, const RenderProgress& progress) {
    const std::scoped_lock lock(mutex_);
    for (int y = tile.y0; y < tile.y1; ++y) {
        const auto first = static_cast<std::ptrdiff_t>(film.index(tile.x0, y));
        const auto row = film.radiance.begin() + first;
        put_row(tile.x0, y, {row, row + tile.width()});
        std::copy_n(film.samples.begin() + first, tile.width(), shown_.samples.begin() + first);
    }
    mark(tile);
    progress_ = progress;
}

void Canvas::fill_with_preview(const Film& preview, int factor) {
    const std::scoped_lock lock(mutex_);
    for (int y = 0; y < height_; ++y) {
        std::vector<glm::vec3> row;
        for (int x = 0; x < width_; ++x) {
            row.push_back(preview.radiance[preview.index(x / factor, y / factor)]);
        }
        put_row(0, y, std::move(row));
    }
    mark({0, 0, width_, height_});
}

void Canvas::take_changes(const Draw& draw) {
    const std::scoped_lock lock(mutex_);
    if (changed_) {
        draw(pixels_.data() + shown_.index(changed_->x0, changed_->y0), width_, *changed_);
        changed_.reset();
    }
}

void Canvas::forget_what_was_taken() {
    const std::scoped_lock lock(mutex_);
    mark({0, 0, width_, height_});
}

RenderProgress Canvas::progress() const {
    const std::scoped_lock lock(mutex_);
    return progress_;
}

Film Canvas::snapshot() const {
    const std::scoped_lock lock(mutex_);
    return shown_;
}

}  // namespace lancer::app
