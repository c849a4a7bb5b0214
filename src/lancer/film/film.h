// The picture while it is being made: linear radiance and how many camera samples stand behind each pixel.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace lancer {

// Row-major, top row first.
struct Film {
    int width = 0;
    int height = 0;
    std::vector<glm::vec3> radiance;     // linear RGB, the mean of the pixel's samples
    std::vector<std::uint32_t> samples;  // camera samples that lie in the pixel; 0 = not rendered yet

    Film() = default;
    Film(int width_, int height_)
        : width(width_), height(height_), radiance(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), glm::vec3(0.0f)),
          samples(radiance.size(), 0) {}

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
};

}  // namespace lancer
