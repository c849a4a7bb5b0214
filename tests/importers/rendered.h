// Small pictures of what was read.
#pragma once

#include <cmath>
#include <cstring>
#include <memory>
#include <string>

#include "lancer/device/cpu/cpu.h"
#include "lancer/film/film.h"
#include "lancer/render/render.h"
#include "lancer/world/compile.h"
#include "reading.h"

namespace lancer::testing {

// Linear radiance, as seen by the scene's first camera; empty when it can't be rendered.
inline Film film_of(scene::Scene scene, int width, int height, int spp) {
    scene.settings.width = width;
    scene.settings.height = height;
    scene.settings.spp = spp;
    Diagnostics diagnostics;
    Film film(width, height);
    const std::shared_ptr<const World> world = compile_world(scene, scene.cameras.front(), diagnostics);
    if (world == nullptr) {
        ADD_FAILURE() << (diagnostics.list().empty() ? "" : to_string(diagnostics.list().front()));
        return Film(0, 0);
    }
    CpuOptions cpu;
    cpu.threads = 1;
    RenderOptions options;
    options.width = width;
    options.height = height;
    options.threads = 1;
    options.spp = scene::follows_paths(scene) ? spp : 0;
    render(*make_cpu_device(world, cpu), options, film);
    return film;
}

// The same bits.
inline bool same_pixels(const Film& a, const Film& b) {
    return a.width == b.width && a.height == b.height && !a.radiance.empty() && a.radiance.size() == b.radiance.size() &&
           std::memcmp(a.radiance.data(), b.radiance.data(), a.radiance.size() * sizeof(a.radiance[0])) == 0;
}

}  // namespace lancer::testing
