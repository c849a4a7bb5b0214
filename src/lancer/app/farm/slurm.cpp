#include "lancer/app/farm/slurm.h"

#include <sys/stat.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <sstream>

#include <fmt/format.h>

#include "lancer/app/cli/spelling.h"
#include "lancer/app/farm/program.h"
#include "lancer/base/failure.h"
#include "lancer/image/replace_file.h"

namespace lancer::app {

namespace {

std::string ask(const std::vector<std::string>& words) {
    if (!find_program(words.front())) {
        throw MachineFailure(fmt::format(
            "{} is not on this machine: this goes on where the programs of Slurm are, such as the login node of a cluster", words.front()));
    }
    const ProgramResult result = run_program(words);
    if (result.status != 0) {
        std::string said = result.err.empty() ? result.out : result.err;
        while (!said.empty() && said.back() == '\n') {
            said.pop_back();
        }
        throw MachineFailure(fmt::format("{} ended with {}: {}", words.front(), result.status, said));
    }
    return result.out;
}

std::string first_word(const std::string& text) {
    std::string word;
    std::istringstream(text) >> word;
    return word.substr(0, word.find(';'));  // "17;cluster" where there are several clusters
}

std::string write_script(const FarmJob& job, const std::string& name, const std::string& command) {
    const std::string path = (std::filesystem::path(job.folder) / name).string();
    replace_file(path, "#!/bin/sh\n# Written by lancer farm submit; run by Slurm.\n" + command + "\n");
    ::chmod(path.c_str(), 0755);
    return path;
}

std::string submit(const FarmJob& job, const std::string& script, const std::string& log, const std::string& name,
                   const std::vector<std::string>& more) {
    std::vector<std::string> words = {"sbatch",
                                      "--parsable",
                                      "--requeue",
                                      "--open-mode=append",
                                      "--job-name=" + name,
                                      "--chdir=" + job.where,
                                      "--output=" + job.log_file(log)};
    words.insert(words.end(), more.begin(), more.end());
    words.insert(words.end(), job.scheduler_options.begin(), job.scheduler_options.end());
    words.push_back(script);
    const std::string id = first_word(ask(words));
    if (id.empty() || id.find_first_not_of("0123456789") != std::string::npos) {
        throw MachineFailure(fmt::format("sbatch did not name the job that it took, but said \"{}\"", id));
    }
    return id;
}

}  // namespace

int most_slurm_tasks() {
    std::istringstream lines(ask({"scontrol", "show", "config"}));
    for (std::string line; std::getline(lines, line);) {
        std::istringstream parts(line);
        std::string key, equals;
        int number = 0;
        if (parts >> key >> equals >> number && key == "MaxArraySize") {
            return std::max(1, number - 1);  // the largest index is one below, and ours start at one
        }
    }
    return 1000;
}

std::string as_ranges(const std::vector<int>& tasks) {
    std::string text;
    for (std::size_t i = 0; i < tasks.size();) {
        std::size_t end = i;
        while (end + 1 < tasks.size() && tasks[end + 1] == tasks[end] + 1) {
            ++end;
        }
        text += (text.empty() ? "" : ",") + (end == i ? fmt::format("{}", tasks[i]) : fmt::format("{}-{}", tasks[i], tasks[end]));
        i = end + 1;
    }
    return text;
}

FarmRound submit_to_slurm(const FarmJob& job, const std::vector<int>& tasks) {
    const std::string name = "lancer-" + std::filesystem::path(job.folder).stem().string();
    const std::string task =
        write_script(job, "task.sh", "exec " + shell_quoted({job.program, "farm", "work", job.folder}) + " \"$SLURM_ARRAY_TASK_ID\"");
    const std::string merge = write_script(job, "merge.sh", "exec " + shell_quoted({job.program, "farm", "merge", job.folder, "--again"}));
    FarmRound round;
    round.array = submit(job, task, "%a", name, {"--array=" + as_ranges(tasks)});
    try {
        round.merge = submit(job, merge, "merge", name + "-merge", {"--dependency=afterany:" + round.array});
    } catch (...) {
        run_program({"scancel", round.array});
        throw;
    }
    return round;
}

std::map<std::string, int> slurm_states(const FarmRound& round) {
    std::map<std::string, int> states;
    if (!find_program("squeue")) {
        return states;
    }
    // One id at a time: an unknown one makes squeue forget the others.
    for (const std::string& id : {round.array, round.merge}) {
        std::istringstream lines(run_program({"squeue", "-h", "-r", "-j", id, "-o", "%T"}).out);
        for (std::string state; lines >> state;) {
            ++states[state];
        }
    }
    return states;
}

void cancel_in_slurm(const FarmRound& round) {
    // The merge first, so that it does not start when the tasks are gone. Those that have ended are no error.
    ask({"scancel", "--quiet", round.merge});
    ask({"scancel", "--quiet", round.array});
}

}  // namespace lancer::app
