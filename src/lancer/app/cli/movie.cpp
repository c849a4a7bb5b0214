// lancer movie FRAMES -o film.mp4
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "lancer/app/cli/command_line.h"
#include "lancer/app/cli/frames.h"
#include "lancer/app/cli/interrupt.h"
#include "lancer/app/cli/outputs.h"
#include "lancer/app/cli/progress.h"
#include "lancer/app/cli/values.h"
#include "lancer/app/exit_status.h"
#include "lancer/app/frames/frame_range.h"
#include "lancer/app/frames/movie.h"
#include "lancer/base/failure.h"
#include "lancer/base/file.h"
#include "lancer/image/view.h"

namespace lancer::app {

namespace {

struct Arguments {
    std::vector<std::string> pictures;
    std::optional<std::string> output;
    std::optional<FrameRange> frames;
    std::optional<double> fps;
    std::optional<std::string> view;
    std::optional<double> exposure;
    std::optional<std::string> progress;
    bool quiet = false;
};

// "3, 5, 7 and 120 more" of the numbers.
std::string list(const std::vector<int>& numbers) {
    constexpr std::size_t most = 10;
    const std::size_t shown = std::min(numbers.size(), most);
    const std::string text = fmt::format("{}", fmt::join(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(shown), ", "));
    return numbers.size() > most ? fmt::format("{} and {} more", text, numbers.size() - most) : text;
}

// The pictures of `frame.####.exr`, or a sentence. Without a range: those that are there, which must be evenly spaced.
std::optional<std::string> expand(const std::string& pattern, const std::optional<FrameRange>& range, std::vector<std::string>& pictures) {
    const std::vector<int> there = frames_there(pattern);
    if (there.empty()) {
        return fmt::format("there are no frames {}", pattern);
    }
    FrameRange wanted = range.value_or(FrameRange{there.front(), there.back(), 1});
    if (!range && there.size() > 1) {
        wanted.step = there[1] - there[0];
        for (std::size_t i = 2; i < there.size(); ++i) {
            wanted.step = std::min(wanted.step, there[i] - there[i - 1]);
        }
    }
    std::vector<int> missing;
    for (int i = 0; i < wanted.count(); ++i) {
        const int frame = wanted.number(i);
        if (!std::binary_search(there.begin(), there.end(), frame)) {
            missing.push_back(frame);
        }
        pictures.push_back(numbered(pattern, frame));
    }
    return missing.empty() ? std::nullopt
                           : std::optional(fmt::format("of the frames {} of {}, {} {} missing: {}", in_words(wanted), pattern,
                                                       missing.size(), missing.size() == 1 ? "is" : "are", list(missing)));
}

std::optional<std::string> check(const Arguments& arguments, std::vector<std::string>& pictures) {
    if (arguments.pictures.empty()) {
        return "which frames? For example: lancer movie frame.####.exr -o film.mp4";
    }
    if (!arguments.output) {
        return "where shall the film go? For example: -o film.mp4";
    }
    const std::vector<std::string>& endings = movie_endings();
    if (std::find(endings.begin(), endings.end(), file_ending(*arguments.output)) == endings.end()) {
        return fmt::format("-o {}: films end in {}", *arguments.output, fmt::join(endings, ", "));
    }
    if (arguments.pictures.size() > 1 || !has_number_sign(arguments.pictures.front())) {
        pictures = arguments.pictures;
        return arguments.frames ? std::optional<std::string>("--frames goes with one name that has #, as frame.####.exr") : std::nullopt;
    }
    return expand(arguments.pictures.front(), arguments.frames, pictures);
}

int movie(const CLI::App& app, const Arguments& arguments) {
    MovieRequest request;
    if (const auto sentence = check(arguments, request.pictures)) {
        return refuse(*sentence, app);
    }
    Diagnostics diagnostics;
    check_file(*arguments.output, "-o", diagnostics);
    print_diagnostics(diagnostics);
    if (diagnostics.has_errors()) {
        return exit_bad_input;
    }
    request.output = *arguments.output;
    request.fps = arguments.fps.value_or(usual_fps);
    request.view = arguments.view;
    request.exposure = arguments.exposure;

    const auto start = std::chrono::steady_clock::now();
    ProgressPrinter printer(choose_progress(arguments.progress, arguments.quiet), request.output);
    const auto tell = [&](int done) {
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        const auto all = static_cast<double>(request.pictures.size());
        printer.show(done / all, seconds, seconds / done * (all - done), fmt::format("{:.1f} frames/s", done / std::max(seconds, 1e-9)));
    };
    bool is_whole = false;
    try {
        is_whole = make_movie(request, tell, interrupt_flag());
    } catch (const MachineFailure&) {
        throw;
    } catch (const std::runtime_error& error) {
        printer.clear();
        fmt::print(stderr, "lancer movie: error: {}\n", error.what());
        return exit_bad_input;
    }
    printer.clear();
    if (!is_whole) {
        fmt::print(stderr, "lancer movie: stopped; nothing was written\n");
        return exit_stopped;
    }
    if (!arguments.quiet) {
        const auto frames = static_cast<double>(request.pictures.size());
        fmt::print("{} written: {} frames, {:.4g} s at {:.6g} a second\n", request.output, request.pictures.size(), frames / request.fps,
                   request.fps);
    }
    return exit_done;
}

}  // namespace

void add_movie(CLI::App& program, Work& work) {
    CLI::App* app = program.add_subcommand("movie", "Make a film of frames, with ffmpeg");
    const auto arguments = std::make_shared<Arguments>();
    app->add_option("FRAMES", arguments->pictures,
                    "The pictures: one name with # for the number, as frame.####.exr, or all of them in order")
        ->type_name("");
    add_text(*app, "-o,--output", arguments->output, "FILE", "Where the film goes: .mp4 .mkv .mov .webm or .gif");
    add_frame_range(*app, arguments->frames, "Which frames; those that are there if not given");
    add_fps(*app, arguments->fps);
    add_choice(*app, "--view", arguments->view, view_names(), "How linear pictures are shown; as they say themselves if not given");
    add_real(*app, "--exposure", arguments->exposure, -100.0, 100.0, "Stops by which pictures are brightened; as they say if not given");
    add_choice(*app, "--progress", arguments->progress, {"bar", "plain", "json"}, "How progress is told, on standard error");
    app->add_flag("--quiet", arguments->quiet, "Say nothing but warnings and errors");
    app->footer(
        "ffmpeg must be there (on Debian: apt-get install ffmpeg).\n\n"
        "Example:\n  lancer render film.gltf --frames 0:240 -o frame.####.exr\n  lancer movie frame.####.exr -o film.mp4");
    app->callback([app, arguments, &work] { work = [app, arguments] { return movie(*app, *arguments); }; });
}

}  // namespace lancer::app
