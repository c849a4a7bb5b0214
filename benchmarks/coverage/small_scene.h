// What the benchmarks of stated errors have in common. Each ends the program with a message where something is wrong with the scene.
#pragma once

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "lancer/device/cpu/cpu.h"
#include "lancer/import/import.h"
#include "lancer/render/goal_plan.h"
#include "lancer/world/compile.h"

namespace lancer {

// Of all threads, since the start.
inline double processor_seconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

[[noreturn]] inline void give_up(const std::string& path, const Diagnostics& diagnostics) {
    fmt::print(stderr, "{}: {}\n", path, to_string(diagnostics.list().front()));
    std::exit(2);
}

// So many pixels wide, of its own shape, by paths from the camera.
inline scene::Scene read_small(const std::string& path, int width) {
    Diagnostics diagnostics;
    std::optional<scene::Scene> scene = import_scene(path, diagnostics);
    if (!scene) {
        give_up(path, diagnostics);
    }
    const double shape = static_cast<double>(scene->settings.height) / scene->settings.width;
    scene->settings.integrator = "path";
    scene->settings.width = width;
    scene->settings.height = std::max(8, static_cast<int>(std::lround(width * shape)));
    return *std::move(scene);
}

inline std::unique_ptr<Device> make_device(const scene::Scene& scene) {
    Diagnostics diagnostics;
    const auto world = compile_world(scene, scene.cameras.front(), diagnostics);
    if (world == nullptr) {
        give_up(scene.file, diagnostics);
    }
    return make_cpu_device(world, {});
}

// Of one thread. Where there is no error to reach it is measured all the same.
inline RenderOptions goal_options(const Device& device, const scene::Scene& scene, double error, int spp) {
    RenderOptions options;
    options.width = scene.settings.width;
    options.height = scene.settings.height;
    options.threads = 1;
    options.spp = spp;
    options.goal.error = error;
    options.intervals = true;
    options.goal = plan_goal(device, options);
    return options;
}

}  // namespace lancer
