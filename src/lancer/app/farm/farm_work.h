// What the machines of a farm do: units of work, one after the other, and joining what has become of them.
#pragma once

#include <vector>

#include "lancer/app/farm/farm_job.h"

namespace lancer::app {

// Does the units of these tasks, from 1 to job.tasks, that nobody has done. Returns the worst exit status among them; a task that is told to
// stop ends at once with exit_stopped.
int do_farm_tasks(const FarmJob& job, const std::vector<int>& tasks);

struct FarmMerge {
    std::vector<int> missing;  // units
    int status = 0;            // of what could be merged
};

// Joins the shards of every picture that is not done and has all of them. `partial`: of every other picture, what is there.
FarmMerge merge_farm(const FarmJob& job, bool partial);

// The tasks that these units belong to, in order.
std::vector<int> tasks_of(const FarmJob& job, const std::vector<int>& units);

}  // namespace lancer::app
