// Worlds of a few media, and what a camera sees of them on average.
#pragma once

#include <cmath>

#include "analytic/small_world.h"

namespace lancer::tests {

struct Mean {
    glm::dvec3 value{0.0};
    glm::dvec3 error{0.0};  // standard
};

// Follows paths as RGB unless asked for more, 8 x 8 pixels of a hair's breadth that all look straight ahead.
class FogWorld : public SmallWorld {
public:
    explicit FogWorld(int bounces = 1) {
        scene.settings.integrator = "path";
        scene.settings.bounces = bounces;
        scene.settings.rgb = true;
        scene.settings.filter = scene::PixelFilter::box;
        scene.settings.width = scene.settings.height = 8;
        scene.cameras[0].fov = 0.001;
    }

    int material(const scene::Material& m) {
        scene.materials.push_back(m);
        return static_cast<int>(scene.materials.size()) - 1;
    }

    int medium(const scene::Medium& m) {
        scene.media.push_back(m);
        return static_cast<int>(scene.media.size()) - 1;
    }

    // A null border around it.
    int border(const scene::Medium& m, int priority = 0) {
        scene::Material result;
        result.model = scene::NullMaterial{};
        result.interior = medium(m);
        result.priority = priority;
        return material(result);
    }

    Mean see(int spp, const CpuOptions& options = {}) const {
        const int size = scene.settings.width;
        const auto device = make_cpu_device(compile(), options);
        const PathRange range{0, 0, size, size, 0, spp};
        std::vector<glm::vec3> radiance(range.paths());
        RayCounts counts;
        device->follow_paths(range, radiance, counts);
        Mean mean;
        glm::dvec3 squares(0.0);
        for (const glm::vec3& r : radiance) {
            const glm::dvec3 value(r);
            mean.value += value;
            squares += value * value;
        }
        const double n = static_cast<double>(radiance.size());
        mean.value /= n;
        for (int i = 0; i < 3; ++i) {
            mean.error[i] = std::sqrt(std::max(squares[i] / n - mean.value[i] * mean.value[i], 0.0) / n);
        }
        return mean;
    }
};

inline scene::Medium medium_of(const scene::Color& absorption, const scene::Color& scattering, double asymmetry = 0.0) {
    scene::Medium m;
    m.coefficients = scene::AbsorbingScattering{absorption, scattering};
    m.asymmetry = asymmetry;
    return m;
}

// Values of `channels` each in a box of `size`; x runs fastest.
inline scene::Grid grid_of(const glm::ivec3& size, std::vector<float> values, const glm::dvec3& low, const glm::dvec3& high,
                           int channels = 1) {
    auto data = std::make_shared<scene::VoxelData>();
    data->size = size;
    data->channels = channels;
    data->values = std::move(values);
    scene::Grid grid;
    grid.data = data;
    for (int i = 0; i < 3; ++i) {
        grid.to_world[i][i] = high[i] - low[i];
        grid.to_world[3][i] = low[i];
    }
    return grid;
}

// Of samples that are independent, five deviations are one false alarm in two million.
constexpr double deviations = 5.0;

}  // namespace lancer::tests
