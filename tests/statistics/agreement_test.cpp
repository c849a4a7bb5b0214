// Every integrator paints the same picture: blocks of pixels of independent renders, compared by z-tests.
//
// The false alarms: each scene and integrator makes 16 blocks x 3 colours of comparisons, of means over `renders` renders each. A block's z
// follows Student's distribution with about 2 (renders - 1) degrees of freedom; `most_z` is passed by chance in less than one of 10^6 of them
// (Welch's approximation), so this program raises one false alarm in some 3000 runs of other seeds. Seeds are fixed.
#include <cmath>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>
#include <glm/vec3.hpp>

#include "lancer/device/cpu/cpu.h"
#include "lancer/import/import.h"
#include "lancer/render/render.h"
#include "lancer/world/compile.h"

namespace lancer::statistics {
namespace {

constexpr int size = 32;
constexpr int blocks = 4;  // along each side
constexpr int renders = 10;
constexpr double most_z = 7.6;  // Student, 18 degrees of freedom: 1e-6 on both sides together is 7.2

struct Blocks {
    std::vector<glm::dvec3> mean;
    std::vector<glm::dvec3> variance;  // of the mean
};

// Light that is followed from the lamps alone can't be seen in mirrors and through glass.
void make_matt(scene::Scene& scene) {
    for (scene::Material& material : scene.materials) {
        const bool shiny = std::holds_alternative<scene::ConductorMaterial>(material.model) ||
                           std::holds_alternative<scene::DielectricMaterial>(material.model);
        if (shiny) {
            material.model = scene::DiffuseMaterial{scene::Rgb(0.6), 0.0};
        }
    }
}

Blocks rendered(const std::string& name, const std::string& integrator, bool matt, int spp, int first_seed) {
    std::vector<glm::dvec3> sum(blocks * blocks, glm::dvec3(0.0)), squares(blocks * blocks, glm::dvec3(0.0));
    for (int i = 0; i < renders; ++i) {
        Diagnostics diagnostics;
        std::optional<scene::Scene> scene = import_scene(LANCER_SOURCE_FOLDER "/scenes/" + name, diagnostics);
        if (!scene) {
            ADD_FAILURE() << name;
            break;
        }
        if (matt) {
            make_matt(*scene);
        }
        scene->settings.width = scene->settings.height = size;
        scene->settings.integrator = integrator;
        scene->settings.seed = first_seed + i;
        scene->settings.bounces = 8;
        const auto world = compile_world(*scene, scene->cameras.front(), diagnostics);
        if (!world) {
            ADD_FAILURE() << name << ": " << (diagnostics.list().empty() ? "" : to_string(diagnostics.list().back()));
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
        const double n = renders;
        const glm::dvec3 mean = sum[b] / n;
        result.mean.push_back(mean);
        result.variance.push_back(glm::max(squares[b] / n - mean * mean, glm::dvec3(0.0)) / (n - 1.0));
    }
    return result;
}

struct AgreementCase {
    std::string name;
    std::string scene;
    std::vector<std::string> integrators;
    int spp = 16;
    bool matt = false;
};

class Agreement : public testing::TestWithParam<AgreementCase> {};

TEST_P(Agreement, OfAllIntegrators) {
    const AgreementCase& c = GetParam();
    const Blocks path = rendered(c.scene, "path", c.matt, c.spp, 100);
    int seed = 200;
    for (const std::string& integrator : c.integrators) {
        const Blocks other = rendered(c.scene, integrator, c.matt, c.spp, seed);
        seed += 100;
        for (std::size_t b = 0; b < path.mean.size(); ++b) {
            for (int k = 0; k < 3; ++k) {
                const double spread = path.variance[b][k] + other.variance[b][k];
                // What two ways of rounding differ by.
                const double rounding = 1e-5 * path.mean[b][k];
                const double z = std::abs(path.mean[b][k] - other.mean[b][k]) / std::sqrt(spread + rounding * rounding + 1e-30);
                EXPECT_LT(z, most_z) << integrator << ", block " << b << ", colour " << k << ": path " << path.mean[b][k] << ", other "
                                     << other.mean[b][k];
            }
        }
    }
}

std::string name_of(const testing::TestParamInfo<AgreementCase>& one) { return one.param.name; }

INSTANTIATE_TEST_SUITE_P(Statistics, Agreement,
                         testing::Values(AgreementCase{"CornellBox", "gallery/cornell-box.toml", {"bdpt"}, 8},
                                         AgreementCase{"MattBox", "gallery/cornell-box.toml", {"light", "bdpt"}, 8, true},
                                         AgreementCase{"Principled", "features/principled.toml", {"bdpt"}, 4},
                                         AgreementCase{"ClearBodies", "features/clear-bodies.toml", {"bdpt"}, 4},
                                         AgreementCase{"VertexColors", "features/vertex-colors.toml", {"bdpt"}, 8}),
                         name_of);

INSTANTIATE_TEST_SUITE_P(SlowStatistics, Agreement,
                         testing::Values(AgreementCase{"CornellBoxWithPhotons", "gallery/cornell-box.toml", {"vcm"}},
                                         AgreementCase{"MattBoxWithPhotons", "gallery/cornell-box.toml", {"vcm"}, 16, true},
                                         AgreementCase{"MattRoom", "features/both-ends.toml", {"light", "bdpt", "vcm"}, 16, true},
                                         AgreementCase{"Lamps", "features/lamps.toml", {"bdpt"}},
                                         AgreementCase{"Plastics", "features/plastics.toml", {"bdpt"}},
                                         AgreementCase{"Metals", "features/metals.toml", {"bdpt"}},
                                         AgreementCase{"DepthOfField", "features/depth-of-field.toml", {"bdpt"}},
                                         AgreementCase{"Masks", "features/masks.toml", {"bdpt"}},
                                         AgreementCase{"Mixes", "features/mixes.toml", {"bdpt"}},
                                         AgreementCase{"Bumps", "features/bumps.toml", {"bdpt"}},
                                         AgreementCase{"Environment", "features/environment.toml", {"bdpt"}},
                                         AgreementCase{"StillLife", "gallery/still-life.toml", {"bdpt"}}),
                         name_of);

}  // namespace
}  // namespace lancer::statistics
