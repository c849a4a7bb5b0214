// lancer farm submit SCENE -o PICTURE
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "lancer/app/cli/farm.h"
#include "lancer/app/cli/frames.h"
#include "lancer/app/cli/import_arguments.h"
#include "lancer/app/cli/render_job.h"
#include "lancer/app/cli/values.h"
#include "lancer/app/exit_status.h"
#include "lancer/app/farm/farm_work.h"
#include "lancer/app/farm/program.h"
#include "lancer/app/farm/slurm.h"
#include "lancer/app/prepare.h"
#include "lancer/import/import.h"

namespace lancer::app {

namespace {

namespace fs = std::filesystem;

constexpr int usual_shards = 16;

struct Arguments {
    RenderJob render;
    std::optional<int> shards;
    std::optional<int> tasks;
    std::optional<int> cpus;
    std::optional<std::string> folder;
    std::vector<std::string> sbatch;
    bool slurm = false;
    bool keep_shards = false;
};

std::optional<std::string> what_does_not_belong(const RenderJob& job) {
    const auto not_here = [](const char* option) { return fmt::format("{} goes with \"lancer render\", not with many machines", option); };
    return job.shard        ? std::optional(std::string("--shard is what the tasks do; --shards N says how many there are"))
           : job.sample_map ? std::optional(not_here("--sample-map"))
           : job.stats      ? std::optional(not_here("--stats"))
                            : std::nullopt;
}

// Reads and prepares the scene, so that what is wrong with it is said here and now, not by a thousand tasks. Its hash; nothing after errors.
std::optional<std::string> hash_of_scene(const RenderJob& render) {
    Diagnostics diagnostics;
    ImportReport report;
    const std::string& file = render.files.front();
    std::optional<scene::Scene> scene = import_scene(file, render.render.import, report, diagnostics);
    tell_report(report, file, diagnostics);
    std::string hash = scene ? scene->hash : "";
    const bool is_good = scene && !diagnostics.has_errors() && prepare(std::move(*scene), render.render, "", diagnostics);
    print_diagnostics(diagnostics, render.quiet);
    return is_good && !diagnostics.has_errors() ? std::optional(hash) : std::nullopt;
}

FarmJob job_of(const Arguments& arguments, std::string hash) {
    const RenderJob& render = arguments.render;
    FarmJob job;
    job.folder =
        fs::weakly_canonical(fs::absolute(arguments.folder.value_or(without_number_sign(render.outputs.front()) + ".farm"))).string();
    job.version = LANCER_VERSION;
    job.program = own_path();
    job.where = fs::current_path().string();
    job.scene = render.files.front();
    job.hash = std::move(hash);
    job.options = words_of(render.render);
    job.outputs = render.outputs;
    job.frames = render.frames;
    job.fps = render.fps.value_or(usual_fps);
    job.shards = arguments.shards.value_or(render.frames ? 1 : usual_shards);
    job.tasks = std::min(arguments.tasks.value_or(job.units()), job.units());
    job.keep_shards = arguments.keep_shards;
    job.checkpoint = render.checkpoint.value_or(usual_checkpoint);
    for (const std::string& words : arguments.sbatch) {
        std::istringstream parts(words);
        for (std::string word; parts >> word;) {
            job.scheduler_options.push_back(word);
        }
    }
    if (arguments.cpus) {
        job.scheduler_options.push_back(fmt::format("--cpus-per-task={}", *arguments.cpus));
    }
    return job;
}

// A folder that is there already: the same job goes on.
int check_folder(const CLI::App& app, FarmJob& job, bool& is_new) {
    is_new = !fs::exists(job.folder);
    if (is_new || (fs::is_directory(job.folder) && fs::is_empty(job.folder))) {
        is_new = true;
        return exit_done;
    }
    std::string sentence;
    const std::optional<FarmJob> before = read_farm_job(job.folder, sentence);
    if (!before) {
        return refuse(fmt::format("{}; name another with --folder", sentence), app);
    }
    if (const auto difference = before->difference(job)) {
        return refuse(fmt::format("{} is a job with {}; remove it, or name another folder with --folder", job.folder, *difference), app);
    }
    job.tasks = before->tasks;
    job.rounds = before->rounds;
    return exit_done;
}

std::string size_in_words(const FarmJob& job) {
    const std::string frames = job.frames ? fmt::format("{} {}", job.pictures(), job.pictures() == 1 ? "frame" : "frames") : "";
    const std::string shards = job.shards > 1 || !job.frames ? fmt::format("{} {}", job.shards, job.shards == 1 ? "shard" : "shards") : "";
    return frames + (frames.empty() || shards.empty() ? "" : " of ") + shards;
}

int submit(const CLI::App& app, Arguments arguments) {
    RenderJob& render = arguments.render;
    if (const auto sentence = sort_files(render)) {
        return refuse(*sentence, app);
    }
    if (const auto sentence = what_does_not_belong(render)) {
        return refuse(*sentence, app);
    }
    if (const auto sentence = check_frames(render)) {
        return refuse(*sentence, app);
    }
    if (!arguments.sbatch.empty() && !arguments.slurm) {
        return refuse("--sbatch goes with --slurm", app);
    }
    Diagnostics diagnostics;
    check_outputs(render, diagnostics);
    print_diagnostics(diagnostics);
    if (diagnostics.has_errors()) {
        return exit_bad_input;
    }
    const std::optional<std::string> hash = hash_of_scene(render);
    if (!hash) {
        return exit_bad_input;
    }
    FarmJob job = job_of(arguments, *hash);
    const std::string shown = fs::proximate(job.folder).string();
    bool is_new = true;
    if (const int status = check_folder(app, job, is_new); status != exit_done) {
        return status;
    }
    if (arguments.slurm && is_new) {
        job.tasks = std::min(job.tasks, most_slurm_tasks());
    }
    std::vector<int> missing;
    const FarmState state = look_at(job);
    for (int unit = 0; unit < job.units(); ++unit) {
        if (!state.units[static_cast<std::size_t>(unit)]) {
            missing.push_back(unit);
        }
    }
    if (!is_new && state.pictures_done == job.pictures()) {
        fmt::print("{} is done already\n", shown);
        return exit_done;
    }
    if (!is_new && !job.rounds.empty() && !slurm_states(job.rounds.back()).empty() && !state.cancelled) {
        fmt::print("{} is at work: \"lancer farm status {}\" tells how far it is\n", shown, shown);
        return exit_done;
    }
    make_farm_folder(job);
    fs::remove(job.cancelled_file());
    for (const auto& [unit, status] : state.failed) {
        fs::remove(job.failed_file(unit));
    }
    write_manifest(job);  // before the tasks, which read it
    const std::vector<int> tasks = tasks_of(job, missing);
    if (!arguments.slurm) {
        fmt::print(
            "{}: {} in {} tasks. On any machine that sees this folder:\n  lancer farm work {} TASK    (from 1 to {}; all of them if not "
            "given)\n"
            "and when they have ended:\n  lancer farm merge {}\n",
            shown, size_in_words(job), job.tasks, shown, job.tasks, shown);
        return exit_done;
    }
    job.rounds.push_back(submit_to_slurm(job, tasks.empty() ? std::vector<int>{1} : tasks));
    write_manifest(job);
    fmt::print("{}: {} in {} {}, given to Slurm: array {}, merge {}\n\"lancer farm status {}\" tells how far it is\n", shown,
               size_in_words(job), tasks.size(), tasks.size() == 1 ? "task" : "tasks", job.rounds.back().array, job.rounds.back().merge,
               shown);
    return exit_done;
}

}  // namespace

void add_farm_submit(CLI::App& farm, Work& work) {
    CLI::App* app = farm.add_subcommand("submit", "Cut a picture or a film in parts and give them to a cluster");
    const auto arguments = std::make_shared<Arguments>();
    constexpr const char* group = "Farm";
    add_job_options(*app, arguments->render);
    app->add_flag("--slurm", arguments->slurm, "Give the work to Slurm; else the folder is made, and you start the tasks")->group(group);
    add_whole(*app, "--shards", arguments->shards, 1, 1 << 16, "In how many parts each picture is cut; 16 if not given, 1 with --frames")
        ->group(group);
    add_whole(*app, "--tasks", arguments->tasks, 1, 1 << 20, "Into how many tasks the parts go; as many as the cluster takes if not given")
        ->group(group);
    add_whole(*app, "--cpus", arguments->cpus, 1, 1 << 16, "Processors for each task")->group(group);
    app->add_option("--sbatch", arguments->sbatch, "More words for sbatch, as --sbatch \"--partition=long --time=8:00:00\"")
        ->type_name("WORDS")
        ->allow_extra_args(false)
        ->group(group);
    add_text(*app, "--folder", arguments->folder, "FOLDER", "Where the job keeps its parts; the picture's name with .farm if not given")
        ->group(group);
    app->add_flag("--keep-shards", arguments->keep_shards, "Parts stay when they are joined")->group(group);
    app->footer(
        "The same words once more go on with a job that was cancelled or has failed.\n\n"
        "Example:\n  lancer farm submit scene.toml --spp 4096 -o out.exr --shards 64 --slurm\n"
        "  lancer farm submit film.gltf --frames 0:240 -o frame.####.exr --slurm --sbatch --partition=night");
    app->callback([app, arguments, &work] { work = [app, arguments] { return submit(*app, *arguments); }; });
}

}  // namespace lancer::app
