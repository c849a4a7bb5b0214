// lancer resume PICTURE
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "lancer/app/cli/checkpoints.h"
#include "lancer/app/cli/command_line.h"
#include "lancer/app/cli/film_about.h"
#include "lancer/app/cli/picture_words.h"
#include "lancer/app/cli/render_job.h"
#include "lancer/app/cli/values.h"
#include "lancer/app/exit_status.h"
#include "lancer/base/failure.h"

namespace lancer::app {

namespace {

struct Arguments {
    std::optional<std::string> picture;
    std::optional<int> spp;
    std::optional<double> error;
    std::optional<double> seconds;
    std::optional<int> threads;
    std::optional<std::string> progress;
    std::optional<std::string> progress_file;
    std::optional<std::string> stats;
    std::optional<std::string> checkpoint;
    bool quiet = false;
};

std::vector<std::string> words_of(const Arguments& arguments) {
    std::vector<std::string> words;
    const auto add = [&](const char* name, const auto& value) {
        if (value) {
            words.insert(words.end(), {name, fmt::format("{}", *value)});
        }
    };
    add("--spp", arguments.spp);
    add("--error", arguments.error);
    add("--time", arguments.seconds);
    add("--threads", arguments.threads);
    add("--progress", arguments.progress);
    add("--progress-file", arguments.progress_file);
    add("--stats", arguments.stats);
    add("--checkpoint", arguments.checkpoint);
    if (arguments.quiet) {
        words.push_back("--quiet");
    }
    return words;
}

int resume(const CLI::App& app, const Arguments& arguments) {
    if (!arguments.picture) {
        return refuse("which picture? For example: lancer resume out.exr", app);
    }
    const std::string& picture = *arguments.picture;
    Begun begun;
    begun.film = find_film(picture);
    std::vector<std::string> words;
    std::string folder;
    if (begun.film != nullptr) {
        begun.name = begun.film->path();
        begun.metadata = begun.film->about().texts;
        words = begun.film->about().list("words");
        folder = begun.film->about().text("film:folder");
    } else {
        begun.name = picture;
        std::optional<PictureWords> found = words_of_picture(picture);
        if (!found) {
            return exit_bad_input;
        }
        begun.metadata = std::move(found->metadata);
        words = std::move(found->words);
        words.insert(words.end(), {"-o", picture});
        fmt::print(stderr, "lancer: note: the film of {} was not kept; it is rendered from the beginning\n", picture);
    }
    const std::vector<std::string> more = words_of(arguments);
    words.insert(words.end(), more.begin(), more.end());
    std::optional<RenderJob> job = job_of_words(words);
    if (!job) {
        fmt::print(stderr, "lancer resume: error: {} was made by a command that this lancer does not understand\n", begun.name);
        return exit_bad_input;
    }
    std::error_code ignored;
    begun.output = std::filesystem::absolute(picture, ignored).lexically_normal().string();
    if (!folder.empty() && std::filesystem::is_directory(folder, ignored)) {
        std::filesystem::current_path(folder, ignored);  // names on that command line are seen from there
    }
    // What was moved stays where it is now.
    const bool is_there = std::any_of(job->outputs.begin(), job->outputs.end(), [&](const std::string& output) {
        const std::string path = job->shard ? shard_path(output, job->shard->shard, job->shard->shards) : output;
        return std::filesystem::absolute(path, ignored).lexically_normal() == begun.output;
    });
    if (!is_there) {
        job->outputs = {begun.output};
    }
    return run_render_job(app, std::move(*job), std::move(begun));
}

}  // namespace

void add_resume(CLI::App& program, Work& work) {
    CLI::App* app = program.add_subcommand("resume", "Go on with a picture that was stopped, or give a finished one more samples");
    const auto arguments = std::make_shared<Arguments>();
    add_positional(*app, "PICTURE", arguments->picture, "The picture or film, as it was named after -o");
    add_whole(*app, "--spp", arguments->spp, 1, 1 << 20, "So many samples a pixel in all");
    add_percentage(*app, "--error", arguments->error,
                   "Until the picture is known so well; for pictures that were begun with --error or with intervals");
    add_duration(*app, "--time", arguments->seconds, "So long from now on");
    add_threads_option(*app, arguments->threads);
    add_choice(*app, "--progress", arguments->progress, {"bar", "plain", "json"}, "How progress is told, on standard error");
    add_text(*app, "--progress-file", arguments->progress_file, "FILE", "A file that says how far the render is, as a share from 0 to 1");
    add_text(*app, "--stats", arguments->stats, "FILE", "Numbers about the render, as JSON");
    add_text(*app, "--checkpoint", arguments->checkpoint, "TIME", "How often the film is saved beside the picture; \"off\": never");
    app->add_flag("--quiet", arguments->quiet, "Say nothing but warnings and errors");
    app->footer("Example:\n  lancer resume out.exr\n  lancer resume out.exr --spp 1024");
    app->callback([app, arguments, &work] { work = [app, arguments] { return resume(*app, *arguments); }; });
}

}  // namespace lancer::app
