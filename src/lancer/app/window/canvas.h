// What the window shows: the newest state of the picture, written by the threads that render and read by the one that draws.
#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <vector>

#include "lancer/film/film.h"
#include "lancer/image/view.h"
#include "lancer/render/render.h"

namespace lancer::app {

class Canvas : public RenderObserver {
public:
    Canvas(int width, int height, const ViewTransform& view);

    int width() const { return width_; }
    int height() const { return height_; }

    // From the threads that render.
    void tile_done(const Film& film, const Tile& tile, const RenderProgress& progress) override;
    // A picture `factor` times smaller that stands in until tiles come.
    void fill_with_preview(const Film& preview, int factor);

    // From the thread that draws. Hands over what has changed since the last time: pixels as 0xffRRGGBB, `stride` pixels from row to row,
    // starting at the upper left corner of `changed`. Not called when nothing has.
    using Draw = std::function<void(const std::uint32_t* pixels, int stride, const Tile& changed)>;
    void take_changes(const Draw& draw);
    void forget_what_was_taken();  // everything counts as changed again

    RenderProgress progress() const;
    Film snapshot() const;  // as it is shown

private:
    void put_row(int x, int y, std::vector<glm::vec3> radiance);  // `mutex_` is held
    void mark(const Tile& tile);                                  // `mutex_` is held

    const int width_;
    const int height_;
    const ViewTransform view_;

    mutable std::mutex mutex_;  // guards all that follows
    Film shown_;
    std::vector<std::uint32_t> pixels_;
    std::optional<Tile> changed_;
    RenderProgress progress_;
};

}  // namespace lancer::app
