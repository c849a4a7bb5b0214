// Other programs: started without a shell, waited for, and listened to.
#pragma once

#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lancer::app {

struct ProgramResult {
    int status = 0;  // its exit status, or 128 and the signal that ended it
    std::string out;
    std::string err;
};

// Looked for in PATH; nothing where there is none.
std::optional<std::string> find_program(const std::string& name);

// Runs `words` with an empty standard input. Throws MachineFailure when it can't be started.
ProgramResult run_program(const std::vector<std::string>& words);

// A program that is written to. What it says goes to standard error.
class ProgramInput {
public:
    explicit ProgramInput(const std::vector<std::string>& words);
    ~ProgramInput();
    ProgramInput(const ProgramInput&) = delete;
    ProgramInput& operator=(const ProgramInput&) = delete;

    // False when the program does not listen any more.
    bool write(std::string_view bytes);
    // Ends its input and waits. The exit status, as above.
    int finish();

private:
    int pid_ = -1;
    int descriptor_ = -1;
};

// The file that this program was started from.
std::string own_path();

}  // namespace lancer::app
