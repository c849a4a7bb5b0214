#include "lancer/app/figures/figures.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "lancer/app/cli/command_line.h"
#include "lancer/app/cli/interrupt.h"
#include "lancer/app/cli/outputs.h"
#include "lancer/app/cli/progress.h"
#include "lancer/app/cli/spelling.h"
#include "lancer/app/embedded_scenes.h"
#include "lancer/app/exit_status.h"
#include "lancer/app/figures/page.h"
#include "lancer/app/figures/speedup_plot.h"
#include "lancer/app/prepare.h"
#include "lancer/app/smaller_film.h"
#include "lancer/app/speedup.h"
#include "lancer/base/failure.h"
#include "lancer/image/replace_file.h"
#include "lancer/import/import.h"

namespace lancer::app {

namespace fs = std::filesystem;

namespace {

constexpr int tries = 3;  // of each timing
constexpr const char* speedup_id = "threads";

// How far the whole is, in seconds of work that were estimated beforehand.
class Overall : public RenderObserver {
public:
    Overall(ProgressStyle style, double total) : printer_(style, "figures"), total_(total) {}

    void begin(double work) {
        done_ += current_;
        current_ = work;
        show(0.0);
    }
    void tile_done(const Film&, const Tile&, const RenderProgress& progress) override { show(progress.share); }
    void clear() { printer_.clear(); }
    double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

private:
    void show(double share_of_current) {
        const double share = std::clamp((done_ + share_of_current * current_) / total_, 1e-6, 1.0);
        printer_.show(share, seconds(), seconds() * (1.0 - share) / share, "");
    }

    ProgressPrinter printer_;
    double total_;
    double done_ = 0.0;
    double current_ = 0.0;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// A figure that is ready to be rendered.
struct Job {
    const Figure* figure = nullptr;
    Prepared prepared;
    double seconds = 0.0;  // estimated
};

// Seconds that it will take, from a coarse look: scenes differ a thousandfold.
double estimate_seconds(const Prepared& prepared) {
    constexpr int factor = 8;
    constexpr double adaptive_samples = 6.0;  // a pixel, as costly as they are at edges
    constexpr double overhead = 0.05;         // of writing the file
    const RenderOptions& options = prepared.options;
    const double samples = options.spp > 0    ? static_cast<double>(options.spp)
                           : options.adaptive ? adaptive_samples
                                              : static_cast<double>(options.ssaa) * options.ssaa;
    return overhead + render_preview(prepared, factor, &interrupt_flag()).statistics.seconds * factor * factor * samples;
}

RenderArguments read_options(const Figure& figure, const std::optional<int>& threads) {
    CLI::App app;
    RenderArguments arguments;
    add_render_options(app, arguments);
    std::vector<std::string> reversed(figure.options.rbegin(), figure.options.rend());
    app.parse(std::move(reversed));
    arguments.threads = threads;
    return arguments;
}

void check_folder(const std::string& folder, Diagnostics& diagnostics) {
    std::error_code ignored;
    if (fs::is_directory(folder, ignored)) {
        if (access(folder.c_str(), W_OK | X_OK) != 0) {
            diagnostics.error({}, fmt::format("no permission to write in the folder {}", folder));
        }
    } else if (fs::exists(folder, ignored)) {
        diagnostics.error({}, fmt::format("{} is not a folder", folder));
    } else {
        check_file(folder, "the folder", diagnostics);
    }
}

void make_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) {
        throw MachineFailure(fmt::format("the folder {} could not be made: {}", folder.string(), error.message()));
    }
}

Film enlarge(const Film& film, const Enlargement& part) {
    Film result(part.width * part.factor, part.height * part.factor);
    for (int y = 0; y < result.height; ++y) {
        for (int x = 0; x < result.width; ++x) {
            const std::size_t from = film.index(part.x + x / part.factor, part.y + y / part.factor);
            result.radiance[result.index(x, y)] = film.radiance[from];
            result.samples[result.index(x, y)] = film.samples[from];
        }
    }
    return result;
}

bool is_wanted(const FiguresRequest& request, const std::string& id) {
    return request.only.empty() || std::find(request.only.begin(), request.only.end(), id) != request.only.end();
}

void check_names(const std::vector<std::string>& names, Diagnostics& diagnostics) {
    std::vector<std::string> known = {speedup_id};
    for (const FigureGroup& group : figure_table()) {
        for (const Figure& figure : group.figures) {
            known.push_back(figure.id);
        }
    }
    for (const std::string& name : names) {
        if (std::find(known.begin(), known.end(), name) == known.end()) {
            const std::string hint = did_you_mean(name, known);
            diagnostics.error({}, fmt::format("--only: there is no figure \"{}\"{}; there are {}", name, hint.empty() ? "" : ":" + hint,
                                              fmt::join(known, ", ")));
        }
    }
}

// Null when there are errors.
std::optional<Job> prepare_figure(const Figure& figure, const FiguresRequest& request, Diagnostics& diagnostics) {
    const RenderArguments arguments = read_options(figure, request.threads);
    std::optional<scene::Scene> scene = import_scene((fs::path(request.folder) / figure.scene).string(), diagnostics);
    if (!scene) {
        return std::nullopt;
    }
    scene->file = figure.scene;  // what stands in the pictures does not depend on the folder
    for (scene::InputFile& input : scene->inputs) {
        input.path = fs::path(input.path).lexically_relative(request.folder).generic_string();
    }
    std::optional<Prepared> prepared = prepare(std::move(*scene), arguments, render_command(figure.scene, arguments), diagnostics);
    if (!prepared) {
        return std::nullopt;
    }
    const double seconds = estimate_seconds(*prepared);
    return Job{&figure, std::move(*prepared), seconds};
}

std::optional<std::vector<Job>> prepare_all(const FiguresRequest& request, Diagnostics& diagnostics) {
    std::vector<Job> jobs;
    for (const FigureGroup& group : figure_table()) {
        for (const Figure& figure : group.figures) {
            if (is_wanted(request, figure.id)) {
                std::optional<Job> job = prepare_figure(figure, request, diagnostics);
                if (!job) {
                    return std::nullopt;
                }
                jobs.push_back(std::move(*job));
            }
        }
    }
    return jobs;
}

// False when it was interrupted.
bool render_figure(const Job& job, const fs::path& folder, Overall& overall) {
    const Prepared& prepared = job.prepared;
    Film film(prepared.options.width, prepared.options.height);
    overall.begin(job.seconds);
    if (!render(*prepared.device, prepared.options, film, &overall, &interrupt_flag()).finished) {
        return false;
    }
    const Figure& figure = *job.figure;
    const auto file = [&](const std::string& suffix) { return (folder / (figure.id + suffix + ".png")).string(); };
    write_film(file(""), film, prepared);
    if (figure.enlarged) {
        write_film(file("-enlarged"), enlarge(film, *figure.enlarged), prepared);
    }
    if (figure.sample_map) {
        write_sample_map(file("-samples"), film, prepared.metadata);
    }
    return true;
}

int stopped(Overall& overall, const std::string& folder) {
    overall.clear();
    fmt::print("Stopped; the figures that were done are in {}\n", folder);
    return exit_stopped;
}

}  // namespace

std::string figure_command(const Figure& figure) {
    std::vector<std::string> words = {"lancer", "render", figure.scene};
    words.insert(words.end(), figure.options.begin(), figure.options.end());
    words.insert(words.end(), {"-o", figure.id + ".png"});
    if (figure.sample_map) {
        words.insert(words.end(), {"--sample-map", figure.id + "-samples.png"});
    }
    return shell_quoted(words);
}

int write_figures(const FiguresRequest& request) {
    Diagnostics diagnostics;
    check_names(request.only, diagnostics);
    check_folder(request.folder, diagnostics);
    if (diagnostics.has_errors()) {
        print_diagnostics(diagnostics);
        return exit_bad_input;
    }
    const fs::path root(request.folder);
    for (const EmbeddedFile& file : embedded_scenes()) {
        const fs::path path = root / file.path;
        make_folder(path.parent_path());
        replace_file(path.string(), file.bytes);
    }
    const std::optional<std::vector<Job>> jobs = prepare_all(request, diagnostics);
    std::optional<Job> timed;  // the first figure, which is Figure 1
    if (is_wanted(request, speedup_id)) {
        timed = prepare_figure(figure_table().front().figures.front(), request, diagnostics);
    }
    print_diagnostics(diagnostics, true);
    if (diagnostics.has_errors()) {
        return exit_bad_input;
    }

    const std::vector<int> counts = timed ? thread_counts(hardware_threads()) : std::vector<int>();
    const auto timing_seconds = [&](int count) {
        return timed->seconds * std::min(timed->prepared.options.threads, hardware_threads()) / count;
    };
    double total = 0.0;
    for (const Job& job : *jobs) {
        total += job.seconds;
    }
    for (const int count : counts) {
        total += tries * timing_seconds(count);
    }

    Overall overall(choose_progress(request.progress, request.quiet), total);
    for (const Job& job : *jobs) {
        if (!render_figure(job, root, overall)) {
            return stopped(overall, request.folder);
        }
    }
    std::vector<Timing> timings;
    if (timed) {
        timings = time_threads(
            timed->prepared, counts, tries, [&](int count) { overall.begin(timing_seconds(count)); }, interrupt_flag());
        if (timings.size() < counts.size()) {
            return stopped(overall, request.folder);
        }
        const Drawing plot = plot_speedup(timings);
        replace_file((root / "threads.svg").string(), to_svg(plot));
        write_image((root / "threads.png").string(), paint(plot), {{"Software", "lancer " LANCER_VERSION}});
    }
    replace_file((root / "index.html").string(),
                 figures_page([&](const Figure& figure) { return is_wanted(request, figure.id); }, timings));

    const double seconds = overall.seconds();
    overall.clear();
    if (!request.quiet) {
        const std::size_t count = jobs->size() + (timed ? 1 : 0);
        fmt::print("{} {} written in {}: open {}\n", count, count == 1 ? "figure" : "figures", in_words(seconds),
                   (root / "index.html").string());
    }
    return exit_done;
}

}  // namespace lancer::app
