// Whether samples that go where the error is pay: the processor time to the same 95th percentile of the error, adaptive against uniform.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "lancer/film/luminance.h"
#include "small_scene.h"

using namespace lancer;

namespace {

struct Point {
    double seconds = 0.0;
    double error = 0.0;  // 95th percentile
    double samples = 0.0;
};

class Scene {
public:
    Scene(const std::string& path, int width) : scene_(read_small(path, width)) {}

    Film render_film(int seed, double error, int spp, Point* point = nullptr) {
        scene_.settings.seed = seed;
        const auto device = make_device(scene_);
        const double start = processor_seconds();
        const RenderOptions options = goal_options(*device, scene_, error, spp);
        if (floor_ == 0.0) {
            floor_ = find_error_floor(*device, options);
        }
        Film film(options.width, options.height);
        const RenderStatistics done = render(*device, options, film);
        if (point != nullptr) {
            point->seconds = processor_seconds() - start;
            point->samples = static_cast<double>(done.samples) / static_cast<double>(film.samples.size());
        }
        return film;
    }

    double error_of(const Film& film, const Film& truth) const {
        std::vector<double> errors;
        for (std::size_t i = 0; i < film.radiance.size(); ++i) {
            errors.push_back(std::fabs(luminance(glm::dvec3(film.radiance[i])) - luminance(glm::dvec3(truth.radiance[i]))) /
                             std::max(luminance(glm::dvec3(truth.radiance[i])), floor_));
        }
        const auto place = errors.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(errors.size()));
        std::nth_element(errors.begin(), place, errors.end());
        return *place;
    }

private:
    scene::Scene scene_;
    double floor_ = 0.0;
};

// The time that uniform sampling takes to an error, between its points on logarithmic scales; beyond them along the last line.
double time_to(const std::vector<Point>& points, double error) {
    std::size_t i = 1;
    while (i + 1 < points.size() && points[i].error > error) {
        ++i;
    }
    const Point &a = points[i - 1], &b = points[i];
    const double slope = std::log(b.seconds / a.seconds) / std::log(b.error / a.error);
    return a.seconds * std::exp(slope * std::log(error / a.error));
}

}  // namespace

int main(int argc, char** argv) {
    int width = 96, truth_spp = 1 << 12;
    std::vector<double> goals = {0.2};
    double sum = 0.0;
    int count = 0;
    fmt::print(
        "| scene | --error | samples a pixel | 95th percentile of the error | processor time | uniform | ratio "
        "|\n|---|---|---|---|---|---|---|\n");
    for (int i = 1; i < argc; ++i) {
        Scene scene(argv[i], width);
        const Film truth = scene.render_film(1000003, 0.0, truth_spp);
        std::vector<Point> uniform;
        for (int spp = 16; spp <= 512; spp *= 2) {
            Point& point = uniform.emplace_back();
            point.error = scene.error_of(scene.render_film(1, 0.0, spp, &point), truth);
        }
        std::string name = argv[i];
        name = name.substr(name.rfind('/') + 1);
        for (const double goal : goals) {
            Point point;
            point.error = scene.error_of(scene.render_film(1, goal, truth_spp / 4, &point), truth);
            const double alike = time_to(uniform, point.error);
            fmt::print("| {} | {:g} % | {:.0f} | {:.2f} % | {:.2f} s | {:.2f} s | {:.2f} |\n", name.substr(0, name.find('.')), 100.0 * goal,
                       point.samples, 100.0 * point.error, point.seconds, alike, point.seconds / alike);
            std::fflush(stdout);
            sum += std::log(point.seconds / alike);
            ++count;
        }
    }
    fmt::print("\nMean ratio (geometric): {:.2f}\n", std::exp(sum / std::max(count, 1)));
    return 0;
}
