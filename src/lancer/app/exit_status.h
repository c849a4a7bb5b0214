// What the shell is told.
#pragma once

namespace lancer::app {

enum ExitStatus : int {
    exit_done = 0,
    exit_stopped = 1,         // before its goal: what there is was written
    exit_bad_input = 2,       // or usage: nothing was written
    exit_machine_failed = 3,  // disk full, out of memory, ...
};

}  // namespace lancer::app
