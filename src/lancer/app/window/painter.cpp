#include "lancer/app/window/painter.h"

#include "lancer/app/smaller_film.h"

namespace lancer::app {

Painter::Painter(const Prepared& prepared, Canvas& canvas) : prepared_(prepared), canvas_(canvas), thread_([this] { paint(); }) {}

Painter::~Painter() {
    cancel_ = true;
    thread_.join();
}

void Painter::paint() {
    try {
        constexpr int factor = 8;
        const Preview preview = render_preview(prepared_, factor, &cancel_);
        if (preview.statistics.finished) {
            canvas_.fill_with_preview(preview.film, factor);
        }
        Film film(prepared_.options.width, prepared_.options.height);
        statistics_ = render(*prepared_.device, prepared_.options, film, &canvas_, &cancel_);
    } catch (...) {
        failure_ = std::current_exception();
    }
    done_.store(true, std::memory_order_release);
}

const RenderStatistics& Painter::statistics() const {
    if (failure_) {
        std::rethrow_exception(failure_);
    }
    return statistics_;
}

}  // namespace lancer::app
