#include "lancer/import/pbrt/environments.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "lancer/import/made_picture.h"
#include "lancer/import/pbrt/octahedron.h"

namespace lancer::pbrt {

namespace {

using std::numbers::pi;

constexpr int most_rows = 1024;

scene::Rgb pixel(const Image& image, double x, double y) {
    const int column = std::clamp(static_cast<int>(x * image.width), 0, image.width - 1);
    const int row = std::clamp(static_cast<int>(y * image.height), 0, image.height - 1);
    const auto channels = static_cast<std::size_t>(image.channels);
    const float* p =
        &image
             .pixels[(static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(column)) * channels];
    return channels >= 3 ? scene::Rgb(p[0], p[1], p[2]) : scene::Rgb(static_cast<double>(p[0]));
}

scene::Rgb radiance(const Environment& environment, const glm::dvec3& direction) {
    const glm::dvec3 d = glm::normalize(environment.to_light * direction);
    if (environment.square) {
        const glm::dvec2 place = square_of_direction(d);
        return pixel(environment.image, place.x, place.y) * environment.scale;
    }
    const double angle = std::atan2(d.y, d.x);
    return pixel(environment.image, (angle < 0.0 ? angle + 2.0 * pi : angle) / (2.0 * pi), std::acos(std::clamp(d.z, -1.0, 1.0)) / pi) *
           environment.scale;
}

}  // namespace

scene::ImageTexture panorama_of(const std::vector<Environment>& environments, const scene::Rgb& everywhere) {
    int rows = 1;
    for (const Environment& environment : environments) {
        rows = std::max(rows, std::min(environment.image.height, most_rows));
    }
    // Across each pixel, either way: a sun of one pixel must not fall between two looks.
    const int probes = rows > 512 ? 3 : 4;
    Image picture{2 * rows, rows, 3, {}};
    picture.pixels.reserve(static_cast<std::size_t>(2 * rows) * static_cast<std::size_t>(rows) * 3);
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < 2 * rows; ++x) {
            scene::Rgb sum(0.0);
            double weights = 0.0;
            for (int i = 0; i < probes * probes; ++i) {
                const double tilt = pi * (y + (i / probes + 0.5) / probes) / rows;
                const double around = pi * (x + (i % probes + 0.5) / probes) / rows - pi;
                const double ring = std::sin(tilt);  // by which the probe's part of the sphere grows
                const glm::dvec3 direction(std::sin(around) * ring, std::cos(tilt), -std::cos(around) * ring);
                for (const Environment& environment : environments) {
                    sum += ring * radiance(environment, direction);
                }
                weights += ring;
            }
            const scene::Rgb mean = glm::max(sum / weights + everywhere, 0.0);
            for (int i = 0; i < 3; ++i) {
                picture.pixels.push_back(static_cast<float>(mean[i]));
            }
        }
    }
    return made_picture(picture, environments.front().position);
}

double illuminance_of(const Image& square) {
    double sum = 0.0;
    for (int y = 0; y < square.height; ++y) {
        for (int x = 0; x < square.width; ++x) {
            const double u = (x + 0.5) / square.width, v = (y + 0.5) / square.height;
            const glm::dvec3 direction = direction_of_square({u, v});
            sum += direction.z > 0.0 ? glm::dot(pixel(square, u, v), scene::Rgb(0.2126, 0.7152, 0.0722)) * direction.z : 0.0;
        }
    }
    return sum * 2.0 * pi / (static_cast<double>(square.width) * square.height);
}

scene::Rgb mean_color(const Image& image, bool square) {
    const auto channels = static_cast<std::size_t>(image.channels);
    scene::Rgb sum(0.0);
    double weights = 0.0;
    std::size_t at = 0;
    for (int y = 0; y < image.height; ++y) {
        const double weight = square ? 1.0 : std::sin(std::numbers::pi * (y + 0.5) / image.height);
        for (int x = 0; x < image.width; ++x, at += channels) {
            const float* p = &image.pixels[at];
            sum += weight * (channels >= 3 ? scene::Rgb(p[0], p[1], p[2]) : scene::Rgb(static_cast<double>(p[0])));
            weights += weight;
        }
    }
    return weights > 0.0 ? sum / weights : scene::Rgb(0.0);
}

bool turned_axes(const Environment& environment, glm::dmat3& axes) {
    const glm::dmat3 to_world = glm::inverse(environment.to_light);
    // Its longitudes run from x to y, ours from the back to the right.
    axes = glm::dmat3(to_world[1], to_world[2], -to_world[0]);
    double off = 0.0;
    for (int i = 0; i < 3; ++i) {
        axes[i] = glm::normalize(axes[i]);
        off = std::max({off, std::abs(glm::dot(axes[i], axes[(i + 1) % 3])), 0.0});
    }
    return off < 1e-4;
}

}  // namespace lancer::pbrt
