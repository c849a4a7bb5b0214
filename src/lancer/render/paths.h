// Samples of the path integrator: the whole picture with a few samples a pixel, again and again, so that it is there at once and gets better.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "lancer/film/film_sums.h"
#include "lancer/render/bad_samples.h"
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

    // `sums` holds what the passes before this one have found. A pixel's sums grow by whole passes, in their order, so they do not depend on
    // threads or tiles. Samples that are left out are noted in `bad`.
    PathSampler(const Device& device, const PathPass& pass, FilmSums& sums, BadSamples& bad)
        : device_(device), pass_(pass), sums_(sums), bad_(bad) {}

    bool render_tile(const Tile& tile, Film& film, RayCounts& counts, const std::atomic<bool>* cancel) override;

private:
    void note_bad(int x, int y, std::span<const glm::vec3> radiance);

    const Device& device_;
    PathPass pass_;
    FilmSums& sums_;
    BadSamples& bad_;
    std::vector<glm::vec3> radiance_;
    std::vector<glm::vec3> direct_;
    std::vector<FirstHit> first_hits_;
    std::vector<SpectralSample> spectra_;
    std::vector<Splat> splats_;
};

}  // namespace lancer
