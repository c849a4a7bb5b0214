// lancer render SCENE -o out.png
#include <algorithm>
#include <memory>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "lancer/app/cli/command_line.h"
#include "lancer/app/cli/frames.h"
#include "lancer/app/cli/import_arguments.h"
#include "lancer/app/cli/render_job.h"
#include "lancer/render/render.h"

namespace lancer::app {

namespace {

void add_shard(CLI::App& app, std::optional<Shard>& shard) {
    const auto read = [&shard](const std::string& text) {
        const auto whole = [](const std::string& digits) {
            const bool good = !digits.empty() && digits.size() < 8 && digits.find_first_not_of("0123456789") == std::string::npos;
            return good ? std::stoi(digits) : 0;
        };
        const std::size_t slash = std::min(text.find('/'), text.size());
        const Shard found{whole(text.substr(0, slash)), whole(text.substr(std::min(slash + 1, text.size())))};
        if (found.shard < 1 || found.shard > found.shards || found.shards > max_shards) {
            throw CLI::ValidationError("--shard", fmt::format("expected I/N with I from 1 to N, as 2/8, not \"{}\"", text));
        }
        shard = found;
    };
    app.add_option_function<std::string>("--shard", read,
                                         "Only one of N equal shares of the work, into a film; \"lancer merge\" joins them")
        ->type_name("I/N")
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
}

}  // namespace

void add_job_options(CLI::App& app, RenderJob& job) {
    app.add_option("SCENE", job.files, scene_argument_help())->type_name("");
    app.add_option("-o,--output", job.outputs,
                   "Where the picture goes: .png .jpg .exr .hdr or .tif, or .film to go on with; may be given several times")
        ->type_name("FILE")
        ->allow_extra_args(false);
    add_text(app, "--sample-map", job.sample_map, "FILE", "A second picture: how many samples each pixel took, bright where many");
    add_text(app, "--stats", job.stats, "FILE", "Numbers about the render, as JSON");
    add_text(app, "--preview", job.preview, "FILE", "A picture that is written anew while the render goes on, every second or less often");
    add_choice(app, "--progress", job.progress, {"bar", "plain", "json"}, "How progress is told, on standard error");
    add_text(app, "--progress-file", job.progress_file, "FILE",
             "A file that says how far the render is, as a share from 0 to 1, and goes when it ends; for programs on other machines");
    app.add_flag("--quiet", job.quiet, "Say nothing but warnings and errors");
    add_shard(app, job.shard);
    add_frame_range(app, job.frames,
                    "An animation: a picture for each frame that is not done; # in file names stands for the frame's number");
    add_fps(app, job.fps);
    add_text(app, "--only-if", job.only_if, "HASH",
             "Render only if the scene and all that it reads has this hash, as \"lancer info\" tells it");
    add_duration(app, "--checkpoint", job.checkpoint,
                 "How often the film is saved beside the picture, for \"lancer resume\"; \"off\": never. If not given, 30s after a minute",
                 true);
    add_render_options(app, job.render);
    add_file_options(app, job.render);
}

std::vector<std::string> words_of(const RenderJob& job) {
    std::vector<std::string> words = {"render"};
    words.insert(words.end(), job.files.begin(), job.files.end());
    for (const std::string& output : job.outputs) {
        words.insert(words.end(), {"-o", output});
    }
    if (job.shard) {
        words.insert(words.end(), {"--shard", fmt::format("{}/{}", job.shard->shard, job.shard->shards)});
    }
    const std::vector<std::string> options = words_of(job.render);
    words.insert(words.end(), options.begin(), options.end());
    return words;
}

std::optional<RenderJob> job_of_words(const std::vector<std::string>& words) {
    CLI::App program;
    CLI::App* app = program.add_subcommand("render");
    RenderJob job;
    add_job_options(*app, job);
    try {
        program.parse(std::vector<std::string>(words.rbegin(), words.rend()));  // CLI11 takes them from the back
    } catch (const CLI::Error&) {
        return std::nullopt;
    }
    return job;
}

void add_render(CLI::App& program, Work& work) {
    CLI::App* app = program.add_subcommand("render", "Render a scene into picture files, without a window");
    const auto job = std::make_shared<RenderJob>();
    add_job_options(*app, *job);
    app->footer("Example:\n  lancer render scenes/report/figure-1.toml --size 1920x1080 --ssaa 4 -o figure-1.png -o figure-1.exr");
    app->callback([app, job, &work] { work = [app, job] { return run_render_job(*app, *job); }; });
}

}  // namespace lancer::app
