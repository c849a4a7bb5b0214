#include "lancer/world/filters.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lancer/kernel/math.h"

namespace lancer {

namespace {

// [Mitchell and Netravali 1988], B = C = 1/3, over -2 to 2.
double mitchell(double x) {
    constexpr double b = 1.0 / 3.0, c = 1.0 / 3.0;
    const double x2 = x * x, x3 = x2 * x;
    if (x < 1.0) {
        return ((12.0 - 9.0 * b - 6.0 * c) * x3 + (-18.0 + 12.0 * b + 6.0 * c) * x2 + (6.0 - 2.0 * b)) / 6.0;
    }
    return ((-b - 6.0 * c) * x3 + (6.0 * b + 30.0 * c) * x2 + (-12.0 * b - 48.0 * c) * x + (8.0 * b + 24.0 * c)) / 6.0;
}

// The window with four terms [Harris 1978], over 0 to 1.
double blackman_harris(double t) {
    using std::numbers::pi;
    return 0.35875 - 0.48829 * std::cos(2.0 * pi * t) + 0.14128 * std::cos(4.0 * pi * t) - 0.01168 * std::cos(6.0 * pi * t);
}

}  // namespace

double usual_radius(scene::PixelFilter filter) {
    switch (filter) {
        case scene::PixelFilter::box:
            return 0.5;
        case scene::PixelFilter::tent:
            return 1.0;
        case scene::PixelFilter::mitchell:
            return 2.0;
        case scene::PixelFilter::gaussian:
        case scene::PixelFilter::blackman_harris:
            return 1.5;
    }
    return 0.5;
}

double filter_value(scene::PixelFilter filter, double radius, double distance) {
    const double t = std::abs(distance) / radius;
    if (t > 1.0) {
        return 0.0;
    }
    switch (filter) {
        case scene::PixelFilter::box:
            return 1.0;
        case scene::PixelFilter::tent:
            return 1.0 - t;
        case scene::PixelFilter::gaussian:  // three standard deviations, lowered to meet 0 at the end
            return std::exp(-4.5 * t * t) - std::exp(-4.5);
        case scene::PixelFilter::mitchell:
            return mitchell(2.0 * t);
        case scene::PixelFilter::blackman_harris:
            return blackman_harris(0.5 + 0.5 * t);
    }
    return 0.0;
}

void compile_filter(const scene::RenderSettings& settings, World& world) {
    const double radius = settings.filter_radius.value_or(usual_radius(settings.filter));
    // Sums over thin slices, the middle of each standing for it.
    constexpr int slices = 1 << 16;
    std::vector<double> so_far(slices + 1, 0.0);
    double own = 0.0;
    world.filter.negative_from = kernel::FAR;
    for (int i = 0; i < slices; ++i) {
        const double place = radius * (2.0 * (i + 0.5) / slices - 1.0);
        const double value = filter_value(settings.filter, radius, place);
        own += value;
        so_far[static_cast<std::size_t>(i) + 1] = so_far[static_cast<std::size_t>(i)] + std::abs(value);
        if (place > 0.0 && value < 0.0 && world.filter.negative_from == kernel::FAR) {
            world.filter.negative_from = static_cast<float>(place);
        }
    }
    const double all = so_far.back();
    world.filter.weight = static_cast<float>(all / own);
    world.filter.radius = static_cast<float>(radius);
    for (int i = 0; i <= kernel::FILTER_VALUES; ++i) {
        const double value = filter_value(settings.filter, radius, radius * i / kernel::FILTER_VALUES);
        world.filter_values.push_back(static_cast<float>(value * slices / (2.0 * radius * own)));
    }
    std::size_t slice = 0;
    for (int step = 0; step <= kernel::FILTER_STEPS; ++step) {
        const double t = static_cast<double>(step) / kernel::FILTER_STEPS;
        const double goal = all * (t < 0.5 ? 2.0 * t * t : 1.0 - 2.0 * (1.0 - t) * (1.0 - t));  // where to_even_ends is t
        while (slice + 1 < so_far.size() - 1 && so_far[slice + 1] <= goal) {
            ++slice;
        }
        const double width = so_far[slice + 1] - so_far[slice];
        const double part = width > 0.0 ? std::min((goal - so_far[slice]) / width, 1.0) : 0.0;
        world.filter_places.push_back(static_cast<float>(radius * (2.0 * (static_cast<double>(slice) + part) / slices - 1.0)));
    }
}

}  // namespace lancer
