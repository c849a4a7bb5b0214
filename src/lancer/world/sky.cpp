#include "lancer/world/sky.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <glm/common.hpp>

#include "lancer/base/failure.h"
#include "lancer/image/image.h"
#include "lancer/kernel/color.h"
#include "lancer/world/clear_sky.h"
#include "lancer/world/spectra.h"

namespace lancer {

namespace {

double luminance(const kernel::vec3& rgb) { return static_cast<double>(kernel::luminance(kernel::broadcast(rgb))); }

// Mean luminance over each texel of the sky as it is looked up, between the middles of its neighbours: 1/8, 3/4 and 1/8 of them each way.
std::vector<double> smooth_row(const World& world, int row) {
    const kernel::SkyRecord& sky = world.sky;
    std::vector<double> column_means(static_cast<std::size_t>(sky.width));
    for (int step = -1; step <= 1; ++step) {
        const int from = std::clamp(row + step, 0, sky.height - 1);
        const std::size_t first = static_cast<std::size_t>(from) * column_means.size();
        for (std::size_t i = 0; i < column_means.size(); ++i) {
            column_means[i] += luminance(world.sky_texels[first + i]) * (step == 0 ? 0.75 : 0.125);
        }
    }
    std::vector<double> means(column_means.size());
    for (std::size_t i = 0; i < means.size(); ++i) {
        const double before = column_means[i == 0 ? means.size() - 1 : i - 1];
        const double after = column_means[i + 1 == means.size() ? 0 : i + 1];
        means[i] = 0.75 * column_means[i] + 0.125 * (before + after);
    }
    return means;
}

// One black texel where it can't be read.
void load_image(const scene::ImageTexture& image, World& world, Diagnostics& diagnostics) {
    Image pixels{1, 1, 1, {0.0f}};
    try {
        const Encoding encoding = image.linear ? Encoding::linear : Encoding::automatic;
        pixels = image.bytes ? read_image(*image.bytes, image.file, encoding) : read_image(image.file, encoding);
    } catch (const MachineFailure&) {
        throw;
    } catch (const std::runtime_error& problem) {
        diagnostics.error(image.position, problem.what());
    }
    const auto channels = static_cast<std::size_t>(pixels.channels);
    world.sky.width = pixels.width;
    world.sky.height = pixels.height;
    world.sky_texels.reserve(pixels.pixels.size() / channels);
    for (std::size_t i = 0; i < pixels.pixels.size(); i += channels) {
        const float* p = &pixels.pixels[i];
        world.sky_texels.push_back((channels >= 3 ? kernel::vec3(p[0], p[1], p[2]) : kernel::vec3(p[0])) * kernel::vec3(image.tint));
    }
}

// Of all directions, those that a row covers.
double row_share(int row, int height) {
    const double step = std::numbers::pi / height;
    return 0.5 * (std::cos(step * row) - std::cos(step * (row + 1)));
}

// Cumulative shares of the sum, from `first` on; even ones where the sum is 0. Returns the sum.
double put_shares(const std::vector<double>& parts, std::size_t first, std::vector<float>& shares) {
    double sum = 0.0;
    for (const double part : parts) {
        sum += part;
    }
    double so_far = 0.0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        so_far += parts[i];
        shares[first + i] = static_cast<float>(sum > 0.0 ? so_far / sum : static_cast<double>(i + 1) / static_cast<double>(parts.size()));
    }
    return sum;
}

}  // namespace

void compile_sky(const scene::Background& background, World& world, Colors& colors, Diagnostics& diagnostics) {
    kernel::SkyRecord& sky = world.sky;
    sky.visible = background.visible ? 1 : 0;
    if (background.image) {
        load_image(*background.image, world, diagnostics);
        sky.kind = kernel::SKY_IMAGE;
        sky.turn = static_cast<float>(background.rotation / 360.0 - std::floor(background.rotation / 360.0));
        sky.scale = static_cast<float>(background.strength);
        sky.stretch = static_cast<float>(background.image->scale.y);
        sky.shift = static_cast<float>(1.0 - background.image->scale.y - background.image->offset.y);  // seen from the top
        sky.tilted = background.axes == glm::dmat3(1.0) ? 0 : 1;
        sky.x_axis = kernel::vec3(background.axes[0]);
        sky.y_axis = kernel::vec3(background.axes[1]);
        sky.z_axis = kernel::vec3(background.axes[2]);
        sky.horizon = colors.light(scene::Rgb(1.0));
        return;
    }
    if (background.sky) {
        compile_clear_sky(*background.sky, background.strength, world, colors);
        return;
    }
    const scene::Rgb zenith = emitted(background.zenith), horizon = emitted(background.horizon), nadir = emitted(background.nadir);
    const scene::Rgb most = glm::max(glm::max(zenith, horizon), nadir) * background.strength;
    if (!(std::max({most.x, most.y, most.z}) > 0.0)) {
        sky.kind = kernel::SKY_NONE;
        return;
    }
    const bool even = background.zenith == background.horizon && background.nadir == background.horizon;
    sky.kind = even ? kernel::SKY_EVEN : kernel::SKY_GRADIENT;
    sky.zenith = colors.light(background.zenith, background.strength);
    sky.horizon = colors.light(background.horizon, background.strength);
    sky.nadir = colors.light(background.nadir, background.strength);
}

SkyLight compile_sky_shares(World& world, bool compensated) {
    kernel::SkyRecord& sky = world.sky;
    if (sky.kind == kernel::SKY_NONE) {
        return {};
    }
    if (sky.kind != kernel::SKY_IMAGE && sky.kind != kernel::SKY_MODEL) {
        const double zenith = luminance(sky.zenith.rgb), horizon = luminance(sky.horizon.rgb), nadir = luminance(sky.nadir.rgb);
        const double mean = 0.25 * (zenith + 2.0 * horizon + nadir);
        // Gradients are drawn from evenly: no better than by the materials, unless these rarely look where it is bright.
        const bool even = std::max({zenith, horizon, nadir}) < 3.0 * mean;
        return {mean, compensated && even ? 0.0 : mean};
    }
    double mean = 0.0;
    for (int row = 0; row < sky.height; ++row) {
        double sum = 0.0;
        for (const double light : smooth_row(world, row)) {
            sum += light;
        }
        mean += sum / sky.width * row_share(row, sky.height);
    }
    const std::size_t width = static_cast<std::size_t>(sky.width), height = static_cast<std::size_t>(sky.height);
    const std::size_t first = world.distributions.size();
    sky.first_share = static_cast<int>(first);
    world.distributions.resize(first + height + height * width);
    const auto share_out = [&](double left_out) {
        std::vector<double> rows;
        for (int row = 0; row < sky.height; ++row) {
            std::vector<double> lights = smooth_row(world, row);
            for (double& light : lights) {
                light = std::max(light - left_out, 0.0);
            }
            const std::size_t place = first + height + static_cast<std::size_t>(row) * width;
            rows.push_back(put_shares(lights, place, world.distributions) * row_share(row, sky.height));
        }
        return put_shares(rows, first, world.distributions) / static_cast<double>(width);
    };
    double asked = compensated ? share_out(mean) : 0.0;
    if (!compensated) {
        asked = share_out(0.0);
    } else if (!(asked > 0.01 * mean)) {
        asked = 0.0;  // an even sky has nothing above its mean
        share_out(0.0);
    }
    const double scale = static_cast<double>(sky.scale);
    const double sun = 0.25 * luminance(sky.sun_light.rgb) * static_cast<double>(sky.sun_chord);  // over all directions
    sky.sun_share = static_cast<float>(sun > 0.0 ? std::clamp(sun / (asked * scale + sun), 0.1, 0.9) : 0.0);
    return {mean * scale + sun, asked * scale + sun};
}

}  // namespace lancer
