// Whether samples that go where the error is pay: processor time to the same error, adaptive against uniform. Two measures of it: what is stated (95 % of
// the pixels are known within the goal) and what is true (the 95th percentile of the difference from a long render).
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "lancer/film/luminance.h"
#include "lancer/image/image.h"
#include "small_scene.h"

using namespace lancer;

namespace {

struct Point {
    double seconds = 0.0;
    double samples = 0.0;  // a pixel
    double share = 0.0;    // of the pixels, known within the goal
    double error = 0.0;    // true, 95th percentile
};

// A render that may be gone on with.
class Run {
public:
    Run(const scene::Scene& scene, const Image& truth, double goal, bool adaptive)
        : device_(make_device(scene)), truth_(truth), film_(truth.width, truth.height), sums_(truth.width, truth.height, layers()) {
        const double start = processor_seconds();
        options_ = goal_options(*device_, scene, adaptive ? goal : 0.0, 1 << 16);
        point_.seconds = processor_seconds() - start;
        goal_.error = goal;
        goal_.floor = options_.goal.floor;
        state_.emplace(film_, &sums_, tile_size_for(options_));
    }

    Point go_on_to(int spp) {
        options_.spp = spp;
        const double start = processor_seconds();
        render(*device_, options_, *state_);
        point_.seconds += processor_seconds() - start;
        const ErrorReport report = report_errors(goal_, *state_);
        point_.samples = report.samples / static_cast<double>(report.pixels);
        point_.share = report.share;
        point_.error = true_error();
        return point_;
    }

private:
    static FilmLayers layers() {
        FilmLayers layers;
        layers.runs = true;
        return layers;
    }
    double true_error() const {
        std::vector<double> errors;
        for (std::size_t i = 0; i < film_.radiance.size(); ++i) {
            const float* const rgb = &truth_.pixels[i * static_cast<std::size_t>(truth_.channels)];
            const double truth = luminance(glm::dvec3(rgb[0], rgb[1], rgb[2]));
            errors.push_back(std::fabs(luminance(glm::dvec3(film_.radiance[i])) - truth) / std::max(truth, goal_.floor));
        }
        const auto place = errors.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(errors.size()));
        std::nth_element(errors.begin(), place, errors.end());
        return *place;
    }

    std::unique_ptr<Device> device_;
    const Image& truth_;
    ErrorGoal goal_;
    RenderOptions options_;
    Film film_;
    FilmSums sums_;
    std::optional<FilmState> state_;
    Point point_;
};

// The time at which a line through points, sorted by time, comes to a value: straight between the two around it, or the first or last two.
double time_to(const std::vector<Point>& points, double Point::*measure, double value) {
    const bool falls = points.back().*measure < points.front().*measure;
    std::size_t i = 1;
    while (i + 1 < points.size() && (falls ? points[i].*measure > value : points[i].*measure < value)) {
        ++i;
    }
    const Point &a = points[i - 1], &b = points[i];
    const double place = (std::log(value) - std::log(a.*measure)) / (std::log(b.*measure) - std::log(a.*measure));
    return a.seconds * std::pow(b.seconds / a.seconds, place);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 4 || argc % 3 != 1) {
        fmt::print(
            stderr,
            "lancer_adaptive ERROR SCENE TRUTH [ERROR SCENE TRUTH ...]\nTRUTH: the scene with many samples, with another seed, as small as "
            "it is to be "
            "rendered.\nFor example:\n  lancer render box.toml --integrator path --size 160x90 --spp 8192 --seed 7 --float -o box.exr\n  "
            "lancer_adaptive 0.2 box.toml box.exr\n");
        return 2;
    }
    double of_stated = 0.0, of_true = 0.0;
    fmt::print(
        "| scene | `--error` | samples a pixel | known | true error | processor time | uniform, as much known | ratio | uniform, same true "
        "error | ratio |\n"
        "|---|---|---|---|---|---|---|---|---|---|\n");
    for (int i = 1; i < argc; i += 3) {
        const double goal = std::atof(argv[i]);
        const Image truth = read_image(argv[i + 2]);
        scene::Scene scene = read_small(argv[i + 1], truth.width);
        scene.settings.height = truth.height;
        const Point point = Run(scene, truth, goal, true).go_on_to(1 << 16);
        Run run(scene, truth, goal, false);
        std::vector<Point> uniform = {run.go_on_to(16)};
        for (int spp = 32; spp <= 1 << 14 && (spp < 256 || uniform.back().share < 0.95 || uniform.back().error > point.error); spp *= 2) {
            uniform.push_back(run.go_on_to(spp));
        }
        const double stated = time_to(uniform, &Point::share, 0.95), alike = time_to(uniform, &Point::error, point.error);
        std::string name = argv[i + 1];
        name = name.substr(name.rfind('/') + 1);
        fmt::print("| {} | {:g} % | {:.0f} | {:.1f} % | {:.2f} % | {:.2f} s | {:.2f} s | {:.2f} | {:.2f} s | {:.2f} |\n",
                   name.substr(0, name.find('.')), 100.0 * goal, point.samples, 100.0 * point.share, 100.0 * point.error, point.seconds,
                   stated, point.seconds / stated, alike, point.seconds / alike);
        std::fflush(stdout);
        of_stated += std::log(point.seconds / stated);
        of_true += std::log(point.seconds / alike);
    }
    const double count = (argc - 1) / 3;
    fmt::print("\nMean ratios (geometric): stated {:.2f}, true {:.2f}\n", std::exp(of_stated / count), std::exp(of_true / count));
    return 0;
}
