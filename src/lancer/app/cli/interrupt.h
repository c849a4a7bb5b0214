// Ctrl-C: the first one asks the render to stop and keeps what there is, the second one ends the program.
#pragma once

#include <atomic>

namespace lancer::app {

// True after SIGINT or SIGTERM. Handlers are installed by the first call.
const std::atomic<bool>& interrupt_flag();

}  // namespace lancer::app
