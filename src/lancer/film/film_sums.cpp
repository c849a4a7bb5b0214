#include "lancer/film/film_sums.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>

#include "lancer/film/luminance.h"
#include "lancer/kernel/spectrum.h"

namespace lancer {
namespace {

const double bins_from = static_cast<double>(kernel::FIRST_WAVELENGTH);
const double bins_to = static_cast<double>(kernel::LAST_WAVELENGTH);

glm::dvec3 wide(const glm::vec3& v) { return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)}; }

bool is_number(const glm::vec3& v) { return !(std::isnan(v.x) || std::isnan(v.y) || std::isnan(v.z)); }

void count_id(int id, IdCounts& counts) {
    for (auto& [known, count] : counts) {
        if (known == id) {
            ++count;
            return;
        }
    }
    counts.emplace_back(id, 1u);
}

void add_hit(const FirstHit& hit, SurfaceSums& sums) {
    if (hit.object < 0) {
        return;
    }
    const double weight = static_cast<double>(hit.weight);
    sums.albedo += wide(hit.albedo) * weight;
    sums.normal += wide(hit.normal) * weight;
    sums.position += wide(hit.position);
    sums.depth += static_cast<double>(hit.depth);
    sums.uv += glm::dvec2(static_cast<double>(hit.uv.x), static_cast<double>(hit.uv.y));
    ++sums.hits;
}

}  // namespace

FilmSums::FilmSums(int width, int height, const FilmLayers& layers) : width_(width), height_(height), layers_(layers) {
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    counts_.resize(pixels);
    sums_.assign(pixels, glm::dvec3(0.0));
    squares_.assign(layers.variance ? pixels : 0, glm::dvec3(0.0));
    direct_.assign(layers.direct ? pixels : 0, glm::dvec3(0.0));
    surfaces_.resize(layers.surface ? pixels : 0);
    objects_.resize(layers.ids ? pixels : 0);
    materials_.resize(layers.ids ? pixels : 0);
    if (layers.splats) {
        splats_ = std::make_unique<SplatSums>(width, height);
    }
    bins_.resize(pixels * static_cast<std::size_t>(layers.spectral_bins));
    runs_.resize(layers.runs ? pixels * most_runs : 0);
    spreads_.resize(layers.runs ? pixels : 0);
    removed_.resize(layers.clamp > 0.0 ? pixels : 0);
}

void FilmSums::add(std::size_t pixel, const PathSamples& samples) {
    assert(samples.direct.empty() == !layers_.direct && samples.first_hits.empty() == !layers_.first_hits());
    // Sample by sample onto what there is, so that it makes no difference how the samples were cut into ranges.
    glm::dvec3 sum = sums_[pixel];
    for (std::size_t i = 0; i < samples.radiance.size(); ++i) {
        if (layers_.runs) {
            begin_sample(pixel);
        }
        if (!is_number(samples.radiance[i])) {
            continue;
        }
        ++counts_[pixel];
        const double kept = layers_.clamp > 0.0 ? clamp(pixel, wide(samples.radiance[i])) : 1.0;
        const glm::dvec3 value = wide(samples.radiance[i]) * kept;
        sum += value;
        if (layers_.runs) {
            add_to_run(pixel, luminance(value));
        }
        if (layers_.variance) {
            squares_[pixel] += value * value;
        }
        if (layers_.direct) {
            direct_[pixel] += wide(samples.direct[i]) * kept;
        }
        if (layers_.surface) {
            add_hit(samples.first_hits[i], surfaces_[pixel]);
        }
        if (layers_.ids && samples.first_hits[i].object >= 0) {
            count_id(samples.first_hits[i].object, objects_[pixel]);
            count_id(samples.first_hits[i].material, materials_[pixel]);
        }
        if (layers_.spectral_bins > 0) {
            add_bins(pixel, samples.spectra[i], kept);
        }
    }
    sums_[pixel] = sum;
}

namespace {

void put_ids(const IdCounts& counts, ByteWriter& bytes) {
    bytes.put(static_cast<std::uint32_t>(counts.size()));
    for (const auto& [id, count] : counts) {
        bytes.put(id);
        bytes.put(count);
    }
}

void get_ids(IdCounts& counts, ByteReader& bytes) {
    std::uint32_t size = 0;
    bytes.get(size);
    counts.clear();
    for (std::uint32_t i = 0; i < size && bytes.good(); ++i) {
        auto& [id, count] = counts.emplace_back(0, 0u);
        bytes.get(id);
        bytes.get(count);
    }
}

}  // namespace

// Every plane that there is, and how many values of it belong to a pixel.
template <class Sums, class Visit>
void FilmSums::visit_planes(Sums& sums, const Visit& visit) {
    visit(sums.counts_, 1);
    visit(sums.sums_, 1);
    visit(sums.squares_, 1);
    visit(sums.direct_, 1);
    visit(sums.surfaces_, 1);
    visit(sums.bins_, sums.layers_.spectral_bins);
    visit(sums.runs_, most_runs);
    visit(sums.spreads_, 1);
    visit(sums.removed_, 1);
}

void FilmSums::save(std::size_t first, std::size_t count, ByteWriter& bytes) const {
    visit_planes(*this, [&](const auto& plane, int of_pixel) {
        if (!plane.empty()) {
            const std::size_t each = static_cast<std::size_t>(of_pixel);
            bytes.put_all(std::span(plane).subspan(first * each, count * each));
        }
    });
    for (std::size_t i = first; i < first + count && layers_.ids; ++i) {
        put_ids(objects_[i], bytes);
        put_ids(materials_[i], bytes);
    }
}

void FilmSums::load(std::size_t first, std::size_t count, ByteReader& bytes) {
    visit_planes(*this, [&](auto& plane, int of_pixel) {
        if (!plane.empty()) {
            const std::size_t each = static_cast<std::size_t>(of_pixel);
            bytes.get_all(std::span(plane).subspan(first * each, count * each));
        }
    });
    for (std::size_t i = first; i < first + count && layers_.ids; ++i) {
        get_ids(objects_[i], bytes);
        get_ids(materials_[i], bytes);
    }
}

int run_length(std::uint32_t samples) {
    return static_cast<int>(std::max(std::bit_floor(samples) / std::uint32_t{least_runs}, std::uint32_t{1}));
}

// Counts a sample. When there are so many of them that runs become twice as long, two and two are joined first.
void FilmSums::begin_sample(std::size_t pixel) {
    std::uint32_t& samples = spreads_[pixel].samples;
    float* const runs = &runs_[pixel * most_runs];
    if (samples == static_cast<std::uint32_t>(most_runs * run_length(samples - std::min(samples, 1u)))) {
        for (int i = 0; i < least_runs; ++i) {
            runs[i] = runs[2 * i] + runs[2 * i + 1];
        }
        std::fill(runs + least_runs, runs + most_runs, 0.0f);
    }
    ++samples;
}

// What the sample that was counted last has brought.
void FilmSums::add_to_run(std::size_t pixel, double luminance) {
    Spread& spread = spreads_[pixel];
    // The run's length is that which it will have when the samples of this power of two are complete.
    const std::uint32_t sample = spread.samples - 1;
    runs_[pixel * most_runs + sample / static_cast<std::uint32_t>(run_length(sample))] += static_cast<float>(luminance);
    spread.squares += luminance * luminance;
    spread.largest = std::max(spread.largest, static_cast<float>(std::fabs(luminance)));
}

RunSums FilmSums::runs(std::size_t pixel) const {
    RunSums result;
    std::copy_n(runs_.begin() + static_cast<std::ptrdiff_t>(pixel * most_runs), most_runs, result.sums.begin());
    const Spread& spread = spreads_[pixel];
    result.length = run_length(spread.samples - std::min(spread.samples, 1u));
    result.complete = static_cast<int>(spread.samples) / result.length;
    result.largest = spread.largest;
    result.squares = spread.squares;
    result.total = luminance(sums_[pixel]);
    result.count = counts_[pixel];
    return result;
}

// The share of the sample that is kept.
double FilmSums::clamp(std::size_t pixel, const glm::dvec3& value) {
    const double bright = std::fabs(luminance(value));
    if (bright <= layers_.clamp) {
        return 1.0;
    }
    removed_[pixel] += bright - layers_.clamp;
    return layers_.clamp / bright;
}

double FilmSums::clamped(std::size_t pixel) const {
    return counts_[pixel] > 0 && layers_.clamp > 0.0 ? removed_[pixel] / static_cast<double>(counts_[pixel]) : 0.0;
}

void FilmSums::add_bins(std::size_t pixel, const SpectralSample& sample, double share_kept) {
    const double share = static_cast<double>(layers_.spectral_bins) / (bins_to - bins_from);
    for (int i = 0; i < 4; ++i) {
        const double place = (static_cast<double>(sample.nanometres[i]) - bins_from) * share;
        const int bin = std::clamp(static_cast<int>(place), 0, layers_.spectral_bins - 1);
        bins_[pixel * static_cast<std::size_t>(layers_.spectral_bins) + static_cast<std::size_t>(bin)] +=
            static_cast<double>(sample.power[i]) * share * share_kept;
    }
}

glm::vec3 FilmSums::mean(std::size_t pixel) const {
    const glm::dvec3 own = counts_[pixel] > 0 ? sums_[pixel] / static_cast<double>(counts_[pixel]) : glm::dvec3(0.0);
    return glm::vec3(splats_ ? own + splats_->mean(pixel) : own);
}

glm::vec3 FilmSums::variance(std::size_t pixel) const {
    const double n = static_cast<double>(counts_[pixel]);
    if (counts_[pixel] < 2) {
        return glm::vec3(std::numeric_limits<float>::infinity());
    }
    const glm::dvec3 spread = squares_[pixel] - sums_[pixel] * sums_[pixel] / n;
    // What rounding leaves of equal samples may be below zero.
    return glm::vec3(glm::dvec3(std::max(spread.x, 0.0), std::max(spread.y, 0.0), std::max(spread.z, 0.0)) / (n * (n - 1.0)));
}

glm::vec3 FilmSums::direct(std::size_t pixel) const {
    return counts_[pixel] > 0 ? glm::vec3(direct_[pixel] / static_cast<double>(counts_[pixel])) : glm::vec3(0.0f);
}

float FilmSums::spectral(std::size_t pixel, int bin) const {
    const double sum = bins_[pixel * static_cast<std::size_t>(layers_.spectral_bins) + static_cast<std::size_t>(bin)];
    return counts_[pixel] > 0 ? static_cast<float>(sum / static_cast<double>(counts_[pixel])) : 0.0f;
}

}  // namespace lancer
