// Samples of the path integrator: the whole picture with a few samples a pixel, again and again, so that it is there at once and gets better.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "lancer/render/sampler.h"

namespace lancer {

// The samples that one pass over the picture takes of each pixel.
struct PathPass {
    int first_sample = 0;
    int sample_count = 0;
};

// All passes for `spp` samples a pixel: few samples first, more later.
std::vector<PathPass> path_passes(int spp);

class PathSampler : public TileSampler {
public:
    static constexpr int tile_size = 32;

    // `sums` holds, for each pixel of the film, the sum of its samples before this pass. A pixel's sum grows by whole passes, in their order, so it
    // does not depend on threads or tiles.
    PathSampler(const Device& device, const PathPass& pass, std::vector<glm::dvec3>& sums) : device_(device), pass_(pass), sums_(sums) {}

    bool render_tile(const Tile& tile, Film& film, RayCounts& counts, const std::atomic<bool>* cancel) override;

private:
    const Device& device_;
    PathPass pass_;
    std::vector<glm::dvec3>& sums_;
    std::vector<glm::vec3> radiance_;
};

}  // namespace lancer
