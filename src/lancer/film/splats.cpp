#include "lancer/film/splats.h"

#include <algorithm>
#include <cmath>

namespace lancer {

namespace {

void add_to(SplatSums::Fixed& sum, std::uint64_t low, std::int64_t high) {
    const std::uint64_t before = sum.low;
    sum.low += low;
    // Through unsigned words, which may run over.
    sum.high =
        static_cast<std::int64_t>(static_cast<std::uint64_t>(sum.high) + static_cast<std::uint64_t>(high) + (sum.low < before ? 1u : 0u));
}

// To the nearest multiple of 2^-64: exact but for floats below 2^-40, whose last bits are cut.
void add_float(SplatSums::Fixed& sum, float value) {
    const double x = std::clamp(static_cast<double>(value), -0x1p62, 0x1p62);
    const double whole = std::floor(x);
    const double rest = std::nearbyint((x - whole) * 0x1p64);
    const bool carries = rest >= 0x1p64;
    add_to(sum, carries ? 0u : static_cast<std::uint64_t>(rest), static_cast<std::int64_t>(whole) + (carries ? 1 : 0));
}

}  // namespace

SplatSums::SplatSums(int width, int height)
    : width_(width), height_(height), band_size_((static_cast<std::size_t>(width) * static_cast<std::size_t>(height) + bands - 1) / bands),
      sums_(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

void SplatSums::add(std::span<const Splat> splats, std::uint64_t paths) {
    paths_.fetch_add(paths, std::memory_order_relaxed);
    // By bands of the film, so that threads hardly wait for one another.
    std::array<std::vector<std::uint32_t>, bands> of_band;
    for (std::size_t i = 0; i < splats.size(); ++i) {
        of_band[splats[i].pixel / band_size_].push_back(static_cast<std::uint32_t>(i));
    }
    for (std::size_t band = 0; band < bands; ++band) {
        if (of_band[band].empty()) {
            continue;
        }
        const std::scoped_lock lock(locks_[band]);
        for (const std::uint32_t i : of_band[band]) {
            const Splat& splat = splats[i];
            Fixed* const sums = &sums_[3 * static_cast<std::size_t>(splat.pixel)];
            for (int c = 0; c < 3; ++c) {
                add_float(sums[c], splat.light[c]);
            }
        }
    }
}

void SplatSums::add(const SplatSums& other) {
    paths_.fetch_add(other.paths(), std::memory_order_relaxed);
    for (std::size_t i = 0; i < sums_.size(); ++i) {
        add_to(sums_[i], other.sums_[i].low, other.sums_[i].high);
    }
}

void SplatSums::take_away(const SplatSums& other) {
    paths_.fetch_sub(other.paths(), std::memory_order_relaxed);
    for (std::size_t i = 0; i < sums_.size(); ++i) {
        // Minus x is one more than x with all its bits turned over.
        add_to(sums_[i], ~other.sums_[i].low, ~other.sums_[i].high);
        add_to(sums_[i], 1u, 0);
    }
}

void SplatSums::set(std::span<const Fixed> words, std::uint64_t paths) {
    std::copy(words.begin(), words.end(), sums_.begin());
    paths_.store(paths, std::memory_order_relaxed);
}

glm::dvec3 SplatSums::mean(std::size_t pixel) const {
    const double paths_a_pixel = static_cast<double>(paths()) * 3.0 / static_cast<double>(sums_.size());
    if (paths_a_pixel == 0.0) {
        return glm::dvec3(0.0);
    }
    const std::scoped_lock lock(locks_[pixel / band_size_]);
    const auto wide = [](const Fixed& f) { return static_cast<double>(f.high) + static_cast<double>(f.low) * 0x1p-64; };
    return glm::dvec3(wide(sums_[3 * pixel]), wide(sums_[3 * pixel + 1]), wide(sums_[3 * pixel + 2])) / paths_a_pixel;
}

}  // namespace lancer
