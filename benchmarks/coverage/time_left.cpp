// How far off the estimate of the time left is, from a tenth of the way on: in processor time, so that it makes no difference what else the machine does.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "small_scene.h"

using namespace lancer;

namespace {

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
    const scene::Scene scene = read_small(path, width);
    const auto device = make_device(scene);
    RenderOptions options = goal_options(*device, scene, error, spp);
    options.shuffle = 1;
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
