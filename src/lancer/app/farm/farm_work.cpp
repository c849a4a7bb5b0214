#include "lancer/app/farm/farm_work.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <set>

#include <fmt/format.h>

#include "lancer/app/cli/checkpoints.h"
#include "lancer/app/cli/command_line.h"
#include "lancer/app/cli/interrupt.h"
#include "lancer/app/cli/progress.h"
#include "lancer/app/exit_status.h"
#include "lancer/base/failure.h"
#include "lancer/image/replace_file.h"

namespace lancer::app {

namespace fs = std::filesystem;

namespace {

bool is_there(const std::string& path) {
    std::error_code ignored;
    return fs::exists(path, ignored);
}

void remove(const std::string& path) {
    std::error_code ignored;
    fs::remove(path, ignored);
}

int run_words(const std::vector<std::string>& words) {
    try {
        return run_command_line(words);
    } catch (const std::exception& failure) {
        fmt::print(stderr, "lancer: error: {}\n", failure.what());
        return exit_machine_failed;
    }
}

// The processors that the scheduler gave to this task; empty where there is no scheduler.
std::vector<std::string> words_of_machine() {
    for (const char* variable : {"SLURM_CPUS_PER_TASK", "SLURM_CPUS_ON_NODE"}) {
        if (const char* const count = std::getenv(variable); count != nullptr && *count != '\0') {
            return {"--threads", count};
        }
    }
    return {};
}

bool has_all_shards(const FarmJob& job, int picture) {
    const std::vector<std::string> files = job.shard_files(picture);
    return std::all_of(files.begin(), files.end(), is_there);
}

bool has_outputs(const FarmJob& job, int picture) {
    const std::vector<std::string> outputs = job.outputs_of(picture);
    return std::all_of(outputs.begin(), outputs.end(), is_there);
}

void mark_as_done(const FarmJob& job, int picture) {
    replace_file(job.done_file(picture), "");
    for (int unit = picture * job.shards; unit < (picture + 1) * job.shards; ++unit) {
        remove(job.failed_file(unit));
        if (job.shards > 1 && !job.keep_shards) {
            remove(job.shard_file(unit));
        }
    }
}

int merge_picture(const FarmJob& job, int picture) {
    const int status = run_words(job.merge_words(picture, job.shard_files(picture)));
    if (status == exit_done) {
        mark_as_done(job, picture);
    } else if (is_there(job.done_file(picture))) {
        return exit_done;  // another machine was quicker, and took the shards away meanwhile
    }
    return status;
}

int do_unit(const FarmJob& job, int unit) {
    std::vector<std::string> words = job.render_words(unit);
    std::vector<std::string> machine = words_of_machine();
    machine.insert(machine.end(), {"--checkpoint", job.checkpoint > 0.0 ? fmt::format("{}s", job.checkpoint) : "off", "--quiet",
                                   "--progress-file", job.running_file(unit)});
    words.insert(words.end(), machine.begin(), machine.end());
    // What a task before this one had done when it was stopped is not done again.
    if (job.shards > 1 && is_there(checkpoint_path(job.shard_file(unit)))) {
        std::vector<std::string> resume = {"resume", job.shard_file(unit)};
        resume.insert(resume.end(), machine.begin(), machine.end());
        if (const int status = run_words(resume); status != exit_bad_input) {
            return status;
        }
    }
    words.insert(words.end(), {"--only-if", job.hash});
    return run_words(words);
}

}  // namespace

int do_farm_tasks(const FarmJob& job, const std::vector<int>& tasks) {
    const std::atomic<bool>& interrupted = interrupt_flag();
    int worst = exit_done;
    if (!is_there(job.started_file())) {
        replace_file(job.started_file(), "");
    }
    for (const int task : tasks) {
        for (int unit = task - 1; unit < job.units(); unit += job.tasks) {
            const int picture = job.picture_of(unit);
            if (is_there(job.done_file(picture)) || (job.shards > 1 && is_there(job.shard_file(unit)))) {
                continue;
            }
            const auto start = std::chrono::steady_clock::now();
            int status = do_unit(job, unit);
            if (interrupted) {
                return exit_stopped;
            }
            const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            fmt::print("{}: {} {}\n", job.unit_in_words(unit), status == exit_done ? "done in" : fmt::format("status {} after", status),
                       in_words(seconds));
            std::fflush(stdout);
            if (status == exit_done && job.shards == 1) {
                mark_as_done(job, picture);
            } else if (status == exit_done && job.frames && has_all_shards(job, picture)) {
                // Who brings the last shard of a frame joins it, so that no machine is left with all of them in the end.
                status = merge_picture(job, picture);
            }
            if (status != exit_done) {
                replace_file(job.failed_file(unit), fmt::format("{}\n", status));
            } else {
                remove(job.failed_file(unit));
            }
            worst = std::max(worst, status);
        }
    }
    return worst;
}

FarmMerge merge_farm(const FarmJob& job, bool partial) {
    FarmMerge result;
    for (int picture = 0; picture < job.pictures(); ++picture) {
        if (is_there(job.done_file(picture))) {
            if (has_outputs(job, picture)) {
                continue;
            }
            remove(job.done_file(picture));  // somebody has taken the pictures away
        }
        std::vector<int> missing;
        for (int unit = picture * job.shards; unit < (picture + 1) * job.shards; ++unit) {
            if (job.shards == 1 || !is_there(job.shard_file(unit))) {
                missing.push_back(unit);
            }
        }
        if (missing.empty()) {
            result.status = std::max(result.status, merge_picture(job, picture));
        } else if (partial && missing.size() < static_cast<std::size_t>(job.shards)) {
            std::vector<std::string> films = job.shard_files(picture);
            std::erase_if(films, [](const std::string& film) { return !is_there(film); });
            std::vector<std::string> words = job.merge_words(picture, films);
            words.push_back("--partial");
            result.status = std::max(result.status, run_words(words));
        }
        result.missing.insert(result.missing.end(), missing.begin(), missing.end());
    }
    if (result.missing.empty() && result.status == exit_done && !job.keep_shards) {
        // What killed tasks have left.
        std::error_code ignored;
        for (const char* const folder : {"shards", "running"}) {
            for (const auto& entry : fs::directory_iterator(fs::path(job.folder) / folder, ignored)) {
                fs::remove(entry.path(), ignored);
            }
        }
    }
    return result;
}

std::vector<int> tasks_of(const FarmJob& job, const std::vector<int>& units) {
    std::set<int> tasks;
    for (const int unit : units) {
        tasks.insert(job.task_of(unit));
    }
    return {tasks.begin(), tasks.end()};
}

}  // namespace lancer::app
