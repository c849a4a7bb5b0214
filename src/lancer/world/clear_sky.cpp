#include "lancer/world/clear_sky.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <glm/matrix.hpp>

#include "lancer/scene/sun_position.h"
#include "lancer/spectrum/atmosphere.h"
#include "lancer/spectrum/sensor.h"
#include "lancer/spectrum/sun.h"
#include "lancer/world/spectra.h"

namespace lancer {

namespace {

using std::numbers::pi;

constexpr int picture_width = 512;
constexpr int picture_height = 256;

std::vector<double> model_wavelengths() {
    std::vector<double> nanometres;
    for (int i = 0; i < kernel::MODEL_WAVELENGTHS; ++i) {
        nanometres.push_back(360.0 + static_cast<double>(kernel::MODEL_STEP) * i);
    }
    return nanometres;
}

// Light with that share of the sun's at each of the model's wavelengths.
SpectralCurve times_sun(const std::vector<double>& shares, const SpectralCurve& sun) {
    std::vector<double> nanometres, values;
    const SpectralCurve share(model_wavelengths(), shares, SpectralCurve::Beyond::constant);
    for (int i = 0; i < fine_grid.count; ++i) {
        nanometres.push_back(fine_grid.first + i * fine_grid.step);
        values.push_back(share.at(nanometres.back()) * sun.at(nanometres.back()));
    }
    return {std::move(nanometres), std::move(values), SpectralCurve::Beyond::zero};
}

}  // namespace

void compile_clear_sky(const scene::ClearSky& clear, double strength, World& world, Colors& colors) {
    kernel::SkyRecord& sky = world.sky;
    sky.kind = kernel::SKY_MODEL;
    sky.scale = static_cast<float>(strength);
    sky.width = picture_width;
    sky.height = picture_height;
    sky.stretch = 1.0f;
    const glm::dmat3 axes = scene::upright(clear.up);
    const glm::dvec3 sun = glm::transpose(axes) * clear.sun;
    sky.sun = kernel::vec3(sun);
    sky.tilted = axes == glm::dmat3(1.0) ? 0 : 1;
    sky.x_axis = kernel::vec3(axes[0]);
    sky.y_axis = kernel::vec3(axes[1]);
    sky.z_axis = kernel::vec3(axes[2]);
    const std::vector<double> nanometres = model_wavelengths();
    const Atmosphere air(clear.turbidity, clear.ozone, clear.ground, nanometres);
    const double sun_elevation = std::asin(std::clamp(sun.y, -1.0, 1.0));
    const SkyShares shares = air.sky(sun_elevation, kernel::MODEL_AZIMUTHS, kernel::MODEL_ELEVATIONS);
    sky.model = static_cast<int>(world.distributions.size());
    for (const double share : shares.radiance) {
        world.distributions.push_back(static_cast<float>(share));
    }
    for (const double share : shares.ground) {
        world.distributions.push_back(static_cast<float>(share));
    }
    const SpectralCurve sunlight = sun_outside_air().scaled(1.0 / (clear.distance * clear.distance));  // W/(m^2 nm)
    sky.horizon = colors.curve(sunlight.scaled(strength), to_rgb(sunlight) * strength);
    if (clear.has_sun && sun_elevation > -sun_radius / clear.distance) {
        const double radius = sun_radius / clear.distance;
        const double chord = 4.0 * std::pow(std::sin(radius / 2.0), 2.0);
        std::vector<double> passes = air.sun_transmittance(std::max(sun_elevation, 0.0));
        for (double& share : passes) {
            share /= pi * chord;  // the sun's solid angle
        }
        const SpectralCurve light = times_sun(passes, sunlight).scaled(strength);
        sky.sun_chord = static_cast<float>(chord);
        sky.sun_light = colors.curve(light, glm::max(to_rgb(light), scene::Rgb(0.0)));
    }
    // As RGB: what the eye makes of each wavelength of the table, the light between them shared out to its neighbours.
    std::vector<glm::dvec3> weights(nanometres.size(), glm::dvec3(0.0));
    for (int i = 0; i < fine_grid.count; ++i) {
        const double nm = fine_grid.first + i * fine_grid.step;
        const double place = std::clamp((nm - 360.0) / static_cast<double>(kernel::MODEL_STEP), 0.0, kernel::MODEL_WAVELENGTHS - 1.0);
        const auto before = std::min(static_cast<std::size_t>(place), nanometres.size() - 2);
        const double rest = place - static_cast<double>(before);
        const glm::dvec3 weight = sensor_weight(nm) * sunlight.at(nm);
        weights[before] += weight * (1.0 - rest);
        weights[before + 1] += weight * rest;
    }
    const auto seen = [&](const double* entry) {
        glm::dvec3 rgb(0.0);
        for (std::size_t i = 0; i < nanometres.size(); ++i) {
            rgb += weights[i] * entry[i];
        }
        return glm::max(rgb, glm::dvec3(0.0));
    };
    const glm::dvec3 ground = seen(shares.ground.data());
    std::vector<glm::dvec3> table;
    for (std::size_t i = 0; i < shares.radiance.size(); i += nanometres.size()) {
        table.push_back(seen(&shares.radiance[i]));
    }
    const auto at = [&](int azimuth, int elevation) {
        return table[static_cast<std::size_t>(azimuth * kernel::MODEL_ELEVATIONS + elevation)];
    };
    const double sun_azimuth = std::atan2(sun.x, -sun.z);
    world.sky_texels.clear();
    for (int row = 0; row < picture_height; ++row) {
        for (int column = 0; column < picture_width; ++column) {
            const double elevation = (0.5 - (row + 0.5) / picture_height) * pi;
            if (elevation < 0.0) {
                world.sky_texels.push_back(kernel::vec3(ground));
                continue;
            }
            const double longitude = ((column + 0.5) / picture_width - 0.5) * 2.0 * pi;
            const double off = std::abs(std::remainder(longitude - sun_azimuth, 2.0 * pi)) / pi * (kernel::MODEL_AZIMUTHS - 1);
            const double up = std::sqrt(elevation * 2.0 / pi) * (kernel::MODEL_ELEVATIONS - 1);
            const int x = std::min(static_cast<int>(off), kernel::MODEL_AZIMUTHS - 2);
            const int y = std::min(static_cast<int>(up), kernel::MODEL_ELEVATIONS - 2);
            const double u = off - x, v = up - y;
            const glm::dvec3 near = glm::mix(at(x, y), at(x, y + 1), v), far = glm::mix(at(x + 1, y), at(x + 1, y + 1), v);
            world.sky_texels.push_back(kernel::vec3(glm::mix(near, far, u)));
        }
    }
}

}  // namespace lancer
