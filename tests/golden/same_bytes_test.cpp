// The same scene gives the same bytes: for any number of threads, any order of the tiles, any number of lanes, and from one run to the next.
#include <cstring>
#include <map>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "lancer/base/failure.h"
#include "lancer/device/cpu/cpu.h"
#include "lancer/import/import.h"
#include "lancer/render/render.h"
#include "lancer/world/compile.h"

namespace lancer {
namespace {

std::shared_ptr<const World> load(const std::string& name, int width, int height, const std::string& integrator = "auto") {
    Diagnostics diagnostics;
    std::optional<scene::Scene> scene = import_scene(LANCER_SOURCE_FOLDER "/scenes/" + name, diagnostics);
    if (!scene) {
        ADD_FAILURE() << name << ": " << (diagnostics.list().empty() ? "" : to_string(diagnostics.list().front()));
        return nullptr;
    }
    scene->settings.width = width;
    scene->settings.height = height;
    if (integrator != "auto") {
        scene->settings.integrator = integrator;
    }
    return compile_world(*scene, scene->cameras.front(), diagnostics);
}

bool same_bytes(const Film& a, const Film& b) {
    return a.radiance.size() == b.radiance.size() &&
           std::memcmp(a.radiance.data(), b.radiance.data(), a.radiance.size() * sizeof(glm::vec3)) == 0 && a.samples == b.samples;
}

struct Case {
    std::string name;
    std::string scene;
    bool adaptive = false;
    Tracer tracer = Tracer::automatic;
    int spp = 0;  // path integrator
    std::string integrator = "auto";
};

class SameBytes : public testing::TestWithParam<Case> {
protected:
    // Not a whole number of tiles, lanes or blocks.
    static constexpr int width = 149;
    static constexpr int height = 83;

    void SetUp() override {
        world_ = load(GetParam().scene, width, height, GetParam().integrator);
        ASSERT_NE(world_, nullptr);
        options_.width = width;
        options_.height = height;
        options_.ssaa = 2;
        options_.spp = GetParam().spp;
        options_.adaptive = GetParam().adaptive;
        options_.threads = 1;
    }

    std::unique_ptr<Device> device(int lanes = 0) const {
        CpuOptions cpu;
        cpu.tracer = GetParam().tracer;
        cpu.lanes = lanes;
        return make_cpu_device(world_, cpu);
    }

    static Film film_of(const Device& device, const RenderOptions& options) {
        Film film(width, height);
        render(device, options, film);
        return film;
    }

    std::shared_ptr<const World> world_;
    RenderOptions options_;
};

TEST_P(SameBytes, ForAnyNumberOfThreads) {
    const std::unique_ptr<Device> device = this->device();
    const Film one = film_of(*device, options_);
    for (const int threads : {2, 3, 7, 16}) {
        options_.threads = threads;
        EXPECT_TRUE(same_bytes(one, film_of(*device, options_))) << threads << " threads";
    }
}

TEST_P(SameBytes, ForAnyOrderOfTheTiles) {
    const std::unique_ptr<Device> device = this->device();
    const Film in_rows = film_of(*device, options_);
    for (const std::uint32_t seed : {1u, 2u, 3u, 4u}) {
        options_.shuffle = seed;
        options_.threads = 3;
        EXPECT_TRUE(same_bytes(in_rows, film_of(*device, options_))) << "order " << seed;
    }
}

TEST_P(SameBytes, FromOneDeviceToTheNext) { EXPECT_TRUE(same_bytes(film_of(*device(), options_), film_of(*device(), options_))); }

TEST_P(SameBytes, ForAnyNumberOfLanes) {
    const Film widest = film_of(*device(), options_);
    int compared = 0;
    for (const int lanes : {4, 8, 16}) {
        try {
            EXPECT_TRUE(same_bytes(widest, film_of(*device(lanes), options_))) << lanes << " lanes";
            ++compared;
        } catch (const MachineFailure&) {
            // this processor has no such registers
        }
    }
    EXPECT_GE(compared, 1);
}

INSTANTIATE_TEST_SUITE_P(Golden, SameBytes,
                         testing::Values(Case{"Figure1", "report/figure-1.toml"}, Case{"Figure1Adaptive", "report/figure-1.toml", true},
                                         Case{"Figure1InTheTree", "report/figure-1.toml", false, Tracer::tree},
                                         Case{"Lights", "report/lights.toml"}, Case{"Benchmark", "benchmark/whitted.toml", true},
                                         Case{"Paths", "gallery/cornell-box.toml", false, Tracer::automatic, 7},
                                         Case{"PathsInTheTree", "features/principled.toml", false, Tracer::tree, 4},
                                         Case{"ManyLights", "features/many-lights.toml", false, Tracer::automatic, 3},
                                         Case{"ClearSky", "features/sky.toml", false, Tracer::automatic, 3},
                                         Case{"Light", "gallery/cornell-box.toml", false, Tracer::automatic, 3, "light"},
                                         Case{"BothEnds", "gallery/cornell-box.toml", false, Tracer::automatic, 3, "bdpt"},
                                         Case{"BothEndsInTheTree", "features/principled.toml", false, Tracer::tree, 2, "bdpt"},
                                         Case{"Photons", "gallery/cornell-box.toml", false, Tracer::automatic, 1, "vcm"},
                                         Case{"Fog", "features/fog-balls.toml", false, Tracer::automatic, 2},
                                         Case{"CloudInTheTree", "features/fog-cloud.toml", false, Tracer::tree, 1}),
                         [](const auto& one) { return one.param.name; });

TEST(SameBytes, BothTracersGiveTheSamePicture) {
    // Not bit for bit: rounding decides at silhouettes. But no more than that.
    for (const char* name : {"report/figure-1.toml", "report/lights.toml", "benchmark/whitted.toml"}) {
        const std::shared_ptr<const World> world = load(name, 160, 90);
        ASSERT_NE(world, nullptr);
        RenderOptions options;
        options.width = 160;
        options.height = 90;
        CpuOptions cpu;
        std::map<Tracer, Film> films;
        for (const Tracer tracer : {Tracer::all_objects, Tracer::tree}) {
            cpu.tracer = tracer;
            Film& film = films.try_emplace(tracer, options.width, options.height).first->second;
            render(*make_cpu_device(world, cpu), options, film);
        }
        const Film& a = films.at(Tracer::all_objects);
        const Film& b = films.at(Tracer::tree);
        int different = 0;
        for (std::size_t i = 0; i < a.radiance.size(); ++i) {
            const glm::vec3 d = a.radiance[i] - b.radiance[i];
            different += d.x * d.x + d.y * d.y + d.z * d.z > 1e-6f ? 1 : 0;
        }
        EXPECT_LE(different, 14) << name << ": more than one pixel in a thousand";
    }
}

// Adaptive anti-aliasing is to reach the error of 4x4 samples a pixel with at most a third of the rays from the camera. Small as it is here,
// the picture has many edges for its size: at 1920x1080 a seventh is enough.
TEST(AdaptiveSampling, NeedsAThirdOfTheRaysOnTheBenchmark) {
    constexpr int width = 480;
    constexpr int height = 270;
    const std::shared_ptr<const World> world = load("benchmark/whitted.toml", width, height);
    ASSERT_NE(world, nullptr);
    const std::unique_ptr<Device> device = make_cpu_device(world);
    RenderOptions options;
    options.width = width;
    options.height = height;

    options.ssaa = 16;
    Film truth(width, height);
    render(*device, options, truth);
    const auto error = [&](const Film& film) {
        double sum = 0.0;
        for (std::size_t i = 0; i < film.radiance.size(); ++i) {
            const glm::dvec3 d = glm::dvec3(film.radiance[i]) - glm::dvec3(truth.radiance[i]);
            sum += d.x * d.x + d.y * d.y + d.z * d.z;
        }
        return sum;
    };
    options.ssaa = 4;
    Film grid(width, height);
    const RenderStatistics grid_work = render(*device, options, grid);
    options.adaptive = true;
    Film adaptive(width, height);
    const RenderStatistics adaptive_work = render(*device, options, adaptive);

    EXPECT_LE(error(adaptive), error(grid));
    EXPECT_LE(3 * adaptive_work.rays.camera, grid_work.rays.camera);
}

}  // namespace
}  // namespace lancer
