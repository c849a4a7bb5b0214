// How far off the estimate of the time left is, from a tenth of the way on: in processor time, so that it makes no difference what else the machine does.
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "lancer/device/cpu/cpu.h"
#include "lancer/import/import.h"
#include "lancer/render/render.h"
#include "lancer/world/compile.h"

using namespace lancer;

namespace {

double processor_seconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

class Watch : public RenderObserver {
public:
    struct Moment {
        double seconds;
        double foreseen;  // how many in all
    };
    void tile_done(const Film&, const Tile&, const RenderProgress& progress) override {
        const double seconds = processor_seconds() - start_;
        moments.push_back({seconds, seconds * (1.0 + progress.seconds_left / std::max(progress.seconds, 1e-9))});
    }
    std::vector<Moment> moments;

private:
    double start_ = processor_seconds();
};

void measure(const std::string& path, int width, double error, int spp) {
    Diagnostics diagnostics;
    std::optional<scene::Scene> scene = import_scene(path, diagnostics);
    if (!scene) {
        fmt::print(stderr, "{}: {}\n", path, to_string(diagnostics.list().front()));
        std::exit(2);
    }
    const double shape = static_cast<double>(scene->settings.height) / scene->settings.width;
    scene->settings.width = width;
    scene->settings.height = std::max(8, static_cast<int>(std::lround(width * shape)));
    scene->settings.integrator = "path";
    const auto world = compile_world(*scene, scene->cameras.front(), diagnostics);
    if (world == nullptr) {
        fmt::print(stderr, "{}\n", to_string(diagnostics.list().front()));
        std::exit(2);
    }
    const auto device = make_cpu_device(world, {});
    RenderOptions options;
    options.width = scene->settings.width;
    options.height = scene->settings.height;
    options.threads = 1;
    options.shuffle = 1;
    options.spp = spp;
    options.error = error;
    options.intervals = error > 0.0;
    options.error_floor = error > 0.0 ? find_error_floor(*device, options) : 0.0;
    Film film(options.width, options.height);
    Watch watch;
    render(*device, options, film, &watch);
    const double total = watch.moments.back().seconds;
    // Of what is left, in the middle half and at worst; what is left is at least a fiftieth of the whole, since the last seconds matter to nobody.
    std::vector<double> off;
    for (const Watch::Moment& moment : watch.moments) {
        if (moment.seconds >= 0.1 * total) {
            off.push_back((moment.foreseen - total) / std::max(total - moment.seconds, 0.02 * total));
        }
    }
    std::sort(off.begin(), off.end(), [](double a, double b) { return std::fabs(a) < std::fabs(b); });
    std::size_t within = 0;
    for (const double each : off) {
        within += std::fabs(each) <= 0.2 ? 1 : 0;
    }
    const std::string name = path.substr(path.rfind('/') + 1);
    fmt::print("| {} | {} | {:.1f} s | {:.0f} % | {:+.0f} % | {:+.0f} % |\n", name.substr(0, name.find('.')),
               error > 0.0 ? fmt::format("`--error {:g}%`", 100.0 * error) : fmt::format("`--spp {}`", spp), total,
               100.0 * static_cast<double>(within) / static_cast<double>(off.size()), 100.0 * off[off.size() / 2], 100.0 * off.back());
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    fmt::print("| scene | goal | processor time | of the time within 20 % | off: median | off: at worst |\n|---|---|---|---|---|---|\n");
    for (int i = 1; i < argc; ++i) {
        measure(argv[i], 128, 0.0, 64);
        measure(argv[i], 128, 0.2, 1 << 14);
    }
    return 0;
}
