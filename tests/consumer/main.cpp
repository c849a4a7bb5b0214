// Uses lancer as a library: a scene from memory, rendered in this process, and two pixels that must have the colours written in it.
#include <cmath>
#include <cstdio>

#include "lancer/device/cpu/cpu.h"
#include "lancer/import/import.h"
#include "lancer/render/render.h"
#include "lancer/world/compile.h"

namespace {

// A sphere that gives back ambient light only, before a blue background: its pixels are exactly its colour.
constexpr const char* text = R"(
    [camera]
    position = [0, 0, 5]
    look_at = [0, 0, 0]
    fov = 60

    [render]
    size = [16, 16]

    [background]
    color = [0, 0, 1]

    [[light]]
    type = "point"
    position = [0, 5, 5]

    [[sphere]]
    radius = 1
    material = { color = [0.25, 0.5, 0.75], ambient = 1, diffuse = 0, highlight = 0 }
)";

bool is(const glm::vec3& color, float r, float g, float b) {
    return std::abs(color.x - r) < 1e-6f && std::abs(color.y - g) < 1e-6f && std::abs(color.z - b) < 1e-6f;
}

}  // namespace

int main() {
    lancer::Diagnostics diagnostics;
    const auto scene = lancer::import_toml(text, "memory.toml", diagnostics);
    const auto world = scene ? lancer::compile_world(*scene, scene->cameras.front(), diagnostics) : nullptr;
    for (const lancer::Diagnostic& diagnostic : diagnostics.list()) {
        std::puts(lancer::to_string(diagnostic).c_str());
    }
    if (!world) {
        return 1;
    }

    lancer::RenderOptions options;
    options.width = 16;
    options.height = 16;
    lancer::Film film(options.width, options.height);
    const auto device = lancer::make_cpu_device(world);
    const lancer::RenderStatistics statistics = lancer::render(*device, options, film);

    const glm::vec3 middle = film.radiance[film.index(8, 8)];
    const glm::vec3 corner = film.radiance[film.index(0, 0)];
    std::printf("%s: middle %g %g %g, corner %g %g %g\n", device->description().c_str(), static_cast<double>(middle.x),
                static_cast<double>(middle.y), static_cast<double>(middle.z), static_cast<double>(corner.x), static_cast<double>(corner.y),
                static_cast<double>(corner.z));
    return statistics.finished && is(middle, 0.25f, 0.5f, 0.75f) && is(corner, 0.0f, 0.0f, 1.0f) ? 0 : 1;
}
