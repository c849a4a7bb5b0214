// What a device tells of each sample of the path integrator.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "lancer/film/splats.h"

namespace lancer {

// What the sample's path met first, in world space. All zeros but for the ids where it met nothing.
struct FirstHit {
    glm::vec3 albedo{0.0f};    // share of the light that comes back, linear RGB
    glm::vec3 normal{0.0f};    // smooth, turned to the camera, length 1
    glm::vec3 position{0.0f};  // metres
    float depth = 0.0f;        // metres along the camera's view; of a panorama: from the camera
    glm::vec2 uv{0.0f};
    float weight = 0.0f;  // of the sample in its pixel's filter
    int object = -1;      // into World::objects
    int material = -1;
};

// Four wavelengths of a path: what each adds to the integral of radiance over all wavelengths, the filter's weight included.
struct SpectralSample {
    glm::vec4 power{0.0f};
    glm::vec4 nanometres{0.0f};
};

// Places for all samples of a range, a pixel's samples together. Spans are as long as there are samples, or empty: not asked for.
struct PathSamples {
    // Linear RGB, the filter's weight included. NaN where the path's light was not a number, infinite or negative: never anything else that is wrong.
    std::span<glm::vec3> radiance;
    std::span<glm::vec3> direct;  // the part that was emitted towards the camera or scattered once
    std::span<FirstHit> first_hits;
    std::span<SpectralSample> spectra;
    // Where light that falls anywhere on the film is appended. Who gives no place for it gets paths from the camera alone.
    std::vector<Splat>* splats = nullptr;

    PathSamples part(std::size_t first, std::size_t count) const {
        const auto cut = [&](auto span) { return span.empty() ? span : span.subspan(first, count); };
        return {cut(radiance), cut(direct), cut(first_hits), cut(spectra), splats};
    }
};

}  // namespace lancer
