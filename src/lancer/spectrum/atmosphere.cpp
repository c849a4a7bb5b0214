#include "lancer/spectrum/atmosphere.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "lancer/spectrum/atmosphere_layers.h"
#include "lancer/spectrum/sun.h"

namespace lancer {

namespace {

using std::numbers::pi;

constexpr double earth = 6371e3;            // metres, its mean radius
constexpr double top = 80e3;                // where the air ends
constexpr double molecular_height = 8.0e3;  // over which molecules become fewer by e
constexpr double haze_height = 1.2e3;       // and haze
constexpr double ozone_middle = 22e3;       // of a layer that becomes thinner to both sides, up to
constexpr double ozone_reach = 15e3;
constexpr double asymmetry = 0.65;  // of haze: the mean cosine of the angle of scattering [Bird and Riordan 1984]
constexpr int layers = 48;
constexpr int looks = 25;

// Optical depths relative to a vertical way from the ground: of molecules, haze, ozone.
using Columns = std::array<double, 3>;

double height_of(int level) { return top * std::pow(static_cast<double>(level) / layers, 2.0); }

// What stands above a height, straight up, of all; and what lies there per metre.
Columns above(double height) {
    const double end_molecules = std::exp(-top / molecular_height), end_haze = std::exp(-top / haze_height);
    const double x = std::clamp((height - ozone_middle) / ozone_reach, -1.0, 1.0);
    const double ozone = x < 0.0 ? 1.0 - 0.5 * (1.0 + x) * (1.0 + x) : 0.5 * (1.0 - x) * (1.0 - x);
    return {(std::exp(-height / molecular_height) - end_molecules) / (1.0 - end_molecules),
            (std::exp(-height / haze_height) - end_haze) / (1.0 - end_haze), ozone};
}

// The spheres between shells, thin ones where lines are nearly level near the ground, and what stands above them.
struct Shells {
    std::vector<double> radius;
    std::vector<Columns> above_it;

    Shells() {
        for (int i = 0; i <= 4 * layers; ++i) {
            const double low = height_of(i / 4), high = height_of(std::min(i / 4 + 1, layers));
            const double height = low + (high - low) * (i % 4) / 4.0;
            radius.push_back(earth + height);
            above_it.push_back(above(height));
        }
    }
};

// From `height` in the direction whose cosine from the zenith there is `cosine`, to the air's end. False where the ground is in the way.
bool columns_along(double height, double cosine, Columns& columns) {
    static const Shells shells;
    columns = {0.0, 0.0, 0.0};
    const double r = earth + height;
    const double closest_2 = r * r * (1.0 - cosine * cosine);  // to the earth's middle, of the whole line
    const double closest = std::sqrt(std::max(closest_2, 0.0));
    // The part from `low` up to the end.
    const auto add_rising = [&](double low, double times) {
        const auto along = [&](double radius) { return std::sqrt(std::max(radius * radius - closest_2, 0.0)); };
        double from = low, from_along = along(low);
        Columns before = above(low - earth);
        const auto first = std::upper_bound(shells.radius.begin(), shells.radius.end(), low) - shells.radius.begin();
        for (auto i = static_cast<std::size_t>(first); i < shells.radius.size(); ++i) {
            const double to = shells.radius[i], to_along = along(to);
            const double stretch = times * (to_along - from_along) / (to - from);
            const Columns& after = shells.above_it[i];
            for (std::size_t k = 0; k < 3; ++k) {
                columns[k] += (before[k] - after[k]) * stretch;
            }
            before = after;
            from = to;
            from_along = to_along;
        }
    };
    if (cosine >= 0.0) {
        add_rising(r, 1.0);
        return true;
    }
    if (closest < earth) {
        return false;
    }
    // Down to the closest point and up to the end: twice the rise from there, less the part that lies behind.
    add_rising(closest, 2.0);
    add_rising(r, -1.0);
    return true;
}

// Cosines under which many times scattered light is tabulated: close to one another at the horizon.
std::vector<double> look_cosines() {
    std::vector<double> cosines;
    for (int i = 0; i < looks; ++i) {
        cosines.push_back(std::max(std::pow(static_cast<double>(i) / (looks - 1), 2.0), 1e-4));
    }
    return cosines;
}

}  // namespace

double molecular_depth(double nanometres) {
    const double square = nanometres * nanometres * 1e-6;
    return 1.0 / (square * square * (115.6406 - 1.335 / square));
}

double haze_depth(double turbidity, double nanometres) {
    return std::max(0.04608 * turbidity - 0.04586, 0.0) * std::pow(nanometres * 1e-3, -1.3);
}

Atmosphere::Atmosphere(double turbidity, double ozone, double ground, std::vector<double> nanometres)
    : nanometres_(std::move(nanometres)), ground_(ground) {
    for (const double nm : nanometres_) {
        molecules_.push_back(molecular_depth(nm));
        haze_.push_back(haze_depth(turbidity, nm));
        haze_albedo_.push_back(0.945 * std::exp(-0.095 * std::pow(std::log(nm / 400.0), 2.0)));  // [Bird and Riordan 1984, eq. 3-16]
        ozone_.push_back(ozone_absorption().at(nm) * ozone);
    }
}

std::vector<double> Atmosphere::sun_transmittance(double elevation) const {
    Columns columns;
    columns_along(0.0, std::sin(std::max(elevation, 0.0)), columns);
    std::vector<double> left;
    for (std::size_t i = 0; i < nanometres_.size(); ++i) {
        left.push_back(std::exp(-molecules_[i] * columns[0] - haze_[i] * columns[1] - ozone_[i] * columns[2]));
    }
    return left;
}

SkyShares Atmosphere::sky(double sun_elevation, int azimuths, int elevations) const {
    const std::vector<double> cosines = look_cosines();
    const double sun_cosine = std::sin(sun_elevation);
    const ScatteringModes modes(sun_cosine, asymmetry, cosines);
    const std::size_t waves = nanometres_.size();
    const std::size_t levels = layers + 1;

    // Columns from each level to the sun, in flat layers.
    std::vector<Columns> to_sun(levels);
    std::vector<bool> lit(levels);
    for (std::size_t level = 0; level < levels; ++level) {
        lit[level] = columns_along(height_of(static_cast<int>(level)), sun_cosine, to_sun[level]);
    }
    SkyShares shares;
    std::vector<ManyTimesScattered> many;
    for (std::size_t w = 0; w < waves; ++w) {
        AirLayers air;
        air.sun_cosine = sun_cosine;
        air.ground = ground_;
        for (std::size_t level = 0; level < levels; ++level) {
            const Columns& c = to_sun[level];
            air.sunlight.push_back(lit[level] ? std::exp(-molecules_[w] * c[0] - haze_[w] * c[1] - ozone_[w] * c[2]) : 0.0);
            if (level == layers) {
                continue;
            }
            const Columns low = above(height_of(static_cast<int>(level))), high = above(height_of(static_cast<int>(level) + 1));
            const double m = molecules_[w] * (low[0] - high[0]), h = haze_[w] * (low[1] - high[1]), o = ozone_[w] * (low[2] - high[2]);
            const double scattered = m + haze_albedo_[w] * h;
            air.depth.push_back(m + h + o);
            air.scattered.push_back(scattered / std::max(m + h + o, 1e-300));
            air.molecular.push_back(m / std::max(scattered, 1e-300));
        }
        many.push_back(modes.scatter(air));
        shares.sky.push_back(many.back().down);
        shares.ground.push_back(ground_ / pi * (many.back().down + many.back().direct_down));
    }

    // Along each line of sight, shell by shell.
    shares.radiance.assign(static_cast<std::size_t>(azimuths * elevations) * waves, 0.0);
    for (int e = 0; e < elevations; ++e) {
        const double elevation = 0.5 * pi * std::pow(static_cast<double>(e) / (elevations - 1), 2.0);
        const double up = std::sin(elevation), level_part = std::cos(elevation);
        for (int a = 0; a < azimuths; ++a) {
            const double azimuth = pi * a / (azimuths - 1);
            double* radiance = &shares.radiance[static_cast<std::size_t>(a * elevations + e) * waves];
            const double toward_sun = up * sun_cosine + level_part * std::cos(sun_elevation) * std::cos(azimuth);
            const double phase_molecules = molecular_phase(toward_sun), phase_haze = haze_phase(toward_sun, asymmetry);
            Columns passed = {0.0, 0.0, 0.0};
            double way = 0.0;
            std::array<double, ScatteringModes::count> turns;
            for (std::size_t m = 0; m < turns.size(); ++m) {
                turns[m] = std::cos(static_cast<double>(m) * azimuth);
            }
            for (int layer = 0; layer < layers; ++layer) {
                // To where the line leaves the shell.
                const double high = earth + height_of(layer + 1);
                const double end = std::sqrt(std::max(high * high - earth * earth * level_part * level_part, 0.0)) - earth * up;
                const double middle = 0.5 * (way + end);
                const double length = end - way;
                way = end;
                // At the middle: height, the sun's and the line's angle from the zenith there.
                const double r = std::sqrt(earth * earth + middle * middle + 2.0 * earth * middle * up);
                const double sun_here = (earth * sun_cosine + middle * toward_sun) / r;
                const double look_here = (middle + earth * up) / r;
                const double low_height = height_of(layer), high_height = height_of(layer + 1);
                const Columns below = above(low_height), beyond = above(high_height);
                Columns sun_columns;
                const bool sunlit = columns_along(r - earth, sun_here, sun_columns);
                const double stretch = length / (high_height - low_height);
                const Columns here = {(below[0] - beyond[0]) * stretch, (below[1] - beyond[1]) * stretch, (below[2] - beyond[2]) * stretch};
                // Where that lies among the levels and cosines of light that was scattered more often.
                const double level_place = std::clamp(layers * std::sqrt((r - earth) / top) - layer, 0.0, 1.0);
                const double look_place = std::sqrt(std::clamp(look_here, 0.0, 1.0)) * (looks - 1);
                const auto look = std::min(static_cast<std::size_t>(look_place), static_cast<std::size_t>(looks - 2));
                const double look_rest = look_place - static_cast<double>(look);
                for (std::size_t w = 0; w < waves; ++w) {
                    const double before = molecules_[w] * passed[0] + haze_[w] * passed[1] + ozone_[w] * passed[2];
                    const double m = molecules_[w] * here[0], h = haze_[w] * here[1];
                    const double depth = m + h + ozone_[w] * here[2];
                    // What the layer takes of light from behind, and so what of its own source comes out.
                    const double share = depth > 1e-6 ? (1.0 - std::exp(-depth)) / depth : 1.0;
                    double source = 0.0;
                    if (sunlit) {
                        source = (m * phase_molecules + haze_albedo_[w] * h * phase_haze) *
                                 std::exp(-molecules_[w] * sun_columns[0] - haze_[w] * sun_columns[1] - ozone_[w] * sun_columns[2]);
                    }
                    double often = 0.0;
                    for (std::size_t mode = 0; mode < turns.size(); ++mode) {
                        const double* low_row = &many[w].source[(mode * levels + static_cast<std::size_t>(layer)) * looks + look];
                        const double* high_row = low_row + looks;
                        const double low = low_row[0] + (low_row[1] - low_row[0]) * look_rest;
                        const double up_there = high_row[0] + (high_row[1] - high_row[0]) * look_rest;
                        often += turns[mode] * (low + (up_there - low) * level_place);
                    }
                    source += std::max(often, 0.0) * depth;
                    radiance[w] += source * share * std::exp(-before);
                }
                for (std::size_t i = 0; i < 3; ++i) {
                    passed[i] += here[i];
                }
            }
        }
    }
    return shares;
}

}  // namespace lancer
