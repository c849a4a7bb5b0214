#include "lancer/app/window/painter.h"

#include <vector>

namespace lancer::app {

namespace {

// The same view on a film that is `factor` times smaller.
class SmallerFilm : public Device {
public:
    SmallerFilm(const Device& device, int factor) : device_(device), factor_(static_cast<float>(factor)) {}

    int lanes() const override { return device_.lanes(); }
    std::string description() const override { return device_.description(); }
    void follow(std::span<const glm::vec2> points, std::span<glm::vec3> radiance, RayCounts& counts) const override {
        std::vector<glm::vec2> scaled(points.begin(), points.end());
        for (glm::vec2& point : scaled) {
            point *= factor_;
        }
        device_.follow(scaled, radiance, counts);
    }

private:
    const Device& device_;
    float factor_;
};

}  // namespace

Painter::Painter(const Prepared& prepared, Canvas& canvas) : prepared_(prepared), canvas_(canvas), thread_([this] { paint(); }) {}

Painter::~Painter() {
    cancel_ = true;
    thread_.join();
}

void Painter::paint() {
    try {
        constexpr int factor = 8;
        RenderOptions coarse = prepared_.options;
        coarse.width = (coarse.width + factor - 1) / factor;
        coarse.height = (coarse.height + factor - 1) / factor;
        coarse.ssaa = 1;
        coarse.adaptive = false;
        Film preview(coarse.width, coarse.height);
        if (render(SmallerFilm(*prepared_.device, factor), coarse, preview, nullptr, &cancel_).finished) {
            canvas_.fill_with_preview(preview, factor);
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
