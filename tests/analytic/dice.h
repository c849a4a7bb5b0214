// Random numbers for tests: the same on every machine and with every library.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace lancer::tests {

class Dice {
public:
    explicit Dice(std::uint64_t seed) : state_(seed) {}

    // [Steele et al. 2014], SplitMix64.
    std::uint64_t bits() {
        state_ += 0x9e3779b97f4a7c15u;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }

    double between(double low, double high) { return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53; }
    double log_between(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
    int below(int count) { return static_cast<int>(bits() % static_cast<std::uint64_t>(count)); }
    bool coin() { return (bits() >> 63) != 0; }
    double sign() { return coin() ? 1.0 : -1.0; }

    glm::dvec3 in_cube(double half) {
        const double x = between(-half, half);
        const double y = between(-half, half);
        return {x, y, between(-half, half)};
    }

    // Uniform on the unit sphere.
    glm::dvec3 direction() {
        const double y = between(-1.0, 1.0);
        const double angle = between(0.0, 2.0 * std::numbers::pi);
        const double ring = std::sqrt(1.0 - y * y);
        return {ring * std::cos(angle), y, ring * std::sin(angle)};
    }

    glm::dmat4 rotation() {
        const double angle = between(0.0, 2.0 * std::numbers::pi);
        return glm::rotate(glm::dmat4(1.0), angle, direction());
    }

private:
    std::uint64_t state_;
};

}  // namespace lancer::tests
