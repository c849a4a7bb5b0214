// lancer farm status JOB
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <memory>
#include <thread>

#include <fmt/format.h>
#include <unistd.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "lancer/app/cli/farm.h"
#include "lancer/app/cli/interrupt.h"
#include "lancer/app/cli/progress.h"
#include "lancer/app/exit_status.h"
#include "lancer/app/farm/slurm.h"

namespace lancer::app {

namespace {

struct Arguments {
    std::string job;
    bool json = false;
    bool watch = false;
};

struct Status {
    FarmState state;
    int running = 0;
    int waiting = 0;             // tasks
    double share = 0.0;          // of all work
    double seconds = 0.0;        // since the first task began; 0: none has
    double seconds_left = -1.0;  // below 0: not known

    bool is_done(const FarmJob& job) const { return state.pictures_done == job.pictures(); }
};

double seconds_since_change(const std::string& path) {
    struct stat found {};
    return ::stat(path.c_str(), &found) == 0 ? std::max(0.0, std::difftime(std::time(nullptr), found.st_mtime)) : 0.0;
}

Status status_of(const FarmJob& job) {
    Status status;
    status.state = look_at(job);
    if (!job.rounds.empty()) {
        for (const auto& [name, count] : slurm_states(job.rounds.back())) {
            (name == "RUNNING" || name == "COMPLETING" ? status.running : status.waiting) += count;
        }
    }
    status.seconds = seconds_since_change(job.started_file());
    status.share = (status.state.units_done + status.state.units_begun) / job.units();
    if (status.running > 0 && status.share > 0.0) {
        status.seconds_left = status.seconds * (1.0 - status.share) / status.share;
    }
    return status;
}

std::string line_of(const FarmJob& job, const Status& status) {
    const bool films = job.frames && job.shards == 1;
    const int done = films ? status.state.pictures_done : status.state.units_done;
    const int all = films ? job.pictures() : job.units();
    constexpr int cells = 24;
    const int full = static_cast<int>(status.share * cells);
    std::string line =
        fmt::format("[{:#<{}}{:-<{}}] {:3.0f} %  {} of {} {}", "", full, "", cells - full, std::floor(status.share * 100.0), done, all,
                    films             ? "frames"
                    : job.shards == 1 ? "pictures"
                                      : "shards");
    if (job.frames && job.shards > 1) {
        line += fmt::format(", {} of {} frames", status.state.pictures_done, job.pictures());
    }
    if (status.is_done(job)) {
        return line + ", all written";
    }
    if (status.running + status.waiting > 0) {
        line += fmt::format("; {} {} running, {} waiting", status.running, status.running == 1 ? "task" : "tasks", status.waiting);
    } else {
        line += status.state.cancelled ? "; cancelled"
                : job.rounds.empty()   ? "; no scheduler was asked"
                                       : "; nothing is running or waiting";
    }
    return status.seconds_left >= 0.0 ? fmt::format("{}; about {} left", line, in_words(std::ceil(status.seconds_left))) : line;
}

void tell_failures(const FarmJob& job, const Status& status) {
    constexpr std::size_t most = 10;
    const auto& failed = status.state.failed;
    for (std::size_t i = 0; i < std::min(failed.size(), most); ++i) {
        fmt::print("{} failed with status {}: see {}\n", job.unit_in_words(failed[i].first), failed[i].second,
                   std::filesystem::proximate(job.log_file(fmt::format("{}", job.task_of(failed[i].first)))).string());
    }
    if (failed.size() > most) {
        fmt::print("and {} more\n", failed.size() - most);
    }
}

nlohmann::ordered_json to_json(const FarmJob& job, const Status& status) {
    nlohmann::ordered_json failed = nlohmann::ordered_json::array();
    for (const auto& [unit, code] : status.state.failed) {
        failed.push_back({{"unit", job.unit_in_words(unit)}, {"task", job.task_of(unit)}, {"status", code}});
    }
    nlohmann::ordered_json json = {{"job", job.folder},
                                   {"done", status.is_done(job)},
                                   {"share", status.share},
                                   {"units", job.units()},
                                   {"units_done", status.state.units_done},
                                   {"pictures", job.pictures()},
                                   {"pictures_done", status.state.pictures_done},
                                   {"running", status.running},
                                   {"waiting", status.waiting},
                                   {"cancelled", status.state.cancelled},
                                   {"seconds", status.seconds}};
    json["seconds_left"] = status.seconds_left >= 0.0 ? nlohmann::ordered_json(status.seconds_left) : nlohmann::ordered_json();
    json["failed"] = failed;
    return json;
}

int show(const CLI::App& app, const Arguments& arguments) {
    const bool on_terminal = isatty(STDOUT_FILENO) != 0;
    const std::atomic<bool>& interrupted = interrupt_flag();
    for (std::string before;;) {
        const auto job = find_farm_job(app, arguments.job);
        if (!job) {
            return exit_bad_input;
        }
        const Status status = status_of(*job);
        const bool is_last = !arguments.watch || status.is_done(*job) || status.running + status.waiting == 0 || interrupted;
        if (arguments.json) {
            fmt::print("{}\n", to_json(*job, status).dump(arguments.watch ? -1 : 2));
        } else if (const std::string line = line_of(*job, status); on_terminal && arguments.watch) {
            fmt::print("\r{}\033[K{}", line, is_last ? "\n" : "");
        } else if (line != before) {
            fmt::print("{}\n", line);
            before = line;
        }
        if (is_last) {
            if (!arguments.json) {
                tell_failures(*job, status);
            }
            return status.is_done(*job) ? exit_done : exit_stopped;
        }
        std::fflush(stdout);
        for (int i = 0; i < 20 && !interrupted; ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
        }
    }
}

}  // namespace

void add_farm_status(CLI::App& farm, Work& work) {
    CLI::App* app = farm.add_subcommand("status", "How far a job is");
    const auto arguments = std::make_shared<Arguments>();
    app->add_option("JOB", arguments->job, "The job's folder, as \"lancer farm submit\" named it")->type_name("")->required();
    app->add_flag("--watch", arguments->watch, "Go on telling until nothing is running or waiting");
    app->add_flag("--json", arguments->json, "For programs");
    app->footer("Exit status: 0 all is done, 1 not yet, 2 bad input.\n\nExample:\n  lancer farm status out.farm --watch");
    app->callback([app, arguments, &work] { work = [app, arguments] { return show(*app, *arguments); }; });
}

}  // namespace lancer::app
