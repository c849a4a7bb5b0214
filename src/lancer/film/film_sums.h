// What a picture of the path integrator rests on: sums over the samples of each pixel, and how many there were.
//
// A pixel's sums grow sample by sample in the order in which these are added: whoever adds them in the same order has the same bits, however
// the samples were cut into ranges.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lancer/film/bytes.h"
#include "lancer/film/path_samples.h"

namespace lancer {

// A pixel's samples are cut into runs whose spread tells the error (film/interval.h): all of one length, a power of two, so that there are from 16 on and
// before 32 of them, once there are 16 samples.
constexpr int least_runs = 16;
constexpr int most_runs = 2 * least_runs;
int run_length(std::uint32_t samples);

// Which sums are kept beside those of the picture itself.
struct FilmLayers {
    bool variance = false;
    bool direct = false;
    bool surface = false;  // what is seen first: albedo, normal, depth, position, uv
    bool ids = false;      // of objects and materials
    int spectral_bins = 0;
    bool runs = false;    // where the error is to be known
    double clamp = 0.0;   // samples brighter than this luminance are made as dark; 0: none
    bool splats = false;  // light that falls anywhere

    bool first_hits() const { return surface || ids; }
    bool operator==(const FilmLayers&) const = default;
};

struct SurfaceSums {
    glm::dvec3 albedo{0.0};  // by the filter's weights
    glm::dvec3 normal{0.0};
    glm::dvec3 position{0.0};  // of samples that met something, each counted once
    double depth = 0.0;
    glm::dvec2 uv{0.0};
    std::uint32_t hits = 0;
};

// A pixel's luminance, by runs.
struct RunSums {
    std::array<float, most_runs> sums{};
    int complete = 0;  // runs
    int length = 1;
    float largest = 0.0f;  // of the samples, in size
    double squares = 0.0;  // of all samples
    double total = 0.0;    // of the picture's own sums
    std::uint32_t count = 0;

    double mean() const { return count > 0 ? total / static_cast<double>(count) : 0.0; }
};

// Ids and how many samples saw each, in the order in which they came.
using IdCounts = std::vector<std::pair<int, std::uint32_t>>;

class FilmSums {
public:
    FilmSums(int width, int height, const FilmLayers& layers);

    int width() const { return width_; }
    int height() const { return height_; }
    const FilmLayers& layers() const { return layers_; }

    // Adds the samples (of one pixel) but those that are NaN. Different pixels may be added to by several threads.
    void add(std::size_t pixel, const PathSamples& samples);

    std::uint32_t count(std::size_t pixel) const { return counts_[pixel]; }  // of the samples in the sums
    // Splats included; these may come from anywhere, so that a pixel is finished when all are. 0 where there is none.
    glm::vec3 mean(std::size_t pixel) const;
    SplatSums* splats() const { return splats_.get(); }  // null where the layers have none

    // Of the mean, by colour: the spread of the samples over their count. Unbiased for independent samples; evenly spread ones, as Owen-scrambled
    // Sobol points are, do better than it says [Owen 1997]. Infinite where there are fewer than two samples.
    glm::vec3 variance(std::size_t pixel) const;

    glm::vec3 direct(std::size_t pixel) const;  // its mean
    const SurfaceSums& surface(std::size_t pixel) const { return surfaces_[pixel]; }
    const IdCounts& objects(std::size_t pixel) const { return objects_[pixel]; }
    const IdCounts& materials(std::size_t pixel) const { return materials_[pixel]; }

    RunSums runs(std::size_t pixel) const;    // where the layers have them
    double clamped(std::size_t pixel) const;  // luminance that clamping took from the pixel's mean

    // Mean spectral radiance over the bin, per nanometre. Bins split the visible, 360 to 830 nm, evenly.
    float spectral(std::size_t pixel, int bin) const;

    // The sums of so many pixels in a row, bit for bit.
    void save(std::size_t first, std::size_t count, ByteWriter& bytes) const;
    void load(std::size_t first, std::size_t count, ByteReader& bytes);

private:
    template <class Sums, class Visit>
    static void visit_planes(Sums& sums, const Visit& visit);
    void add_bins(std::size_t pixel, const SpectralSample& sample, double share_kept);
    void begin_sample(std::size_t pixel);
    void add_to_run(std::size_t pixel, double luminance);
    double clamp(std::size_t pixel, const glm::dvec3& value);

    int width_;
    int height_;
    FilmLayers layers_;
    std::vector<std::uint32_t> counts_;
    std::vector<glm::dvec3> sums_;
    std::vector<glm::dvec3> squares_;
    std::vector<glm::dvec3> direct_;
    std::vector<SurfaceSums> surfaces_;
    std::vector<IdCounts> objects_;
    std::vector<IdCounts> materials_;
    std::unique_ptr<SplatSums> splats_;
    std::vector<double> bins_;  // spectral_bins for each pixel
    struct Spread {
        double squares = 0.0;
        float largest = 0.0f;
        std::uint32_t samples = 0;
    };
    std::vector<float> runs_;  // most_runs for each pixel
    std::vector<Spread> spreads_;
    std::vector<double> removed_;  // luminance, by clamping
};

}  // namespace lancer
