// What can follow rays: the CPU today, others behind the same few functions. A device belongs to one world and one camera.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

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
};

}  // namespace lancer
