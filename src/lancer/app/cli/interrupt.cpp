#include "lancer/app/cli/interrupt.h"

#include <csignal>

namespace lancer::app {

namespace {

// A signal handler has nothing but globals to write to.
std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free);

void on_signal(int) { interrupted.store(true); }

void install(int signal) {
    struct sigaction action = {};
    action.sa_handler = on_signal;
    action.sa_flags = static_cast<int>(SA_RESETHAND);  // the second one has its usual effect
    sigaction(signal, &action, nullptr);
}

}  // namespace

const std::atomic<bool>& interrupt_flag() {
    static const bool installed = (install(SIGINT), install(SIGTERM), true);
    static_cast<void>(installed);
    return interrupted;
}

}  // namespace lancer::app
