// Finds the smooth spectrum of a colour without a table: what the table is made of, and a check on it.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <vector>

namespace lancer {

class SmoothSpectrumFit {
public:
    SmoothSpectrumFit();

    // Changes `coefficients` (see upsample.h) until their reflectance looks like `rgb` under D65. Returns what is left of the difference.
    double fit(const glm::dvec3& rgb, glm::dvec3& coefficients) const;

    glm::dvec3 rgb_of(const glm::dvec3& coefficients) const;

private:
    struct Node {
        double t;
        std::array<double, 3> weight;
    };
    struct Slopes {
        std::array<double, 3> rgb{};
        std::array<std::array<double, 3>, 3> by_coefficient{};  // of each component of rgb
    };
    Slopes evaluate(const glm::dvec3& coefficients) const;

    std::vector<Node> nodes_;
};

}  // namespace lancer
