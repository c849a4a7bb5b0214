// lancer reproduce PICTURE
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "lancer/app/cli/command_line.h"
#include "lancer/app/cli/picture_words.h"
#include "lancer/app/cli/render_job.h"
#include "lancer/app/cli/values.h"
#include "lancer/app/exit_status.h"
#include "lancer/base/failure.h"
#include "lancer/image/exact.h"
#include "lancer/image/layers.h"

namespace lancer::app {

namespace {

struct Arguments {
    std::optional<std::string> picture;
    std::optional<std::string> output;
    std::optional<int> threads;
    std::optional<std::string> progress;
};

// A file that is gone in the end, with the ending of `like`.
class PassingFile {
public:
    explicit PassingFile(const std::string& like)
        : path_((std::filesystem::temp_directory_path() /
                 fmt::format("lancer-again-{}{}", ::getpid(), std::filesystem::path(like).extension().string()))
                    .string()) {}
    ~PassingFile() {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
    }
    PassingFile(const PassingFile&) = delete;
    PassingFile& operator=(const PassingFile&) = delete;
    const std::string& path() const { return path_; }

private:
    std::string path_;
};

int reproduce(const CLI::App& app, const Arguments& arguments) {
    if (!arguments.picture) {
        return refuse("which picture? For example: lancer reproduce out.exr", app);
    }
    const std::string& picture = *arguments.picture;
    std::optional<PictureWords> found = words_of_picture(picture);
    if (!found) {
        return exit_bad_input;
    }
    std::optional<RenderJob> job = job_of_words(found->words);
    if (!job) {
        fmt::print(stderr, "lancer reproduce: error: {} was made by a command that this lancer does not understand\n", picture);
        return exit_bad_input;
    }
    if (job->render.seconds) {
        fmt::print(stderr, "lancer reproduce: error: {} was ended by the time it took (--time), which is never the same twice\n", picture);
        return exit_bad_input;
    }
    const PassingFile passing(picture);
    const std::string& again = arguments.output ? *arguments.output : passing.path();
    job->outputs = {again};
    job->checkpoint = 0.0;
    job->quiet = true;
    job->progress = arguments.progress;
    job->render.threads = arguments.threads;
    Begun begun;
    begun.name = picture;
    begun.metadata = std::move(found->metadata);
    const int status = run_render_job(app, std::move(*job), std::move(begun));
    if (status != exit_done) {
        return status;
    }
    const std::string difference = exact_difference(read_layers(picture), picture, read_layers(again), again);
    if (difference.empty()) {
        fmt::print("{} is reproduced: the pixels are the same to the last bit.\n", picture);
        return exit_done;
    }
    fmt::print("{} is not reproduced: {}.\n", picture, difference);
    return exit_stopped;
}

}  // namespace

void add_reproduce(CLI::App& program, Work& work) {
    CLI::App* app = program.add_subcommand("reproduce", "Render a picture again from what it says of itself, and compare");
    const auto arguments = std::make_shared<Arguments>();
    add_positional(*app, "PICTURE", arguments->picture, "A picture that lancer wrote");
    add_text(*app, "-o,--output", arguments->output, "FILE", "Keep what is rendered");
    add_threads_option(*app, arguments->threads);
    add_choice(*app, "--progress", arguments->progress, {"bar", "plain", "json"}, "How progress is told, on standard error");
    app->footer(
        "Exit status: 0 the same pixels, 1 others, 2 its scene, textures, seed or version are not what they were.\n\n"
        "Example:\n  lancer reproduce out.exr");
    app->callback([app, arguments, &work] { work = [app, arguments] { return reproduce(*app, *arguments); }; });
}

}  // namespace lancer::app
