// Renders into a canvas on threads of its own: first a coarse preview, then the picture.
#pragma once

#include <atomic>
#include <exception>
#include <optional>
#include <thread>

#include "lancer/app/prepare.h"
#include "lancer/app/window/canvas.h"

namespace lancer::app {

class Painter {
public:
    // Begins at once. `prepared` and `canvas` must outlive the painter.
    Painter(const Prepared& prepared, Canvas& canvas);
    ~Painter();  // stops what is under way
    Painter(const Painter&) = delete;
    Painter& operator=(const Painter&) = delete;

    bool is_done() const { return done_.load(std::memory_order_acquire); }

    // When done: what it took; nothing when it failed, and then this throws what went wrong.
    const RenderStatistics& statistics() const;

private:
    void paint();

    const Prepared& prepared_;
    Canvas& canvas_;
    std::atomic<bool> cancel_{false};
    std::atomic<bool> done_{false};  // what follows is written before it and read after it
    RenderStatistics statistics_;
    std::exception_ptr failure_;
    std::thread thread_;
};

}  // namespace lancer::app
