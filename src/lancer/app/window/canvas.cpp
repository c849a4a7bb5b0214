#include "lancer/app/window/canvas.h"

#include <algorithm>
#include <cmath>

#include "lancer/image/encode.h"

namespace lancer::app {

Canvas::Canvas(int width, int height, double exposure)
    : width_(width), height_(height), scale_(static_cast<float>(std::exp2(exposure))), shown_(width, height),
      pixels_(shown_.radiance.size(), 0xff000000u) {}

void Canvas::put(int x, int y, const glm::vec3& radiance) {
    const auto byte = [&](float light) { return std::uint32_t{quantise_srgb(light * scale_)}; };
    const std::size_t i = shown_.index(x, y);
    shown_.radiance[i] = radiance;
    pixels_[i] = 0xff000000u | byte(radiance.x) << 16 | byte(radiance.y) << 8 | byte(radiance.z);
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
        for (int x = tile.x0; x < tile.x1; ++x) {
            put(x, y, film.radiance[film.index(x, y)]);
            shown_.samples[shown_.index(x, y)] = film.samples[film.index(x, y)];
        }
    }
    mark(tile);
    progress_ = progress;
}

void Canvas::fill_with_preview(const Film& preview, int factor) {
    const std::scoped_lock lock(mutex_);
    for (int y = 0; y < height_; ++y) {
        for (int x = 0; x < width_; ++x) {
            put(x, y, preview.radiance[preview.index(x / factor, y / factor)]);
        }
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
