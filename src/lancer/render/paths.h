// Samples of the path integrator: the whole picture with a few samples a pixel, again and again, so that it is there at once and gets better.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "lancer/film/film_sums.h"
#include "lancer/render/sampler.h"

namespace lancer {

// The samples that one round takes of each pixel of a tile.
struct PathPass {
    int first_sample = 0;
    int sample_count = 0;  // 0: there are enough
};

// What follows after so many samples a pixel on the way to `spp`: few samples first, more later.
PathPass next_pass(int samples, int spp);

// Takes ranges of samples and adds them to the sums; keeps its buffers.
class PathTracer {
public:
    PathTracer(const Device& device, const FilmLayers& layers) : device_(device), layers_(layers) {}

    // Follows the paths of a range. What they bring is kept here.
    void trace(const PathRange& range, RayCounts& counts);
    // Adds what the last range brought to the film. The caller has the tile's lock. `left`, `top`: which pixel of the picture the film begins with.
    void put(FilmState& state, int left = 0, int top = 0);

private:
    const Device& device_;
    FilmLayers layers_;
    PathRange range_;
    std::vector<glm::vec3> radiance_;
    std::vector<glm::vec3> direct_;
    std::vector<FirstHit> first_hits_;
    std::vector<SpectralSample> spectra_;
    std::vector<Splat> splats_;
};

// Every pixel gets as many samples.
class PathSampler : public TileSampler {
public:
    static constexpr int tile_size = 32;

    // `state` has sums.
    PathSampler(const Device& device, const FilmState& state, int spp) : tracer_(device, state.sums()->layers()), spp_(spp) {}

    RoundOutcome render_round(FilmState& state, std::size_t tile, RayCounts& counts, const std::atomic<bool>* cancel) override;
    double samples_left() const override { return samples_left_; }

private:
    PathTracer tracer_;
    int spp_;
    double samples_left_ = 0.0;
};

}  // namespace lancer
