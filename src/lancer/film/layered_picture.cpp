#include "lancer/film/layered_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string_view>

#include "lancer/film/interval.h"
#include "lancer/image/cryptomatte.h"

namespace lancer {
namespace {

class Picture {
public:
    Picture(const Film& film, const FilmSums& sums, const PictureContents& contents, const PictureNames& names, const Metadata& metadata)
        : film_(film), sums_(sums), contents_(contents), names_(names), image_{film.width, film.height, {}, metadata, false} {}

    LayeredImage take() {
        add3("", "RGB", narrow(), [&](std::size_t i) { return film_.radiance[i]; });
        for (const Aov aov : contents_.aovs) {
            add(aov);
        }
        if (contents_.spectral_bins > 0) {
            add_spectrum();
        }
        return std::move(image_);
    }

private:
    Stored narrow() const { return contents_.wide ? Stored::float32 : Stored::half; }
    std::size_t pixels() const { return film_.radiance.size(); }

    std::vector<float>& add_plane(std::string name, Stored stored) {
        image_.channels.push_back({std::move(name), stored, std::vector<float>(pixels()), {}});
        return image_.channels.back().values;
    }

    template <class Value>
    void add1(std::string name, Stored stored, const Value& value) {
        std::vector<float>& plane = add_plane(std::move(name), stored);
        for (std::size_t i = 0; i < plane.size(); ++i) {
            plane[i] = value(i);
        }
    }

    // One channel for each letter of `parts`, of a layer or of the picture itself.
    template <class Value>
    void add3(const std::string& layer, std::string_view parts, Stored stored, const Value& value) {
        for (std::size_t c = 0; c < parts.size(); ++c) {
            add1(layer.empty() ? std::string(1, parts[c]) : layer + "." + parts[c], stored,
                 [&](std::size_t i) { return value(i)[static_cast<int>(c)]; });
        }
    }

    // Means over all samples, and over those that met something.
    glm::vec3 over_all(const glm::dvec3& sum, std::size_t i) const {
        return sums_.count(i) > 0 ? glm::vec3(sum / static_cast<double>(sums_.count(i))) : glm::vec3(0.0f);
    }
    template <class Sum>
    Sum over_hits(const Sum& sum, std::size_t i) const {
        const std::uint32_t hits = sums_.surface(i).hits;
        return hits > 0 ? sum / static_cast<double>(hits) : Sum(0.0);
    }

    void add(Aov aov) {
        switch (aov) {
            case Aov::albedo:
                return add3("albedo", "RGB", narrow(), [&](std::size_t i) { return over_all(sums_.surface(i).albedo, i); });
            case Aov::normal:
                return add3("normal", "XYZ", narrow(), [&](std::size_t i) { return over_all(sums_.surface(i).normal, i); });
            case Aov::depth:
                return add1("depth.Z", Stored::float32, [&](std::size_t i) {
                    return sums_.surface(i).hits > 0 ? static_cast<float>(over_hits(sums_.surface(i).depth, i))
                                                     : std::numeric_limits<float>::infinity();
                });
            case Aov::position:
                return add3("position", "XYZ", Stored::float32,
                            [&](std::size_t i) { return glm::vec3(over_hits(sums_.surface(i).position, i)); });
            case Aov::uv:
                return add3("uv", "UV", Stored::float32, [&](std::size_t i) { return glm::vec2(over_hits(sums_.surface(i).uv, i)); });
            case Aov::object_id:
                return add_ids("CryptoObject", names_.objects, [&](std::size_t i) -> const IdCounts& { return sums_.objects(i); });
            case Aov::material_id:
                return add_ids("CryptoMaterial", names_.materials, [&](std::size_t i) -> const IdCounts& { return sums_.materials(i); });
            case Aov::direct:
                return add3("direct", "RGB", narrow(), [&](std::size_t i) { return sums_.direct(i); });
            case Aov::indirect:
                return add3("indirect", "RGB", narrow(), [&](std::size_t i) { return sums_.mean(i) - sums_.direct(i); });
            case Aov::samples:
                return add1("samples", Stored::float32, [&](std::size_t i) { return static_cast<float>(sums_.count(i)); });
            case Aov::variance:
                return add3("variance", "RGB", Stored::float32, [&](std::size_t i) { return sums_.variance(i); });
            case Aov::interval:
                return add_intervals();
        }
    }

    void add_intervals() {
        const IntervalRule rule(contents_.confidence, contents_.floor);
        std::vector<Interval> intervals(film_.samples.size());
        for (const Tile& block : cut_tiles(film_.width, film_.height, interval_block)) {
            const std::vector<Interval> found = rule.of(sums_, block);
            for (int y = block.y0; y < block.y1; ++y) {
                std::copy_n(found.begin() + static_cast<std::ptrdiff_t>(y - block.y0) * block.width(), block.width(),
                            intervals.begin() + static_cast<std::ptrdiff_t>(film_.index(block.x0, y)));
            }
        }
        add1("interval.low", Stored::float32,
             [&](std::size_t i) { return static_cast<float>(intervals[i].middle - intervals[i].half_width); });
        add1("interval.high", Stored::float32,
             [&](std::size_t i) { return static_cast<float>(intervals[i].middle + intervals[i].half_width); });
        add1("interval.tail", Stored::float32, [&](std::size_t i) { return intervals[i].heavy() ? 1.0f : 0.0f; });
    }

    template <class Counts>
    void add_ids(const std::string& layer, const std::vector<std::string>& names, const Counts& counts) {
        constexpr int levels = 6;
        std::vector<float> ids;
        for (const std::string& name : names) {
            ids.push_back(cryptomatte_id(name));
        }
        std::vector<Coverage> pixels_covered(pixels());
        for (std::size_t i = 0; i < pixels_covered.size(); ++i) {
            std::map<float, std::uint32_t> together;  // objects of one name
            for (const auto& [number, count] : counts(i)) {
                together[ids.at(static_cast<std::size_t>(number))] += count;
            }
            for (const auto& [id, count] : together) {
                pixels_covered[i].emplace_back(id, static_cast<float>(count) / static_cast<float>(sums_.count(i)));
            }
        }
        for (Channel& channel : cryptomatte_channels(layer, levels, pixels_covered)) {
            image_.channels.push_back(std::move(channel));
        }
        const std::set<std::string> all(names.begin(), names.end());
        image_.metadata.merge(cryptomatte_metadata(layer, {all.begin(), all.end()}));
    }

    // As [Fichet, Pacanowski and Wilkie 2021] have it: a channel for each wavelength, here the middle of a bin.
    void add_spectrum() {
        for (int bin = 0; bin < contents_.spectral_bins; ++bin) {
            add1(spectral_channel(bin, contents_.spectral_bins), Stored::float32, [&](std::size_t i) { return sums_.spectral(i, bin); });
        }
        image_.metadata["spectralLayoutVersion"] = "1.0";
        image_.metadata["emissiveUnits"] = "W.m^-2.sr^-1";
    }

    const Film& film_;
    const FilmSums& sums_;
    const PictureContents& contents_;
    const PictureNames& names_;
    LayeredImage image_;
};

}  // namespace

FilmLayers layers_for(const PictureContents& contents) {
    const auto has = [&](std::initializer_list<Aov> any) {
        return std::any_of(contents.aovs.begin(), contents.aovs.end(),
                           [&](Aov aov) { return std::find(any.begin(), any.end(), aov) != any.end(); });
    };
    FilmLayers layers;
    layers.variance = has({Aov::variance});
    layers.direct = has({Aov::direct, Aov::indirect});
    layers.surface = has({Aov::albedo, Aov::normal, Aov::depth, Aov::position, Aov::uv});
    layers.ids = has({Aov::object_id, Aov::material_id});
    layers.spectral_bins = contents.spectral_bins;
    layers.runs = contents.runs || has({Aov::interval});
    layers.clamp = contents.clamp;
    return layers;
}

LayeredImage layered_picture(const Film& film, const FilmSums& sums, const PictureContents& contents, const PictureNames& names,
                             const Metadata& metadata) {
    return Picture(film, sums, contents, names, metadata).take();
}

}  // namespace lancer
