// A coarse look at a picture: the same view on a film that is some times smaller.
#pragma once

#include "lancer/app/prepare.h"
#include "lancer/device/device.h"
#include "lancer/film/film.h"

namespace lancer::app {

class SmallerFilm : public Device {
public:
    // `device` must outlive it.
    SmallerFilm(const Device& device, int factor) : device_(device), factor_(factor) {}

    int lanes() const override { return device_.lanes(); }
    std::string description() const override { return device_.description(); }
    void follow(std::span<const glm::vec2> points, std::span<glm::vec3> radiance, RayCounts& counts) const override;
    void trace_paths(const PathRange& range, const PathSamples& samples, RayCounts& counts) const override;

private:
    const Device& device_;
    int factor_;
};

// One sample for each pixel of the smaller film.
struct Preview {
    Film film;
    RenderStatistics statistics;
};
Preview render_preview(const Prepared& prepared, int factor, const std::atomic<bool>* cancel);

}  // namespace lancer::app
