// Progress over all frames of an animation.
#pragma once

#include "lancer/render/render.h"

namespace lancer::app {

// A picture is one of `all`: `before` it stand in files already, `skipped` of which had been there, and the others took `seconds`.
struct FramePart {
    int before = 0;
    int all = 1;
    int skipped = 0;
    double seconds = 0.0;
};

// How far all frames are when this one is so far. The rate is that of this frame.
RenderProgress over_all(const RenderProgress& progress, const FramePart& part);

// Tells it to another.
class FrameProgress : public RenderObserver {
public:
    // `all` must outlive this.
    FrameProgress(RenderObserver& all, const FramePart& part) : all_(all), part_(part) {}
    void tile_done(const Film& film, const Tile& tile, const RenderProgress& progress) override {
        all_.tile_done(film, tile, over_all(progress, part_));
    }

private:
    RenderObserver& all_;
    FramePart part_;
};

}  // namespace lancer::app
