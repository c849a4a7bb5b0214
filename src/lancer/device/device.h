// What can follow rays: the CPU today, others behind the same few functions. A device belongs to one world and one camera.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lancer/film/path_samples.h"

namespace lancer {

struct RayCounts {
    std::uint64_t camera = 0;
    std::uint64_t secondary = 0;  // reflected and refracted
    std::uint64_t shadow = 0;

    std::uint64_t total() const { return camera + secondary + shadow; }
    RayCounts& operator+=(const RayCounts& other) {
        camera += other.camera;
        secondary += other.secondary;
        shadow += other.shadow;
        return *this;
    }
};

// Samples of the pixels of a rectangle: from (x0, y0) to before (x1, y1), and for each of them the samples from `first_sample` on.
struct PathRange {
    int x0 = 0;
    int y0 = 0;
    int x1 = 0;
    int y1 = 0;
    int first_sample = 0;
    int sample_count = 0;

    std::size_t paths() const {
        return static_cast<std::size_t>(x1 - x0) * static_cast<std::size_t>(y1 - y0) * static_cast<std::size_t>(sample_count);
    }
};

// Where a path's light went wrong.
struct PathFault {
    enum class What { none, not_a_number, infinite, negative };
    What what = What::none;
    int vertex = -1;  // of the path, the first after the camera is 0
    int object = -1;  // into World::objects; -1: it met nothing
    int material = -1;
};

class Device {
public:
    virtual ~Device() = default;

    // How many consecutive points are followed together; points near one another on the film should come together, in runs of this length.
    virtual int lanes() const = 0;

    // What it is, for people: "CPU, AVX-512, all primitives in lanes".
    virtual std::string description() const = 0;

    // Radiance (linear RGB) that arrives at each point of the film. Points are in pixels from the upper left corner of the picture:
    // (0.5, 0.5) is the centre of the first pixel. `radiance` is as long as `points`. Pure: the same point gives the same bits whatever
    // comes with it. Called from many threads at once. Rays followed are added to `counts`.
    virtual void follow(std::span<const glm::vec2> points, std::span<glm::vec3> radiance, RayCounts& counts) const = 0;

    // The path integrator: what is asked for of every sample of the range, pixel by pixel in rows, a pixel's samples together; the spans of
    // `samples` have range.paths() entries, or none. Pure and called from many threads, as above.
    virtual void trace_paths(const PathRange& range, const PathSamples& samples, RayCounts& counts) const = 0;

    // Whether the world's integrator follows light from the lamps, too: then `samples` should have a place for splats, and of what else it may ask for
    // only radiance and first hits are filled. A pixel of the picture is the mean of its samples plus its splats over the number of samples that each pixel has.
    virtual bool makes_splats() const { return false; }

    // Their radiance alone.
    void follow_paths(const PathRange& range, std::span<glm::vec3> radiance, RayCounts& counts) const {
        trace_paths(range, {radiance, {}, {}, {}, nullptr}, counts);
    }

    // Follows a sample again whose radiance was NaN, to see where that came from.
    virtual PathFault find_fault(int /*x*/, int /*y*/, int /*sample*/) const { return {}; }
};

}  // namespace lancer
