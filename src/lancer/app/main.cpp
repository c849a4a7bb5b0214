// The program. Everything that can go wrong ends here as a sentence and an exit status.
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "lancer/app/cli/command_line.h"
#include "lancer/app/exit_status.h"
#include "lancer/base/failure.h"

int main(int argc, char** argv) {
    using namespace lancer;
    try {
        return app::run_command_line(std::vector<std::string>(argv + (argc > 0 ? 1 : 0), argv + argc));
    } catch (const MachineFailure& failure) {
        std::fprintf(stderr, "lancer: error: %s\n", failure.what());
    } catch (const std::bad_alloc&) {
        std::fprintf(stderr, "lancer: error: there is not enough memory\n");
    } catch (const std::exception& error) {
        std::fprintf(stderr, "lancer: error: unexpected: %s\n", error.what());
    }
    return app::exit_machine_failed;
}
