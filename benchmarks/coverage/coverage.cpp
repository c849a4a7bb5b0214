// How often the truth lies within the interval that a render states: small pictures of scenes of several kinds, many seeds each.
//
// The truth is a closed form where there is one, and a picture of a hundred and more times as many samples (and another seed) elsewhere; such a truth is
// itself a little off, which can only lower what is counted. Pixels with a heavy tail are not trusted by lancer and counted apart.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "lancer/device/cpu/cpu.h"
#include "lancer/film/interval.h"
#include "lancer/film/luminance.h"
#include "lancer/import/import.h"
#include "lancer/render/goal_plan.h"
#include "lancer/world/compile.h"

using namespace lancer;

namespace {

struct Subject {
    const char* name;
    const char* what;
    const char* text;    // of the scene
    double truth = 0.0;  // luminance of every pixel; 0: not known in closed form
};

const char* const camera = "[camera]\nposition = [0, 1, 4]\nlook_at = [0, 0.5, 0]\nfov = 40\n";
const char* const floor_and_lamp =
    "[[box]]\nmin = [-3, -0.1, -3]\nmax = [3, 0, 3]\nmaterial = { type = \"diffuse\", color = \"#a0a0a0\" }\n"
    "[[sphere]]\ncenter = [1.2, 2.5, 1]\nradius = 0.4\nmaterial = { type = \"diffuse\", emission = [1, 0.9, 0.8], emission_strength = 12 "
    "}\n";

const Subject subjects[] = {
    {"furnace", "closed form: white furnace seen through a matt ball",
     "[camera]\nposition = [0, 0, 4]\nlook_at = [0, 0, 0]\nfov = 10\n[background]\nzenith = [1, 1, 1]\nhorizon = [1, 1, 1]\nnadir = [1, 1, "
     "1]\n"
     "[[sphere]]\nradius = 1\nmaterial = { type = \"diffuse\", color = [0.5, 0.5, 0.5] }\n",
     0.5},
    {"diffuse", "matt things under a lamp",
     "[[sphere]]\ncenter = [0, 0.6, 0]\nradius = 0.6\nmaterial = { type = \"diffuse\", color = \"#c08040\" }\n"},
    {"glossy", "rough metals",
     "[[sphere]]\ncenter = [-0.6, 0.6, 0]\nradius = 0.6\nmaterial = { type = \"conductor\", metal = \"copper\", roughness = 0.3 }\n"
     "[[sphere]]\ncenter = [0.7, 0.5, 0]\nradius = 0.5\nmaterial = { type = \"plastic\", color = \"#305080\", roughness = 0.2 }\n"},
    {"glass", "a glass ball and its caustic",
     "[[sphere]]\ncenter = [0, 0.6, 0]\nradius = 0.6\nmaterial = { type = \"dielectric\", refraction = \"N-BK7\" }\n"},
    {"textured", "a checkered ball",
     "[[sphere]]\ncenter = [0, 0.6, 0]\nradius = 0.6\nmaterial = { type = \"diffuse\", color = { type = \"checker\", first = \"#e0e0e0\", "
     "second = \"#203040\", size = 0.17 } }\n"},
    {"many-lights", "a hundred small lamps", nullptr},
    {"fog", "a ball of fog under a lamp",
     "[medium.fog]\nscattering = [2, 2, 2]\nabsorption = [0.1, 0.2, 0.4]\n"
     "[[sphere]]\ncenter = [0, 0.8, 0]\nradius = 0.7\nmaterial = { type = \"null\", interior = \"fog\" }\n"},
};

std::string text_of(const Subject& subject) {
    if (subject.truth > 0.0) {
        return subject.text;
    }
    std::string text = camera;
    if (subject.text != nullptr) {
        return text + floor_and_lamp + subject.text;
    }
    text +=
        "[[box]]\nmin = [-3, -0.1, -3]\nmax = [3, 0, 3]\nmaterial = { type = \"diffuse\", color = \"#a0a0a0\" }\n"
        "[[sphere]]\ncenter = [0, 0.6, 0]\nradius = 0.6\nmaterial = { type = \"diffuse\", color = \"#c08040\" }\n";
    for (int i = 0; i < 100; ++i) {
        text += fmt::format(
            "[[sphere]]\ncenter = [{}, {}, {}]\nradius = 0.05\nmaterial = {{ type = \"diffuse\", emission = [{}, 0.8, {}], "
            "emission_strength = {} }}\n",
            (i % 10) * 0.5 - 2.25, 1.6 + 0.1 * (i % 7), (i / 10) * 0.5 - 2.25, 0.4 + 0.06 * (i % 10), 1.0 - 0.06 * (i % 10), 4 + i % 13);
    }
    return text;
}

struct Setting {
    int width = 24;
    int height = 18;
    double error = 0.25;
    double confidence = 0.95;
    int seeds = 200;
    int truth_spp = 1 << 15;
    int threads = 2;
};

std::shared_ptr<const World> world_of(const Subject& subject, const Setting& setting, int seed) {
    Diagnostics diagnostics;
    std::optional<scene::Scene> scene = import_toml(text_of(subject), std::string(subject.name) + ".toml", diagnostics);
    std::shared_ptr<const World> world;
    if (scene) {
        scene->settings.width = setting.width;
        scene->settings.height = setting.height;
        scene->settings.integrator = "path";
        scene->settings.seed = seed;
        world = compile_world(*scene, scene->cameras.front(), diagnostics);
    }
    if (!world) {
        for (const Diagnostic& diagnostic : diagnostics.list()) {
            fmt::print(stderr, "{}\n", to_string(diagnostic));
        }
        std::exit(2);
    }
    return world;
}

struct Picture {
    Picture(const Subject& subject, const Setting& setting, int seed, double error, int spp)
        : film(setting.width, setting.height), sums(setting.width, setting.height, layers()) {
        const auto device = make_cpu_device(world_of(subject, setting, seed), {});
        RenderOptions options;
        options.width = setting.width;
        options.height = setting.height;
        options.threads = setting.threads;
        options.spp = spp;
        options.intervals = true;
        options.goal.error = error;
        options.goal.confidence = setting.confidence;
        options.goal = plan_goal(*device, options);
        floor = options.goal.floor;
        FilmState state(film, &sums, tile_size_for(options));
        done = render(*device, options, state);
    }
    static FilmLayers layers() {
        FilmLayers layers;
        layers.runs = true;
        return layers;
    }
    Film film;
    FilmSums sums;
    RenderStatistics done;
    double floor = 0.0;
};

// One long sequence of points a pixel, which is more even than 16 short ones.
Film converged_film(const Subject& subject, const Setting& setting) {
    const auto device = make_cpu_device(world_of(subject, setting, 1000003), {});
    RenderOptions options;
    options.width = setting.width;
    options.height = setting.height;
    options.threads = setting.threads;
    options.spp = setting.truth_spp;
    Film film(setting.width, setting.height);
    render(*device, options, film);
    return film;
}

void measure(const Subject& subject, const Setting& setting) {
    std::vector<double> truth(static_cast<std::size_t>(setting.width * setting.height), subject.truth);
    if (subject.truth == 0.0) {
        const Film converged = converged_film(subject, setting);
        for (std::size_t i = 0; i < truth.size(); ++i) {
            truth[i] = luminance(glm::dvec3(converged.radiance[i]));
        }
    }
    double inside = 0.0, counted = 0.0, heavy = 0.0, samples = 0.0, worst = 1.0, known = 0.0;
    for (int seed = 1; seed <= setting.seeds; ++seed) {
        const Picture picture(subject, setting, seed, setting.error, 1 << 10);
        const std::vector<Interval> intervals =
            IntervalRule(setting.confidence, picture.floor).of(picture.sums, {0, 0, setting.width, setting.height});
        double inside_here = 0.0, counted_here = 0.0;
        for (std::size_t i = 0; i < truth.size(); ++i) {
            const Interval& interval = intervals[i];
            samples += picture.film.samples[i];
            if (interval.heavy()) {
                heavy += 1.0;
                continue;
            }
            counted_here += 1.0;
            // What rounding to floats leaves of a pixel without noise.
            inside_here += std::fabs(interval.middle - truth[i]) <= interval.half_width + 1e-5 * truth[i] ? 1.0 : 0.0;
        }
        inside += inside_here;
        counted += counted_here;
        worst = std::min(worst, inside_here / std::max(counted_here, 1.0));
        known += picture.done.error.share;
    }
    const double pixels = static_cast<double>(truth.size()) * setting.seeds;
    fmt::print("| {} | {} | {:.2f} % | {:.1f} % | {:.1f} % | {:.2f} % | {:.0f} |\n", subject.name, subject.what, 100.0 * inside / counted,
               100.0 * worst, 100.0 * known / setting.seeds, 100.0 * heavy / pixels, samples / pixels);
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    Setting setting;
    std::string only;
    for (int i = 1; i + 1 < argc; i += 2) {
        const std::string option = argv[i];
        const double value = std::atof(argv[i + 1]);
        if (option == "--seeds") {
            setting.seeds = static_cast<int>(value);
        } else if (option == "--error") {
            setting.error = value;
        } else if (option == "--truth") {
            setting.truth_spp = static_cast<int>(value);
        } else if (option == "--threads") {
            setting.threads = static_cast<int>(value);
        } else if (option == "--scene") {
            only = argv[i + 1];
        }
    }
    if (argc % 2 == 0) {
        fmt::print(stderr, "lancer_coverage [--seeds N] [--error SHARE] [--truth SAMPLES] [--threads N] [--scene NAME]\n");
        return 2;
    }
    fmt::print(
        "| scene | | truth inside, where {:g} % is claimed | worst seed | known within {:g} % | heavy tails | samples a pixel "
        "|\n|---|---|---|---|---|---|---|\n",
        100.0 * setting.confidence, 100.0 * setting.error);
    for (const Subject& subject : subjects) {
        if (only.empty() || only == subject.name) {
            measure(subject, setting);
        }
    }
    return 0;
}
