#include "lancer/world/wavelengths.h"

#include <algorithm>
#include <cmath>
#include <map>

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
    std::map<int, double> lamps;  // by material
    for (const kernel::EmitterRecord& emitter : world.emitters) {
        const auto strength = static_cast<double>(emitter.strength);
        if (emitter.material >= 0) {
            lamps[emitter.material] += strength;
        } else if (emitter.kind == kernel::EMITTER_ENVIRONMENT) {
            const bool gradient = world.sky.kind == kernel::SKY_GRADIENT;  // else all is under the light of the horizon
            add(world.sky.horizon, strength * (gradient ? 0.5 : 1.0));
            if (gradient) {
                add(world.sky.zenith, strength * 0.25);
                add(world.sky.nadir, strength * 0.25);
            }
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

// What the eye sees of it; green counts less than its part, for red and blue share most of its wavelengths.
Curve seen_of(const Curve& light, const World& world) {
    Curve seen(count);
    for (std::size_t i = 0; i < count; ++i) {
        seen[i] = light[i] * glm::dot(glm::abs(glm::dvec3(world.observer[i])), glm::dvec3(1.0, 0.75, 1.0));
    }
    return seen;
}

// A Gaussian of that standard deviation in nanometres.
Curve smoothed(const Curve& curve, double width) {
    Curve result(count, 0.0);
    const int reach = static_cast<int>(3.0 * width);
    for (int i = 0; i < static_cast<int>(count); ++i) {
        for (int j = std::max(0, i - reach); j <= std::min(static_cast<int>(count) - 1, i + reach); ++j) {
            result[static_cast<std::size_t>(i)] +=
                curve[static_cast<std::size_t>(j)] * std::exp(-0.5 * (i - j) * (i - j) / (width * width));
        }
    }
    return result;
}

// Each nanometre gets one slot, and of the others a share in proportion.
void set_density(const Curve& wanted, World& world) {
    double sum = 0.0;
    for (const double w : wanted) {
        sum += w;
    }
    world.wavelength_places.clear();
    world.wavelength_densities.clear();
    double so_far = 0.0;
    double edge = 0.0;  // of the slots to be shared out
    for (std::size_t i = 0; i < count; ++i) {
        so_far += wanted[i];
        const double next =
            i + 1 == count ? static_cast<double>(slots - count) : std::round(so_far / sum * static_cast<double>(slots - count));
        const auto mine = static_cast<std::size_t>(next - edge) + 1;
        edge = next;
        world.wavelength_densities.push_back(static_cast<float>(static_cast<double>(mine) / static_cast<double>(slots)));
        for (std::size_t j = 0; j < mine; ++j) {
            world.wavelength_places.push_back(static_cast<float>(nanometre(i) - 0.5 + static_cast<double>(j) / static_cast<double>(mine)));
        }
    }
    world.wavelength_places.push_back(kernel::LAST_WAVELENGTH + 0.5f);
}

}  // namespace

double wavelength_variance(const World& world, const std::vector<double>& light) {
    std::vector<glm::dvec3> answer;  // of one wavelength in each slot
    for (std::size_t i = 0; i < count; ++i) {
        const double density = static_cast<double>(world.wavelength_densities[i]);
        const auto mine = static_cast<std::size_t>(std::lround(density * static_cast<double>(slots)));
        answer.insert(answer.end(), mine, glm::dvec3(world.observer[i]) * (light[i] / density));
    }
    glm::dvec3 sum(0.0), squares(0.0);
    const std::size_t quarter = slots / 4;
    for (std::size_t i = 0; i < quarter; ++i) {
        const glm::dvec3 four = (answer[i] + answer[i + quarter] + answer[i + 2 * quarter] + answer[i + 3 * quarter]) * 0.25;
        sum += four;
        squares += four * four;
    }
    const glm::dvec3 mean = sum / static_cast<double>(quarter);
    const glm::dvec3 variance = squares / static_cast<double>(quarter) - mean * mean;
    return variance.x + variance.y + variance.z;
}

void compile_wavelengths(World& world) {
    if (!world.spectral) {
        return;
    }
    const Curve light = light_of(world);
    // A smooth density suits smooth light better, a sharp one the lines of fluorescent lamps; that of daylight, light with little blue.
    Curve best;
    double least = 0.0;
    for (const Curve& seen : {seen_of(light, world), seen_of(daylight(), world)}) {
        for (const double width : {0.0, 8.0, 20.0}) {
            const Curve wanted = width > 0.0 ? smoothed(seen, width) : seen;
            set_density(wanted, world);
            const double variance = wavelength_variance(world, light);
            if (best.empty() || variance < least) {
                least = variance;
                best = wanted;
            }
        }
    }
    set_density(best, world);
}

}  // namespace lancer
