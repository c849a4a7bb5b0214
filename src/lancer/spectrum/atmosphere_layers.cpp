#include "lancer/spectrum/atmosphere_layers.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lancer {

namespace {

using std::numbers::pi;

constexpr int azimuth_steps = 64;     // for the modes' integrals
constexpr int most_orders = 200;      // of scattering
constexpr double least_order = 1e-5;  // the last order's share of all light on the ground and at the top

// Nodes and weights of Gauss's rule over 0 to 1, by Newton's method on Legendre's polynomials.
void gauss_rule(int count, std::vector<double>& nodes, std::vector<double>& weights) {
    for (int i = 0; i < count; ++i) {
        double x = std::cos(pi * (i + 0.75) / (count + 0.5));
        double slope = 1.0;
        for (int step = 0; step < 100; ++step) {
            double p = 1.0, before = 0.0;
            for (int k = 1; k <= count; ++k) {
                const double next = ((2.0 * k - 1.0) * x * p - (k - 1.0) * before) / k;
                before = p;
                p = next;
            }
            slope = count * (x * p - before) / (x * x - 1.0);
            const double change = p / slope;
            x -= change;
            if (std::abs(change) < 1e-15) {
                break;
            }
        }
        nodes.push_back(0.5 * (1.0 - x));
        weights.push_back(1.0 / ((1.0 - x * x) * slope * slope));
    }
}

// The mode's coefficient: of cos(m azimuth) in the series of the phase function between two angles from the zenith.
template <class Phase>
double mode_of(int mode, double cosine, double other, const Phase& phase) {
    const double sines = std::sqrt(std::max((1.0 - cosine * cosine) * (1.0 - other * other), 0.0));
    double sum = 0.0;
    for (int i = 0; i < azimuth_steps; ++i) {
        const double azimuth = pi * (i + 0.5) / azimuth_steps;
        sum += phase(cosine * other + sines * std::cos(azimuth)) * std::cos(mode * azimuth);
    }
    return sum / azimuth_steps * (mode == 0 ? 1.0 : 2.0);
}

}  // namespace

double molecular_phase(double cosine) { return 3.0 / (16.0 * pi) * (1.0 + cosine * cosine); }

double haze_phase(double cosine, double asymmetry) {
    const double g2 = asymmetry * asymmetry;
    const double distance_2 = 1.0 + g2 - 2.0 * asymmetry * cosine;
    return (1.0 - g2) / (4.0 * pi * distance_2 * std::sqrt(distance_2));
}

ScatteringModes::ScatteringModes(double sun_cosine, double asymmetry, const std::vector<double>& looks) : looks_(looks.size()) {
    gauss_rule(streams, cosines_, weights_);
    // The ways that light travels, upwards above 0.
    std::vector<double> into = cosines_;
    for (const double cosine : cosines_) {
        into.push_back(-cosine);
    }
    const std::vector<double> from = into;
    for (const double cosine : looks) {
        into.push_back(-cosine);
    }
    const auto molecules = [](double cosine) { return molecular_phase(cosine); };
    const auto haze = [&](double cosine) { return haze_phase(cosine, asymmetry); };
    for (int mode = 0; mode < count; ++mode) {
        Matrix m, h;
        for (const double way : into) {
            for (const double other : from) {
                m.from_streams.push_back(mode <= 2 ? mode_of(mode, way, other, molecules) : 0.0);
                h.from_streams.push_back(mode_of(mode, way, other, haze));
            }
            m.from_sun.push_back(mode <= 2 ? mode_of(mode, way, -sun_cosine, molecules) : 0.0);
            h.from_sun.push_back(mode_of(mode, way, -sun_cosine, haze));
        }
        molecules_.push_back(std::move(m));
        haze_.push_back(std::move(h));
    }
}

ManyTimesScattered ScatteringModes::scatter(const AirLayers& layers) const {
    const std::size_t n = layers.depth.size(), levels = n + 1;
    const std::size_t up = cosines_.size(), both = 2 * up, all = both + looks_;
    ManyTimesScattered result;
    result.source.assign(static_cast<std::size_t>(count) * levels * looks_, 0.0);
    result.direct_down = std::max(layers.sun_cosine, 0.0) * layers.sunlight[0];
    // A level's air: the mean of the layers that it lies between.
    const auto at_level = [&](const std::vector<double>& of_layers, std::size_t level) {
        return level == 0 ? of_layers.front() : level == n ? of_layers.back() : 0.5 * (of_layers[level - 1] + of_layers[level]);
    };
    for (std::size_t mode = 0; mode < static_cast<std::size_t>(count); ++mode) {
        std::vector<double> source(levels * all), light(levels * both), next(levels * both);
        for (std::size_t level = 0; level < levels; ++level) {
            const double scattered = at_level(layers.scattered, level), molecular = at_level(layers.molecular, level);
            for (std::size_t i = 0; i < all; ++i) {
                source[level * all + i] = scattered * layers.sunlight[level] *
                                          (molecular * molecules_[mode].from_sun[i] + (1.0 - molecular) * haze_[mode].from_sun[i]);
            }
        }
        double total = 0.0;
        for (int order = 0; order < most_orders; ++order) {
            // Along each stream through the layers, the source linear in optical depth between levels.
            for (std::size_t s = 0; s < both; ++s) {
                const bool rises = s < up;
                const double cosine = cosines_[s % up];
                double here = 0.0;
                if (rises && mode == 0) {  // from the ground, what came down to it
                    double down = order == 0 ? result.direct_down : 0.0;
                    if (order > 0) {
                        for (std::size_t j = 0; j < up; ++j) {
                            down += 2.0 * pi * weights_[j] * cosines_[j] * light[up + j];
                        }
                    }
                    here = layers.ground * down / pi;
                }
                for (std::size_t step = 0; step <= n; ++step) {
                    const std::size_t level = rises ? step : n - step;
                    if (step > 0) {
                        const std::size_t before = rises ? level - 1 : level + 1;
                        const double depth = layers.depth[rises ? level - 1 : level] / cosine;
                        const double left = std::exp(-depth);
                        const double share = depth > 1e-4 ? (1.0 - left) / depth : 1.0 - 0.5 * depth;
                        // Integral of exp(-(depth - t)) over t, the source going from `a` at 0 to `b` at the end.
                        const double a = source[before * all + s], b = source[level * all + s];
                        here = here * left + a * (share - left) + b * (1.0 - share);
                    }
                    next[level * both + s] = here;
                }
            }
            // The light of the first order down to the ground, too, is counted; its source is not given out.
            std::swap(light, next);
            double change = 0.0;
            for (std::size_t j = 0; j < up; ++j) {
                const double down = light[up + j], out = light[n * both + j];
                if (mode == 0) {
                    result.down += 2.0 * pi * weights_[j] * cosines_[j] * down;
                    result.up += 2.0 * pi * weights_[j] * cosines_[j] * out;
                }
                change += weights_[j] * (std::abs(down) + std::abs(out));
            }
            total += change;
            for (std::size_t level = 0; level < levels; ++level) {
                const double scattered = at_level(layers.scattered, level), molecular = at_level(layers.molecular, level);
                const double turns = mode == 0 ? 2.0 * pi : pi;  // of cos(m azimuth) with itself
                for (std::size_t i = 0; i < all; ++i) {
                    double sum = 0.0;
                    const double* of_molecules = &molecules_[mode].from_streams[i * both];
                    const double* of_haze = &haze_[mode].from_streams[i * both];
                    for (std::size_t j = 0; j < both; ++j) {
                        const double phase = molecular * of_molecules[j] + (1.0 - molecular) * of_haze[j];
                        sum += weights_[j % up] * phase * light[level * both + j];
                    }
                    source[level * all + i] = turns * scattered * sum;
                }
                for (std::size_t i = 0; i < looks_; ++i) {
                    result.source[(mode * levels + level) * looks_ + i] += source[level * all + both + i];
                }
            }
            if (!(change > least_order * total)) {
                break;
            }
        }
    }
    return result;
}

}  // namespace lancer
