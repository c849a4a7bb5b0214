// Do two integrators paint the same picture? Blocks of pixels of independent renders, compared by z-tests.
//
// The false alarms: each comparison is of 16 blocks x 3 colours, of means over `renders` renders each. A block's z follows Student's distribution with
// about 2 (renders - 1) degrees of freedom; `most_z` is passed by chance in less than one of 10^6 of them (Welch's approximation), so that a program
// that makes 10 comparisons raises one false alarm in some 2000 runs of other seeds. Seeds are fixed.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/vec3.hpp>

#include "lancer/device/cpu/cpu.h"
#include "lancer/render/render.h"
#include "lancer/world/compile.h"

namespace lancer::statistics {

constexpr int agreement_size = 32;
constexpr int agreement_blocks = 4;  // along each side
constexpr int agreement_renders = 10;
constexpr double most_z = 7.6;  // Student, 18 degrees of freedom: 1e-6 on both sides together is 7.2

struct Blocks {
    std::vector<glm::dvec3> mean;
    std::vector<glm::dvec3> variance;  // of the mean
};

inline Blocks rendered_blocks(scene::Scene scene, const std::string& integrator, int spp, int first_seed) {
    constexpr int size = agreement_size, blocks = agreement_blocks;
    std::vector<glm::dvec3> sum(blocks * blocks, glm::dvec3(0.0)), squares(blocks * blocks, glm::dvec3(0.0));
    scene.settings.width = scene.settings.height = size;
    scene.settings.integrator = integrator;
    for (int i = 0; i < agreement_renders; ++i) {
        scene.settings.seed = first_seed + i;
        Diagnostics diagnostics;
        const auto world = compile_world(scene, scene.cameras.front(), diagnostics);
        if (!world) {
            ADD_FAILURE() << (diagnostics.list().empty() ? "" : to_string(diagnostics.list().back()));
            break;
        }
        const auto device = make_cpu_device(world);
        RenderOptions options;
        options.width = options.height = size;
        options.spp = spp;
        Film film(size, size);
        render(*device, options, film);
        std::vector<glm::dvec3> one(blocks * blocks, glm::dvec3(0.0));
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                const int block = y * blocks / size * blocks + x * blocks / size;
                const glm::vec3& c = film.radiance[film.index(x, y)];
                one[static_cast<std::size_t>(block)] += glm::dvec3(double(c.x), double(c.y), double(c.z));
            }
        }
        for (std::size_t b = 0; b < one.size(); ++b) {
            sum[b] += one[b];
            squares[b] += one[b] * one[b];
        }
    }
    Blocks result;
    for (std::size_t b = 0; b < sum.size(); ++b) {
        const double n = agreement_renders;
        const glm::dvec3 mean = sum[b] / n;
        result.mean.push_back(mean);
        result.variance.push_back(glm::max(squares[b] / n - mean * mean, glm::dvec3(0.0)) / (n - 1.0));
    }
    return result;
}

inline void expect_agreement(const Blocks& path, const Blocks& other, const std::string& integrator) {
    double largest = 0.0;
    for (std::size_t b = 0; b < path.mean.size(); ++b) {
        for (int k = 0; k < 3; ++k) {
            const double spread = path.variance[b][k] + other.variance[b][k];
            // What two ways of rounding differ by.
            const double rounding = 1e-5 * path.mean[b][k];
            const double z = std::abs(path.mean[b][k] - other.mean[b][k]) / std::sqrt(spread + rounding * rounding + 1e-30);
            largest = std::max(largest, z);
            EXPECT_LT(z, most_z) << integrator << ", block " << b << ", colour " << k << ": path " << path.mean[b][k] << ", other "
                                 << other.mean[b][k];
        }
    }
    testing::Test::RecordProperty("largest_z_" + integrator, std::to_string(largest));
}

}  // namespace lancer::statistics
