#include "lancer/app/cli/render_job.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <utility>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "lancer/app/cli/checkpoints.h"
#include "lancer/app/cli/command_line.h"
#include "lancer/app/cli/film_about.h"
#include "lancer/app/cli/frames.h"
#include "lancer/app/cli/import_arguments.h"
#include "lancer/app/cli/interrupt.h"
#include "lancer/app/cli/outputs.h"
#include "lancer/app/cli/previews.h"
#include "lancer/app/cli/progress.h"
#include "lancer/app/cli/render_report.h"
#include "lancer/app/exit_status.h"
#include "lancer/app/prepare.h"
#include "lancer/base/failure.h"
#include "lancer/image/replace_file.h"
#include "lancer/import/import.h"
#include "lancer/scene/integrator.h"

namespace lancer::app {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

void print_aovs() {
    for (const AovKind& kind : aov_kinds()) {
        fmt::print("{:<12} {:<22} {}\n", kind.name, kind.channels, kind.help);
    }
}

// What only EXR files can hold needs one.
void check_contents(const RenderJob& job, const PictureContents& contents, Diagnostics& diagnostics) {
    const bool has_more = !contents.aovs.empty() || contents.spectral_bins > 0;
    if (!has_more ||
        std::any_of(job.outputs.begin(), job.outputs.end(), [](const std::string& path) { return holds_layers(path) || is_film(path); })) {
        return;
    }
    const std::string sentence = "only EXR files hold AOVs and spectra, and none is written: name one, such as -o picture.exr";
    if (!job.render.aovs.empty() || job.render.spectral_bins) {
        diagnostics.error({}, sentence);
    } else {
        diagnostics.warning({}, sentence);
    }
}

// The files that the job writes pictures and films to.
struct Outputs {
    std::vector<std::string> pictures;
    std::vector<std::string> films;

    // The one that the checkpoint belongs to.
    std::string first;
};

Outputs outputs_of(const RenderJob& job, Diagnostics& diagnostics) {
    Outputs outputs;
    if (job.shard) {  // a share of a picture is no picture
        outputs.first = shard_path(job.outputs.front(), job.shard->shard, job.shard->shards);
        outputs.films = {outputs.first};
    } else {
        outputs.first = job.outputs.front();
        for (const std::string& path : job.outputs) {
            (is_film(path) ? outputs.films : outputs.pictures).push_back(path);
        }
    }
    check_pictures(outputs.pictures, "-o", diagnostics);
    for (const std::string& path : outputs.films) {
        check_file(path, "-o", diagnostics);
    }
    return outputs;
}

// Puts what was begun into the state, if it is of the same picture.
void go_on_with(const Begun& begun, const FilmAbout& about, FilmState& state, Diagnostics& diagnostics) {
    for (const std::string& difference : differences(begun.metadata, about.texts)) {
        diagnostics.error({}, fmt::format("{} can't be gone on with: {}", begun.name, difference));
    }
    if (diagnostics.has_errors() || begun.film == nullptr) {
        return;
    }
    if (!(begun.film->shape() == shape_of(state))) {
        diagnostics.error({}, fmt::format("{} can't be gone on with: its size or what it holds beside the picture is another", begun.name));
        return;
    }
    begun.film->add_to(state);
    state.show_splats();
}

// One job, from the scene's file to the last line that is said.
class Run {
public:
    Run(RenderJob job, std::optional<Begun> begun) : job_(std::move(job)), begun_(std::move(begun)) {}

    int run() {
        const std::atomic<bool>& interrupted = interrupt_flag();
        if (!prepare_all()) {
            return exit_bad_input;
        }
        remove_leftovers(outputs_.first);
        Film film(prepared_->options.width, prepared_->options.height);
        std::optional<FilmSums> sums;
        if (prepared_->options.spp > 0) {
            FilmLayers layers = layers_for(prepared_->contents);
            layers.splats = prepared_->device->makes_splats();
            sums.emplace(film.width, film.height, layers);
        }
        FilmState state(film, sums ? &*sums : nullptr, tile_size_for(prepared_->options));
        const FilmAbout about = about_film(*prepared_, words_of(job_));
        if (begun_) {
            Diagnostics diagnostics;
            go_on_with(*begun_, about, state, diagnostics);
            print_diagnostics(diagnostics, job_.quiet);
            if (diagnostics.has_errors()) {
                return exit_bad_input;
            }
            begun_->film.reset();
        }

        std::optional<Checkpoints> checkpoints;
        if (job_.checkpoint.value_or(1.0) > 0.0) {
            const CheckpointTimes times = job_.checkpoint ? CheckpointTimes{*job_.checkpoint, *job_.checkpoint} : CheckpointTimes{};
            checkpoints.emplace(begun_ ? begun_->output : outputs_.first, about, state, times);
        }
        std::optional<Previews> previews;
        if (job_.preview) {
            previews.emplace(*job_.preview, state, *prepared_);
        }
        const ProgressStyle style = choose_progress(job_.progress, job_.quiet);
        if (prepared_->scene.settings.integrator == "auto" && scene::follows_paths(prepared_->scene) && !job_.quiet &&
            style != ProgressStyle::json) {
            const scene::IntegratorChoice choice = scene::choose_integrator(prepared_->scene);
            fmt::print("Light is followed by {}, because {}\n", choice.name, choice.why);
        }
        RenderProgressPrinter printer(style, job_.files.front());
        FrameProgress progress(printer, job_.part);
        std::optional<ProgressFile> progress_file;
        if (job_.progress_file) {
            progress_file.emplace(*job_.progress_file, progress);
        }
        RenderObserver& observer = progress_file ? static_cast<RenderObserver&>(*progress_file) : progress;
        const std::clock_t processor_start = std::clock();
        const RenderStatistics done = render(*prepared_->device, prepared_->options, state, &observer, &interrupted);
        progress_file.reset();
        printer.clear();
        previews.reset();
        times_.render = done.seconds;
        times_.processor = static_cast<double>(std::clock() - processor_start) / CLOCKS_PER_SEC;
        report_bad_samples(done.bad_samples, *prepared_->world);
        report_bad_pixels(done);

        const auto write_start = Clock::now();
        const int count = checkpoints ? checkpoints->stop() : 0;
        if (!done.finished) {
            prepared_->metadata["lancer:unfinished"] = "stopped before its goal";
        }
        write_outputs(state, about, done.finished);
        if (checkpoints) {
            keep(*checkpoints, done.finished, count);
        }
        times_.write = seconds_since(write_start);
        say(style, done);
        return !complete_ ? exit_machine_failed : done.finished ? exit_done : exit_stopped;
    }

private:
    // Whatever is wrong is said before anything is rendered or written.
    bool prepare_all() {
        const std::string& file = job_.files.front();
        Diagnostics diagnostics;
        outputs_ = outputs_of(job_, diagnostics);
        if (job_.sample_map) {
            check_pictures({*job_.sample_map}, "--sample-map", diagnostics);
        }
        if (job_.stats) {
            check_file(*job_.stats, "--stats", diagnostics);
        }
        if (job_.preview) {
            check_pictures({*job_.preview}, "--preview", diagnostics);
        }
        if (job_.progress_file) {
            check_file(*job_.progress_file, "--progress-file", diagnostics);
        }
        const auto load_start = Clock::now();
        ImportReport report;
        std::optional<scene::Scene> scene = import_scene(file, job_.render.import, report, diagnostics);
        tell_report(report, file, diagnostics);
        if (scene && job_.only_if && scene->hash != *job_.only_if) {
            diagnostics.error({}, fmt::format("{}, or a file that it reads, is not what it was: its hash is {}, and {} was asked for", file,
                                              scene->hash, *job_.only_if));
        }
        times_.load = seconds_since(load_start);
        const auto prepare_start = Clock::now();
        if (scene && asks_for_errors() && scene->settings.integrator == "auto" && !job_.render.integrator &&
            scene::starts_at_lamps(scene::chosen_integrator(*scene))) {
            scene->settings.integrator = "path";  // the next best whose errors can be told
        }
        if (scene && !diagnostics.has_errors()) {
            prepared_ = prepare(std::move(*scene), job_.render, render_command(file, job_.render), diagnostics);
        }
        times_.prepare = seconds_since(prepare_start);
        if (prepared_) {
            check_contents(job_, prepared_->contents, diagnostics);
            if (prepared_->device->makes_splats() && asks_for_errors()) {
                diagnostics.error({}, fmt::format("--integrator {} follows light from the lamps, which falls anywhere: "
                                                  "stated errors and --clamp are for --integrator path",
                                                  scene::chosen_integrator(prepared_->scene)));
            }
            if (job_.shard) {
                prepared_->options.shard = job_.shard->shard;
                prepared_->options.shards = job_.shard->shards;
            }
        }
        print_diagnostics(diagnostics, job_.quiet);
        return prepared_ && !diagnostics.has_errors();
    }

    bool asks_for_errors() const { return job_.render.error || job_.render.clamp; }

    // What has gone through checkpoints stays open for more samples.
    void keep(Checkpoints& checkpoints, bool finished, int count) {
        if (finished && complete_) {
            if (!outputs_.films.empty() || !job_.keeps_film) {  // the film itself does as well
                checkpoints.remove();
                return;
            }
            if (count == 0 && !job_.checkpoint && !begun_) {
                return;  // a matter of seconds
            }
        }
        if (!checkpoints.write(!finished)) {
            complete_ = complete_ && finished;  // the picture is there, and that is what was asked for
        } else if (finished) {
            checkpoints.remove_before();
        }
    }

    // Writes what can be written, even after one file failed.
    void write_outputs(const FilmState& state, const FilmAbout& about, bool finished) {
        const FilmSums* sums = prepared_->contents.is_plain() ? nullptr : state.sums();
        for (const std::string& path : outputs_.pictures) {
            attempt(path, [&] { write_film(path, state.film(), *prepared_, sums); });
        }
        for (const std::string& path : outputs_.films) {
            if (finished) {  // until then, the checkpoint is all
                attempt(path, [&] { write_film_file(path, about, state); });
            }
        }
        if (job_.sample_map) {
            attempt(*job_.sample_map, [&] { write_sample_map(*job_.sample_map, state.film(), prepared_->metadata); });
        }
    }

    template <class Write>
    void attempt(const std::string& path, const Write& write) {
        try {
            write();
            written_.push_back(path);
        } catch (const MachineFailure& failure) {
            fmt::print(stderr, "lancer: error: {}\n", failure.what());
            complete_ = false;
        }
    }

    void say(ProgressStyle style, const RenderStatistics& done) {
        if (job_.stats) {
            const std::vector<std::string> pictures = written_;
            attempt(*job_.stats, [&] { replace_file(*job_.stats, statistics_as_json(*prepared_, done, times_, pictures, 2) + "\n"); });
            written_ = pictures;
        }
        if (style == ProgressStyle::json) {
            fmt::print(stderr, "{{\"event\":\"done\",\"statistics\":{}}}\n", statistics_as_json(*prepared_, done, times_, written_, -1));
        } else if (!job_.quiet) {
            fmt::print("{}\n", summary(*prepared_, done, times_, written_));
        }
    }

    RenderJob job_;
    std::optional<Begun> begun_;
    Outputs outputs_;
    Times times_;
    std::optional<Prepared> prepared_;
    std::vector<std::string> written_;
    bool complete_ = true;  // everything that was to be written was
};

}  // namespace

std::optional<std::string> sort_files(RenderJob& job) {
    std::vector<std::string> scenes;
    for (const std::string& file : job.files) {
        if ((is_picture(file) || is_film(file)) && !job.outputs.empty()) {
            job.outputs.push_back(file);
        } else {
            scenes.push_back(file);
        }
    }
    if (scenes.empty()) {
        return "which scene? For example: lancer render scene.toml -o picture.png";
    }
    if (scenes.size() > 1) {
        return fmt::format("one scene at a time, not {}", fmt::join(scenes, " and "));
    }
    if (job.outputs.empty()) {
        return fmt::format("where shall the picture go? For example: -o picture.png");
    }
    job.files = scenes;
    return std::nullopt;
}

void check_outputs(const RenderJob& job, Diagnostics& diagnostics) { outputs_of(job, diagnostics); }

int run_render_job(const CLI::App& app, RenderJob job, std::optional<Begun> begun) {
    if (job.render.aovs == std::vector<std::string>{"list"}) {
        print_aovs();
        return exit_done;
    }
    if (const auto sentence = sort_files(job)) {
        return refuse(*sentence, app);
    }
    if (job.frames || job.fps) {
        return run_frames(app, job);
    }
    return Run(std::move(job), std::move(begun)).run();
}

}  // namespace lancer::app
