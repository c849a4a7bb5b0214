// lancer farm: a picture or a film on many machines
#include "lancer/app/cli/farm.h"

#include <cstdio>
#include <filesystem>
#include <memory>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "lancer/app/exit_status.h"
#include "lancer/app/farm/farm_work.h"
#include "lancer/app/farm/slurm.h"
#include "lancer/image/replace_file.h"

namespace lancer::app {

namespace {

struct Arguments {
    std::string job;
    std::vector<int> tasks;
    bool partial = false;
    bool again = false;
};

// Names on the command line that was submitted are seen from there.
bool go_where(const FarmJob& job) {
    std::error_code error;
    std::filesystem::current_path(job.where, error);
    if (error) {
        fmt::print(stderr, "lancer farm: error: the folder {} that {} was submitted from can't be entered: {}\n", job.where, job.folder,
                   error.message());
    }
    return !error;
}

int work_on(const CLI::App& app, const Arguments& arguments) {
    const auto job = find_farm_job(app, arguments.job);
    if (!job) {
        return exit_bad_input;
    }
    if (job->version != LANCER_VERSION) {
        return refuse(fmt::format("{} was submitted by lancer {}, and this is {}: pictures are made by one version", arguments.job,
                                  job->version, LANCER_VERSION),
                      app);
    }
    std::vector<int> tasks = arguments.tasks;
    for (const int task : tasks) {
        if (task < 1 || task > job->tasks) {
            return refuse(fmt::format("task {}: {} has the tasks 1 to {}", task, arguments.job, job->tasks), app);
        }
    }
    for (int task = 1; tasks.size() < static_cast<std::size_t>(job->tasks) && arguments.tasks.empty(); ++task) {
        tasks.push_back(task);
    }
    return go_where(*job) ? do_farm_tasks(*job, tasks) : exit_bad_input;
}

int merge(const CLI::App& app, const Arguments& arguments) {
    auto job = find_farm_job(app, arguments.job);
    if (!job || !go_where(*job)) {
        return exit_bad_input;
    }
    const FarmMerge merged = merge_farm(*job, arguments.partial);
    if (merged.missing.empty()) {
        return merged.status;
    }
    fmt::print(stderr, "lancer farm merge: error: {} of {} {} missing: {}\n", merged.missing.size(), job->units(),
               merged.missing.size() == 1 ? "part is" : "parts are", list_units(*job, merged.missing));
    const FarmState state = look_at(*job);
    const bool is_hopeless =
        std::any_of(state.failed.begin(), state.failed.end(), [](const auto& one) { return one.second == exit_bad_input; });
    if (!arguments.again || state.cancelled || is_hopeless || job->tries_left < 1) {
        return std::max<int>(merged.status, exit_stopped);
    }
    --job->tries_left;
    job->rounds.push_back(submit_to_slurm(*job, tasks_of(*job, merged.missing)));
    write_manifest(*job);
    fmt::print("Submitted again: array {}, merge {}\n", job->rounds.back().array, job->rounds.back().merge);
    return exit_stopped;
}

int cancel(const CLI::App& app, const Arguments& arguments) {
    const auto job = find_farm_job(app, arguments.job);
    if (!job) {
        return exit_bad_input;
    }
    replace_file(job->cancelled_file(), "");
    for (const FarmRound& round : job->rounds) {
        cancel_in_slurm(round);
    }
    const FarmState state = look_at(*job);
    fmt::print("{} is cancelled; {} of {} parts are done and stay. \"lancer farm submit\" with the same words goes on.\n", arguments.job,
               state.units_done, job->units());
    return exit_done;
}

CLI::App* add_part(CLI::App& farm, const std::string& name, const std::string& description, const std::shared_ptr<Arguments>& arguments) {
    CLI::App* app = farm.add_subcommand(name, description);
    app->add_option("JOB", arguments->job, "The job's folder, as \"lancer farm submit\" named it")->type_name("")->required();
    return app;
}

}  // namespace

std::optional<FarmJob> find_farm_job(const CLI::App& app, const std::string& folder) {
    std::string sentence;
    std::optional<FarmJob> job = read_farm_job(folder, sentence);
    if (!job) {
        refuse(sentence, app);
    }
    return job;
}

std::string list_units(const FarmJob& job, const std::vector<int>& units) {
    constexpr std::size_t most = 10;
    std::string list;
    for (std::size_t i = 0; i < std::min(units.size(), most); ++i) {
        list += (i == 0 ? "" : "; ") + job.unit_in_words(units[i]);
    }
    return units.size() > most ? fmt::format("{}; and {} more", list, units.size() - most) : list;
}

void add_farm(CLI::App& program, Work& work) {
    CLI::App* farm = program.add_subcommand("farm", "A picture or a film on many machines: submit, status, cancel");
    farm->require_subcommand(0, 1);
    farm->callback([farm, &work] {
        if (farm->get_subcommands().empty()) {
            work = [farm] { return refuse("submit, status or cancel? \"lancer farm submit\" begins", *farm); };
        }
    });
    farm->footer(
        "Example:\n  lancer farm submit scene.toml --spp 4096 -o out.exr --shards 64 --slurm\n"
        "  lancer farm submit film.gltf --frames 0:240 -o frame.####.exr --slurm\n  lancer farm status out.farm");
    add_farm_submit(*farm, work);
    add_farm_status(*farm, work);

    const auto arguments = std::make_shared<Arguments>();
    CLI::App* app = add_part(*farm, "cancel", "End the work on a job; what is done stays", arguments);
    app->footer("Example:\n  lancer farm cancel out.farm");
    app->callback([app, arguments, &work] { work = [app, arguments] { return cancel(*app, *arguments); }; });

    app = add_part(*farm, "work", "Do tasks of a job on this machine: what the scheduler starts", arguments);
    app->add_option("TASK", arguments->tasks, "Which of its tasks, from 1 on; all of them if not given")->type_name("");
    app->footer("What is done already is left alone.\n\nExample:\n  lancer farm work out.farm 7");
    app->callback([app, arguments, &work] { work = [app, arguments] { return work_on(*app, *arguments); }; });

    app = add_part(*farm, "merge", "Join what the tasks have made: what the scheduler starts when they have ended", arguments);
    app->add_flag("--partial", arguments->partial, "Write pictures of what is there, too");
    app->add_flag("--again", arguments->again, "Submit to Slurm again what is missing");
    app->footer("Exit status: 0 all is done, 1 parts are missing, 2 bad input.\n\nExample:\n  lancer farm merge out.farm");
    app->callback([app, arguments, &work] { work = [app, arguments] { return merge(*app, *arguments); }; });
}

}  // namespace lancer::app
