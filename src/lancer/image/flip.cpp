#include "lancer/image/flip.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <future>
#include <limits>
#include <numbers>
#include <numeric>

#include "lancer/image/separable_filter.h"

namespace lancer {

const double flip_pixels_per_degree = 0.7 * (3840.0 / 0.7) * std::numbers::pi / 180.0;

namespace {

using Triple = std::array<float, 3>;

// Constants of the paper, by their names there.
constexpr float q_c = 0.7f;       // exponent of colour differences
constexpr float p_c = 0.4f;       // the share of the largest colour difference that is ...
constexpr float p_t = 0.95f;      // ... mapped to this
constexpr float q_f = 0.5f;       // exponent of feature differences
constexpr double w_edge = 0.082;  // width of the feature detectors, degrees

// sRGB's primaries and white, D65, as rationals of the chromaticities [IEC 61966-2-1].
constexpr double to_xyz[3][3] = {{10135552.0 / 24577794.0, 8788810.0 / 24577794.0, 4435075.0 / 24577794.0},
                                 {2613072.0 / 12288897.0, 8788810.0 / 12288897.0, 887015.0 / 12288897.0},
                                 {1425312.0 / 73733382.0, 8788810.0 / 73733382.0, 70074185.0 / 73733382.0}};

struct Matrix {
    float m[3][3];

    Triple times(const Triple& v) const {
        return {m[0][0] * v[0] + m[0][1] * v[1] + m[0][2] * v[2], m[1][0] * v[0] + m[1][1] * v[1] + m[1][2] * v[2],
                m[2][0] * v[0] + m[2][1] * v[1] + m[2][2] * v[2]};
    }
};

// XYZ relative to white: (1, 1, 1) is white in both spaces.
struct RelativeXyz {
    Matrix from_rgb, to_rgb;

    RelativeXyz() {
        double a[3][3];
        for (int i = 0; i < 3; ++i) {
            const double white = to_xyz[i][0] + to_xyz[i][1] + to_xyz[i][2];
            for (int j = 0; j < 3; ++j) {
                a[i][j] = to_xyz[i][j] / white;
                from_rgb.m[i][j] = static_cast<float>(a[i][j]);
            }
        }
        const auto minor = [&](int i, int j) {
            const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
            return a[i1][j1] * a[i2][j2] - a[i1][j2] * a[i2][j1];
        };
        const double determinant = a[0][0] * minor(0, 0) + a[0][1] * minor(0, 1) + a[0][2] * minor(0, 2);
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                to_rgb.m[i][j] = static_cast<float>(minor(j, i) / determinant);
            }
        }
    }
};

const RelativeXyz& relative_xyz() {
    static const RelativeXyz matrices;
    return matrices;
}

float lab_root(float t) {
    constexpr float edge = 6.0f / 29.0f;
    return t > edge * edge * edge ? std::cbrt(t) : t / (3.0f * edge * edge) + 4.0f / 29.0f;
}

// CIE L*a*b*, with a* and b* made smaller in the dark, as the Hunt effect asks.
Triple hunt_lab(const Triple& rgb) {
    const Triple xyz = relative_xyz().from_rgb.times(rgb);
    const float x = lab_root(xyz[0]), y = lab_root(xyz[1]), z = lab_root(xyz[2]);
    const float lightness = 116.0f * y - 16.0f, hunt = 0.01f * lightness;
    return {lightness, hunt * 500.0f * (x - y), hunt * 200.0f * (y - z)};
}

// HyAB: city block in lightness, Euclidean in the plane of colours, compressed.
float color_distance(const Triple& a, const Triple& b) {
    const float da = a[1] - b[1], db = a[2] - b[2];
    return std::pow(std::fabs(a[0] - b[0]) + std::sqrt(da * da + db * db), q_c);
}

using Weights = std::vector<float>;

template <class Function>
Weights sampled(int radius, Function weight) {
    Weights weights;
    for (int i = -radius; i <= radius; ++i) {
        weights.push_back(static_cast<float>(weight(static_cast<double>(i))));
    }
    return weights;
}

// The positive weights are scaled to sum to 1, the negative ones to -1.
Weights balanced(Weights weights) {
    double positive = 0.0, negative = 0.0;
    for (const float w : weights) {
        (w > 0.0f ? positive : negative) += static_cast<double>(w);
    }
    for (float& w : weights) {
        w = static_cast<float>(w > 0.0f ? static_cast<double>(w) / positive : w < 0.0f ? -static_cast<double>(w) / negative : 0.0);
    }
    return weights;
}

struct Gaussian {
    Weights weights;  // sum to 1
    float share;      // of the whole filter
};

// A contrast sensitivity function as a sum of Gaussians, each a sqrt(pi / b) exp(-(pi d)^2 / b) at d degrees.
struct Component {
    double a, b;
};

std::vector<Gaussian> sensitivity_filter(const std::vector<Component>& components, double pixels_per_degree) {
    constexpr double widest = 0.04;  // b of the widest Gaussian: one radius for all
    const double pi = std::numbers::pi;
    const int radius = static_cast<int>(std::ceil(3.0 * std::sqrt(widest / (2.0 * pi * pi)) * pixels_per_degree));
    std::vector<Gaussian> result;
    std::vector<double> volumes;
    for (const Component& c : components) {
        const auto weight = [&](double i) { return std::exp(-pi * pi * i * i / (pixels_per_degree * pixels_per_degree * c.b)); };
        double sum = 0.0;
        for (int i = -radius; i <= radius; ++i) {
            sum += weight(static_cast<double>(i));
        }
        result.push_back({sampled(radius, [&](double i) { return weight(i) / sum; }), 1.0f});
        volumes.push_back(c.a * std::sqrt(pi / c.b) * sum * sum);
    }
    const double whole = std::accumulate(volumes.begin(), volumes.end(), 0.0);
    for (std::size_t i = 0; i < result.size(); ++i) {
        result[i].share = static_cast<float>(volumes[i] / whole);
    }
    return result;
}

Plane blurred(const Plane& plane, const std::vector<Gaussian>& filter) {
    Plane result(plane.width, plane.height);
    for (const Gaussian& gaussian : filter) {
        const Plane part = filter_columns(filter_rows(plane, gaussian.weights), gaussian.weights);
        for (std::size_t i = 0; i < part.values.size(); ++i) {
            result.values[i] += gaussian.share * part.values[i];
        }
    }
    return result;
}

struct Filters {
    std::vector<Gaussian> lightness, red_green, blue_yellow;
    Weights smooth, edge, point;

    explicit Filters(double pixels_per_degree)
        : lightness(sensitivity_filter({{1.0, 0.0047}}, pixels_per_degree)),
          red_green(sensitivity_filter({{1.0, 0.0053}}, pixels_per_degree)),
          blue_yellow(sensitivity_filter({{34.1, 0.04}, {13.5, 0.025}}, pixels_per_degree)) {
        const double sigma = 0.5 * w_edge * pixels_per_degree;
        const int radius = static_cast<int>(std::ceil(3.0 * sigma));
        const auto gauss = [&](double i) { return std::exp(-i * i / (2.0 * sigma * sigma)); };
        smooth = balanced(sampled(radius, gauss));
        edge = balanced(sampled(radius, [&](double i) { return -i * gauss(i); }));
        point = balanced(sampled(radius, [&](double i) { return (i * i / (sigma * sigma) - 1.0) * gauss(i); }));
    }
};

// What the eye makes of one picture.
struct Perceived {
    std::vector<Triple> colors;        // Hunt-adjusted L*a*b*
    std::vector<float> edges, points;  // how strong
};

std::vector<float> lengths(const Plane& x, const Plane& y) {
    std::vector<float> result(x.values.size());
    for (std::size_t i = 0; i < result.size(); ++i) {
        result[i] = std::sqrt(x.values[i] * x.values[i] + y.values[i] * y.values[i]);
    }
    return result;
}

Perceived perceive(const std::vector<Triple>& rgb, int width, int height, const Filters& filters) {
    const RelativeXyz& space = relative_xyz();
    // YCxCz without its scales, which are linear: Y, X - Y and Y - Z.
    Plane y(width, height), red_green(width, height), blue_yellow(width, height);
    for (std::size_t i = 0; i < rgb.size(); ++i) {
        const Triple xyz = space.from_rgb.times(rgb[i]);
        y.values[i] = xyz[1];
        red_green.values[i] = xyz[0] - xyz[1];
        blue_yellow.values[i] = xyz[1] - xyz[2];
    }
    Perceived result;
    {
        const Plane seen_y = blurred(y, filters.lightness), seen_rg = blurred(red_green, filters.red_green),
                    seen_by = blurred(blue_yellow, filters.blue_yellow);
        result.colors.resize(rgb.size());
        for (std::size_t i = 0; i < rgb.size(); ++i) {
            const float luminance = seen_y.values[i];
            Triple color = space.to_rgb.times({seen_rg.values[i] + luminance, luminance, luminance - seen_by.values[i]});
            for (float& c : color) {
                c = std::clamp(c, 0.0f, 1.0f);
            }
            result.colors[i] = hunt_lab(color);
        }
    }
    const Plane smooth = filter_rows(y, filters.smooth);
    result.edges = lengths(filter_columns(filter_rows(y, filters.edge), filters.smooth), filter_columns(smooth, filters.edge));
    result.points = lengths(filter_columns(filter_rows(y, filters.point), filters.smooth), filter_columns(smooth, filters.point));
    return result;
}

// The larger of what the map holds and the difference of the two.
void add_difference(const Perceived& a, const Perceived& b, std::vector<float>& map) {
    const float most = color_distance(hunt_lab({0.0f, 1.0f, 0.0f}), hunt_lab({0.0f, 0.0f, 1.0f}));
    const float knee = p_c * most;
    for (std::size_t i = 0; i < map.size(); ++i) {
        const float distance = color_distance(a.colors[i], b.colors[i]);
        const float color = distance < knee ? distance * p_t / knee : p_t + (distance - knee) / (most - knee) * (1.0f - p_t);
        const float stronger = std::max(std::fabs(a.edges[i] - b.edges[i]), std::fabs(a.points[i] - b.points[i]));
        const float feature = std::clamp(std::pow(stronger * std::numbers::sqrt2_v<float> * 0.5f, q_f), 0.0f, 1.0f);
        map[i] = std::max(map[i], std::pow(std::clamp(color, 0.0f, 1.0f), 1.0f - feature));
    }
}

float usable(float value) { return value > 0.0f ? std::min(value, std::numeric_limits<float>::max()) : 0.0f; }

template <class Curve>
std::vector<Triple> shown(const Image& image, Curve curve) {
    std::vector<Triple> result(image.pixels.size() / 3);
    for (std::size_t i = 0; i < result.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            result[i][c] = std::min(1.0f, curve(usable(image.pixels[3 * i + c])));
        }
    }
    return result;
}

// The two pictures are looked at by a thread each.
template <class Curve>
void add_difference_as_shown(const Image& image, const Image& reference, const Filters& filters, Curve curve, std::vector<float>& map) {
    const auto look = [&](const Image& picture) { return perceive(shown(picture, curve), picture.width, picture.height, filters); };
    std::future<Perceived> other = std::async(std::launch::async, [&] { return look(reference); });
    const Perceived one = look(image);
    add_difference(one, other.get(), map);
}

void check([[maybe_unused]] const Image& image, [[maybe_unused]] const Image& reference) {
    assert(image.channels == 3 && reference.channels == 3 && image.width == reference.width && image.height == reference.height);
}

// The ACES curve x (k0 x + k1) / (x (k3 x + k4) + k5), with an exposure of 0.6 in it.
constexpr double k0 = 0.36 * 2.51, k1 = 0.6 * 0.03, k3 = 0.36 * 2.43, k4 = 0.6 * 0.59, k5 = 0.14;

float tone_mapped(float exposed) {
    const double x = static_cast<double>(exposed);
    return static_cast<float>(x * (k0 * x + k1) / (x * (k3 * x + k4) + k5));
}

// What the curve maps to `shown`.
double tone_mapped_from(double shown) {
    const double a = k0 - k3 * shown, b = k1 - k4 * shown, c = -k5 * shown;
    return (-b + std::sqrt(b * b - 4.0 * a * c)) / (2.0 * a);
}

}  // namespace

double FlipMap::mean() const {
    double sum = 0.0;
    for (const float value : values) {
        sum += static_cast<double>(value);
    }
    return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

double FlipExposures::at(int i) const { return count < 2 ? first : first + (last - first) * i / (count - 1); }

FlipExposures flip_exposures(const Image& reference) {
    std::vector<float> luminances;
    for (std::size_t i = 0; i + 2 < reference.pixels.size(); i += 3) {
        const float* p = reference.pixels.data() + i;
        luminances.push_back(0.2126f * usable(p[0]) + 0.7152f * usable(p[1]) + 0.0722f * usable(p[2]));
    }
    const auto median_of = [](std::vector<float>& values) {
        const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
        std::nth_element(values.begin(), middle, values.end());
        return static_cast<double>(*middle);
    };
    const double highest = luminances.empty() ? 0.0 : static_cast<double>(*std::max_element(luminances.begin(), luminances.end()));
    if (highest <= 0.0) {
        return {0.0, 0.0, 1};
    }
    double median = median_of(luminances);
    if (median <= 0.0) {
        luminances.erase(std::remove(luminances.begin(), luminances.end(), 0.0f), luminances.end());
        median = median_of(luminances);
    }
    const double bright = tone_mapped_from(0.85);
    const double first = std::log2(bright / highest), last = std::log2(bright / median);
    return {first, last, std::max(2, static_cast<int>(std::ceil(last - first)))};
}

FlipMap flip_for_displays(const Image& image, const Image& reference, double pixels_per_degree) {
    check(image, reference);
    const Filters filters(pixels_per_degree);
    FlipMap map{image.width, image.height, std::vector<float>(image.pixels.size() / 3)};
    add_difference_as_shown(
        image, reference, filters, [](float value) { return value; }, map.values);
    return map;
}

FlipMap flip_for_light(const Image& image, const Image& reference, const FlipExposures& exposures, double pixels_per_degree) {
    check(image, reference);
    const Filters filters(pixels_per_degree);
    FlipMap map{image.width, image.height, std::vector<float>(image.pixels.size() / 3)};
    for (int i = 0; i < exposures.count; ++i) {
        const float scale = static_cast<float>(std::exp2(exposures.at(i)));
        const auto exposed = [scale](float value) { return tone_mapped(usable(value * scale)); };
        add_difference_as_shown(image, reference, filters, exposed, map.values);
    }
    return map;
}

}  // namespace lancer
