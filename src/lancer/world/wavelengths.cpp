#include "lancer/world/wavelengths.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

#include <glm/geometric.hpp>

#include "lancer/kernel/spectrum.h"
#include "lancer/spectrum/illuminant.h"
#include "lancer/spectrum/upsample.h"

namespace lancer {

namespace {

constexpr auto count = static_cast<std::size_t>(kernel::WAVELENGTH_COUNT);
constexpr auto slots = static_cast<std::size_t>(kernel::WAVELENGTH_SLOTS);

using Curve = std::vector<double>;  // at each nanometre

double nanometre(std::size_t i) { return static_cast<double>(kernel::FIRST_WAVELENGTH) + static_cast<double>(i); }

// The light of a record; textured light has the colour of daylight.
Curve curve_of(const World& world, const kernel::ColorRecord& color) {
    const SmoothSpectrum smooth{glm::dvec3(color.coefficients)};
    Curve curve(count);
    for (std::size_t i = 0; i < count; ++i) {
        if (color.curve >= 0) {
            curve[i] = static_cast<double>(world.curves[static_cast<std::size_t>(color.curve) * count + i] * color.scale);
        } else {
            curve[i] =
                (color.texture >= 0 ? 1.0 : smooth.at(nanometre(i)) * static_cast<double>(color.scale)) * unit_d65().at(nanometre(i));
        }
    }
    return curve;
}

double luminance_of(const World& world, const Curve& light) {
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        sum += light[i] * glm::dot(glm::dvec3(world.observer[i]), glm::dvec3(0.2126729, 0.7151522, 0.0721750));
    }
    return sum;
}

// What all emitters together give, each with the weight of its strength.
Curve light_of(const World& world) {
    Curve sum(count, 0.0);
    const auto add = [&](const kernel::ColorRecord& color, double strength) {
        const Curve curve = curve_of(world, color);
        const double luminance = luminance_of(world, curve);
        for (std::size_t i = 0; luminance > 0.0 && i < count; ++i) {
            sum[i] += curve[i] * strength / luminance;
        }
    };
    // Weighed by all of its light, where the strength is that of what is worth asking for; an image is all under the light of the horizon.
    const auto add_sky = [&](double strength) {
        const bool gradient = world.sky.kind == kernel::SKY_GRADIENT;
        if (!gradient && world.sky.kind != kernel::SKY_EVEN) {
            add(world.sky.horizon, strength > 0.0 ? strength : 1.0);
            return;
        }
        const auto part = [&](const kernel::ColorRecord& color, double share) {
            add(color, std::numbers::pi * share * luminance_of(world, curve_of(world, color)));
        };
        part(world.sky.horizon, gradient ? 0.5 : 1.0);
        if (gradient) {
            part(world.sky.zenith, 0.25);
            part(world.sky.nadir, 0.25);
        }
    };
    std::map<int, double> lamps;  // by material
    for (const kernel::EmitterRecord& emitter : world.emitters) {
        const auto strength = static_cast<double>(emitter.strength);
        if (emitter.material >= 0) {
            lamps[emitter.material] += strength;
        } else if (emitter.kind == kernel::EMITTER_ENVIRONMENT) {
            add_sky(strength);
        } else {
            add(emitter.light, strength);
        }
    }
    for (const auto& [material, strength] : lamps) {
        add(world.surfaces[static_cast<std::size_t>(material)].emission, strength);
    }
    if (!(luminance_of(world, sum) > 0.0)) {
        return unit_d65().on(fine_grid);
    }
    return sum;
}

// As a scene without spectra has it: the colour white.
Curve daylight() {
    const SmoothLight white = smooth_light(glm::dvec3(1.0));
    Curve curve(count);
    for (std::size_t i = 0; i < count; ++i) {
        curve[i] = SmoothSpectrum{glm::dvec3(kernel::vec3(white.shape.coefficients))}.at(nanometre(i)) * unit_d65().at(nanometre(i));
    }
    return curve;
}

// What the eye sees of it, the channels weighed.
Curve seen_of(const Curve& light, const glm::dvec3& weights, const World& world) {
    Curve seen(count);
    for (std::size_t i = 0; i < count; ++i) {
        seen[i] = light[i] * glm::dot(glm::abs(glm::dvec3(world.observer[i])), weights);
    }
    return seen;
}

// A Gaussian of that standard deviation in nanometres.
Curve smoothed(const Curve& curve, double width) {
    const int reach = static_cast<int>(3.0 * width);
    Curve shape(static_cast<std::size_t>(reach) + 1);
    for (int i = 0; i <= reach; ++i) {
        shape[static_cast<std::size_t>(i)] = std::exp(-0.5 * i * i / (width * width));
    }
    Curve result(count, 0.0);
    for (int i = 0; i < static_cast<int>(count); ++i) {
        for (int j = std::max(0, i - reach); j <= std::min(static_cast<int>(count) - 1, i + reach); ++j) {
            result[static_cast<std::size_t>(i)] += curve[static_cast<std::size_t>(j)] * shape[static_cast<std::size_t>(std::abs(i - j))];
        }
    }
    return result;
}

// The share of the random number that falls to each nanometre: at least one slot, and of the others in proportion.
Curve shares_of(const Curve& wanted) {
    const double sum = std::accumulate(wanted.begin(), wanted.end(), 0.0);
    Curve shares(count);
    for (std::size_t i = 0; i < count; ++i) {
        // A little more than a slot, so that rounding does not make it less.
        shares[i] = (wanted[i] / sum * (slots - 1.01 * count) + 1.01) / slots;
    }
    return shares;
}

// Of the mean of four answers, a quarter of the random number apart.
double variance_of(const Curve& shares, const Curve& light, const World& world) {
    constexpr std::size_t steps = 1024;  // within a quarter
    std::array<glm::dvec3, steps> four{};
    std::size_t entry = 0;
    double edge = shares[0];
    for (std::size_t i = 0; i < 4 * steps; ++i) {
        const double u = (static_cast<double>(i) + 0.5) / (4.0 * steps);
        while (u >= edge && entry + 1 < count) {
            edge += shares[++entry];
        }
        four[i % steps] += glm::dvec3(world.observer[entry]) * (light[entry] / shares[entry] * 0.25);
    }
    glm::dvec3 sum(0.0), squares(0.0);
    for (const glm::dvec3& answer : four) {
        sum += answer;
        squares += answer * answer;
    }
    const glm::dvec3 variance = squares / static_cast<double>(steps) - sum * sum / static_cast<double>(steps * steps);
    return variance.x + variance.y + variance.z;
}

void set_density(const Curve& shares, World& world) {
    world.wavelength_edges.assign(1, 0.0f);
    world.wavelength_densities.clear();
    double so_far = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        so_far += shares[i];
        const float edge = i + 1 == count ? 1.0f : static_cast<float>(so_far);
        world.wavelength_densities.push_back(edge - world.wavelength_edges.back());
        world.wavelength_edges.push_back(edge);
    }
    world.wavelength_slots.clear();
    int entry = 0;
    for (std::size_t slot = 0; slot < slots; ++slot) {
        while (world.wavelength_edges[static_cast<std::size_t>(entry) + 1] <= static_cast<float>(slot) / static_cast<float>(slots)) {
            ++entry;
        }
        world.wavelength_slots.push_back(entry);
    }
    world.wavelength_edges.push_back(2.0f);  // read beside the last one
}

}  // namespace

double wavelength_variance(const World& world, const std::vector<double>& light) {
    return variance_of(Curve(world.wavelength_densities.begin(), world.wavelength_densities.end()), light, world);
}

void compile_wavelengths(World& world) {
    if (!world.spectral) {
        return;
    }
    const Curve light = light_of(world), white = daylight();
    const double scale = luminance_of(world, white) / luminance_of(world, light);
    // A smooth density suits smooth light better, a sharp one the lines of fluorescent lamps; one with some of daylight's, light with little blue.
    Curve best;
    double least = 0.0;
    for (const double own : {1.0, 0.75, 0.5, 0.25, 0.0}) {
        Curve between(count);
        for (std::size_t i = 0; i < count; ++i) {
            between[i] = own * scale * light[i] + (1.0 - own) * white[i];
        }
        // Green counts less than its part, for red and blue share most of its wavelengths.
        for (const glm::dvec3& weights :
             {glm::dvec3(1.0, 0.75, 1.0), glm::dvec3(1.0, 0.5, 1.0), glm::dvec3(1.0), glm::dvec3(1.0, 0.75, 1.3)}) {
            const Curve seen = seen_of(between, weights, world);
            for (const double width : {0.0, 8.0, 14.0, 20.0, 30.0}) {
                Curve shares = shares_of(width > 0.0 ? smoothed(seen, width) : seen);
                const double variance = variance_of(shares, light, world);
                if (best.empty() || variance < least) {
                    least = variance;
                    best = std::move(shares);
                }
            }
        }
    }
    set_density(best, world);
}

}  // namespace lancer
