#include "lancer/app/cli/frames.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "lancer/app/cli/checkpoints.h"
#include "lancer/app/cli/command_line.h"
#include "lancer/app/cli/film_about.h"
#include "lancer/app/cli/interrupt.h"
#include "lancer/app/cli/progress.h"
#include "lancer/app/cli/values.h"
#include "lancer/app/exit_status.h"
#include "lancer/app/frames/frame_done.h"
#include "lancer/app/prepare.h"
#include "lancer/import/import.h"

namespace lancer::app {

namespace {

RenderJob job_of_frame(const RenderJob& job, int frame) {
    RenderJob one = job;
    one.frames.reset();
    one.fps.reset();
    one.keeps_film = false;  // each is as large as several pictures
    one.render.import.frame = moment_of(frame, job.fps.value_or(usual_fps));
    for (std::string& output : one.outputs) {
        output = numbered(output, frame);
    }
    for (std::optional<std::string>* file : {&one.sample_map, &one.stats}) {
        if (*file) {
            *file = numbered(**file, frame);
        }
    }
    return one;
}

// Which frames are there already. The scene is read, once, when the first file turns up.
class Done {
public:
    explicit Done(const RenderJob& job) : scene_(job.files.front()) {}

    bool has(const RenderJob& one) {
        return std::all_of(one.outputs.begin(), one.outputs.end(), [&](const std::string& output) {
            const std::string file = file_of(one, output);
            return is_there(file) && is_frame_done(file, facts_of(one));
        });
    }

    // What a frame that was stopped can go on with.
    std::optional<Begun> begun(const RenderJob& one) {
        const std::string file = file_of(one, one.outputs.front());
        if (!is_there(checkpoint_path(file)) && !is_there(checkpoint_before_path(file))) {
            return std::nullopt;
        }
        std::unique_ptr<const FilmFile> film = find_film(file);
        if (film == nullptr || !says(film->about().texts, facts_of(one))) {
            return std::nullopt;
        }
        Begun begun;
        begun.name = film->path();
        begun.metadata = film->about().texts;
        begun.output = file;
        begun.film = std::move(film);
        return begun;
    }

    static void remove_checkpoints(const RenderJob& one) {
        std::error_code ignored;
        const std::string file = file_of(one, one.outputs.front());
        std::filesystem::remove(checkpoint_path(file), ignored);
        std::filesystem::remove(checkpoint_before_path(file), ignored);
    }

private:
    static bool is_there(const std::string& path) {
        std::error_code ignored;
        return std::filesystem::exists(path, ignored);
    }

    static std::string file_of(const RenderJob& one, const std::string& output) {
        return one.shard ? shard_path(output, one.shard->shard, one.shard->shards) : output;
    }

    FrameFacts facts_of(const RenderJob& one) { return {render_command(scene_, one.render), hash(one.render.import)}; }

    const std::string& hash(const ImportOptions& options) {
        if (!hash_) {
            Diagnostics ignored;  // rendering tells them
            ImportReport report;
            const std::optional<scene::Scene> scene = import_scene(scene_, options, report, ignored);
            hash_ = scene ? scene->hash : "";
        }
        return *hash_;
    }

    std::string scene_;
    std::optional<std::string> hash_;
};

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

void add_frame_range(CLI::App& app, std::optional<FrameRange>& frames, const std::string& description) {
    const auto read = [&frames](const std::string& text) {
        frames = read_frame_range(text);
        if (!frames) {
            throw CLI::ValidationError(
                "--frames",
                fmt::format("expected FIRST:LAST or FIRST:LAST:STEP with whole numbers, as 0:240 or 10:100:5, not \"{}\"", text));
        }
    };
    app.add_option_function<std::string>("--frames", read, description)
        ->type_name("A:B[:STEP]")
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast)
        ->group("Animation");
}

void add_fps(CLI::App& app, std::optional<double>& fps) {
    add_real(app, "--fps", fps, 0.001, 100000.0, "Frames a second; 24 if not given")->group("Animation");
}

std::optional<std::string> check_frames(const RenderJob& job) {
    if (!job.frames) {
        return job.fps ? std::optional<std::string>("--fps goes with --frames") : std::nullopt;
    }
    if (job.render.import.frame != 0.0) {
        return "--frame is one moment, in seconds, and --frames many frames: one of them at a time";
    }
    const auto needs_number = [](const char* option, const std::string& path) {
        return fmt::format("{} {}: each frame needs a file of its own; # stands for its number, as frame.####.exr", option, path);
    };
    for (const std::string& output : job.outputs) {
        if (!has_number_sign(output) && job.frames->count() > 1) {
            return needs_number("-o", output);
        }
    }
    for (const auto& [option, file] : {std::pair("--sample-map", &job.sample_map), std::pair("--stats", &job.stats)}) {
        if (*file && !has_number_sign(**file) && job.frames->count() > 1) {
            return needs_number(option, **file);
        }
    }
    return std::nullopt;
}

int run_frames(const CLI::App& app, const RenderJob& job) {
    if (const auto sentence = check_frames(job)) {
        return refuse(*sentence, app);
    }
    const std::atomic<bool>& interrupted = interrupt_flag();
    const auto start = std::chrono::steady_clock::now();
    const int all = job.frames->count();
    Done done(job);
    std::vector<int> wanted;
    for (int i = 0; i < all; ++i) {
        const int frame = job.frames->number(i);
        if (!done.has(job_of_frame(job, frame))) {
            wanted.push_back(frame);
        }
    }
    const bool tells = !job.quiet && job.progress != "json";
    const int skipped = all - static_cast<int>(wanted.size());
    if (tells && skipped > 0) {
        fmt::print("{} of {} frames {} done already\n", skipped, all, skipped == 1 ? "is" : "are");
    }
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        RenderJob one = job_of_frame(job, wanted[i]);
        one.part = {skipped + static_cast<int>(i), all, skipped, seconds_since(start)};
        std::optional<Begun> begun = done.begun(one);
        const int status = run_render_job(app, one, std::move(begun));
        if (status != exit_done || interrupted) {
            return status;
        }
        Done::remove_checkpoints(one);
    }
    if (tells && all > 1) {
        fmt::print("{} {} in {}\n", all, all == 1 ? "frame" : "frames", in_words(seconds_since(start)));
    }
    return exit_done;
}

}  // namespace lancer::app
