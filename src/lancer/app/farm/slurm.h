// Slurm, through its own programs: https://slurm.schedmd.com/sbatch.html, squeue.html, scancel.html, scontrol.html.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "lancer/app/farm/farm_job.h"

namespace lancer::app {

// How many tasks one array may have here. Throws MachineFailure where Slurm does not answer.
int most_slurm_tasks();

// "1-3,7" of 1, 2, 3, 7.
std::string as_ranges(const std::vector<int>& tasks);

// Gives the tasks to Slurm, and a merge that waits for them all to end, well or not. Throws MachineFailure with what sbatch said.
FarmRound submit_to_slurm(const FarmJob& job, const std::vector<int>& tasks);

// How many tasks of the round, the merge among them, are in which state: "RUNNING", "PENDING", ... Those that ended are not known for long.
std::map<std::string, int> slurm_states(const FarmRound& round);

void cancel_in_slurm(const FarmRound& round);

}  // namespace lancer::app
