// Light that falls anywhere on the film: what paths from the lamps bring.
//
// Sums are whole numbers of 2^-64, so that they are the same in whatever order and by however many threads they are made, and two films added are the
// film of both.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace lancer {

// For one pixel, linear RGB, the filter's weight included; finite.
struct Splat {
    std::uint32_t pixel = 0;
    glm::vec3 light{0.0f};
};

class SplatSums {
public:
    SplatSums(int width, int height);

    int width() const { return width_; }
    int height() const { return height_; }

    // Many threads may add at the same time. What is smaller than 2^-65 counts as 0, what is larger than 2^62 as that.
    // `paths`: how many paths of light brought them.
    void add(std::span<const Splat> splats, std::uint64_t paths);
    void add(const SplatSums& other);        // of the same size
    void take_away(const SplatSums& other);  // what was added before

    // What the pixel has of light, as if each pixel had had its share of the paths.
    glm::dvec3 mean(std::size_t pixel) const;
    std::uint64_t paths() const { return paths_.load(std::memory_order_relaxed); }

    // The sums themselves, low and high word, three for each pixel: for files.
    struct Fixed {
        std::uint64_t low = 0;
        std::int64_t high = 0;
    };
    std::span<const Fixed> words() const { return sums_; }
    void set(std::span<const Fixed> words, std::uint64_t paths);

private:
    static constexpr std::size_t bands = 64;

    int width_;
    int height_;
    std::size_t band_size_;  // pixels
    std::vector<Fixed> sums_;
    std::atomic<std::uint64_t> paths_{0};
    mutable std::array<std::mutex, bands> locks_;
};

}  // namespace lancer
