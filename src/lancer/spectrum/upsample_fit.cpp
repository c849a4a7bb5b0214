#include "lancer/spectrum/upsample_fit.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "lancer/spectrum/cie_1931.h"
#include "lancer/spectrum/illuminant.h"
#include "lancer/spectrum/sensor.h"
#include "lancer/spectrum/upsample_grid.h"

namespace lancer {

// Simpson's rule on each of the observer's 5 nm. The weights of each channel sum to 1, so that greys come out exactly.
SmoothSpectrumFit::SmoothSpectrumFit() {
    glm::dvec3 total(0.0);
    for (int i = 0; i < 2 * cie_1931_count - 1; ++i) {
        const double nm = cie_1931_first + 0.5 * cie_1931_step * i;
        const double simpson = i == 0 || i == 2 * cie_1931_count - 2 ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
        const glm::dvec3 weight = simpson * unit_d65().at(nm) * sensor_weight(nm);
        nodes_.push_back({(nm - upsampling_middle) / upsampling_spread, {weight.x, weight.y, weight.z}});
        total += weight;
    }
    for (Node& node : nodes_) {
        for (int c = 0; c < 3; ++c) {
            node.weight[static_cast<std::size_t>(c)] /= total[c];
        }
    }
}

SmoothSpectrumFit::Slopes SmoothSpectrumFit::evaluate(const glm::dvec3& coefficients) const {
    Slopes slopes;
    for (const Node& node : nodes_) {
        const double p = (coefficients.x * node.t + coefficients.y) * node.t + coefficients.z;
        const double squeezed = 1.0 / (1.0 + p * p);
        const double root = std::sqrt(squeezed);
        const double dark = 0.5 * squeezed / (1.0 + std::fabs(p) * root);
        const double value = p < 0.0 ? dark : 1.0 - dark;
        const double slope = 0.5 * squeezed * root;
        for (std::size_t c = 0; c < 3; ++c) {
            slopes.rgb[c] += node.weight[c] * value;
            const double change = node.weight[c] * slope;
            slopes.by_coefficient[c][0] += change * node.t * node.t;
            slopes.by_coefficient[c][1] += change * node.t;
            slopes.by_coefficient[c][2] += change;
        }
    }
    return slopes;
}

glm::dvec3 SmoothSpectrumFit::rgb_of(const glm::dvec3& coefficients) const {
    const Slopes slopes = evaluate(coefficients);
    return {slopes.rgb[0], slopes.rgb[1], slopes.rgb[2]};
}

// Newton's steps, damped as Levenberg and Marquardt do where a plain one leads away from the goal.
double SmoothSpectrumFit::fit(const glm::dvec3& rgb, glm::dvec3& coefficients) const {
    const double brightest = std::max({rgb.x, rgb.y, rgb.z});
    const double small_enough = 1e-10 * std::max(brightest, 1e-12);
    const auto left_over = [&](const Slopes& s) { return rgb - glm::dvec3(s.rgb[0], s.rgb[1], s.rgb[2]); };
    Slopes slopes = evaluate(coefficients);
    glm::dvec3 difference = left_over(slopes);
    double damping = 0.0;
    for (int step = 0; step < 60 && glm::length(difference) > small_enough; ++step) {
        glm::dmat3 jacobian;  // [column][row]
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column) {
                jacobian[column][row] = slopes.by_coefficient[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
            }
        }
        glm::dvec3 move;
        if (damping == 0.0) {
            move = glm::inverse(jacobian) * difference;
        } else {
            glm::dmat3 normal = glm::transpose(jacobian) * jacobian;
            for (int i = 0; i < 3; ++i) {
                normal[i][i] *= 1.0 + damping;
            }
            move = glm::inverse(normal) * (glm::transpose(jacobian) * difference);
        }
        const glm::dvec3 tried = coefficients + move;
        const Slopes there = evaluate(tried);
        // Written so that what is no number counts as no progress.
        if (glm::length(left_over(there)) < glm::length(difference)) {
            coefficients = tried;
            slopes = there;
            difference = left_over(there);
            damping = damping < 1e-7 ? 0.0 : 0.1 * damping;
        } else {
            damping = damping == 0.0 ? 1e-4 : 10.0 * damping;
            if (damping > 1e8) {
                break;
            }
        }
    }
    return glm::length(difference);
}

}  // namespace lancer
