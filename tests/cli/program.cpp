#include "cli/program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace lancer::test {

namespace fs = std::filesystem;

Running::Running(const Folder& folder, const std::vector<std::string>& words, const Environment& environment) {
    // Everything that allocates comes before the fork.
    std::vector<char*> arguments;
    for (const std::string& word : words) {
        arguments.push_back(const_cast<char*>(word.c_str()));
    }
    arguments.push_back(nullptr);
    const std::string out = output_.file("out");
    const std::string err = output_.file("err");
    pid_ = fork();
    if (pid_ < 0) {
        throw std::runtime_error("no process");
    }
    if (pid_ == 0) {
        for (const auto& [name, value] : environment) {
            value.empty() ? unsetenv(name.c_str()) : setenv(name.c_str(), value.c_str(), 1);
        }
        const bool ready = chdir(folder.path().c_str()) == 0 && dup2(open("/dev/null", O_RDONLY), STDIN_FILENO) >= 0 &&
                           dup2(open(out.c_str(), O_WRONLY | O_CREAT, 0600), STDOUT_FILENO) >= 0 &&
                           dup2(open(err.c_str(), O_WRONLY | O_CREAT, 0600), STDERR_FILENO) >= 0;
        if (ready) {
            execvp(arguments.front(), arguments.data());
        }
        _exit(127);
    }
}

Running::~Running() {
    if (!ended_) {
        kill(pid_, SIGKILL);
        collect(true);
    }
}

void Running::signal(int number) const { kill(pid_, number); }

bool Running::collect(bool block) {
    int status = 0;
    if (!ended_ && waitpid(pid_, &status, block ? 0 : WNOHANG) == pid_) {
        ended_ = true;
        status_ = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    }
    return ended_;
}

bool Running::is_alive() { return !collect(false); }

Finished Running::wait() {
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (!collect(false)) {
        if (std::chrono::steady_clock::now() > give_up) {
            kill(pid_, SIGKILL);
            collect(true);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return {status_, output_.read("out"), output_.read("err")};
}

Finished run_lancer(const Folder& folder, const std::vector<std::string>& words, const Environment& environment) {
    std::vector<std::string> command = {LANCER_PROGRAM};
    command.insert(command.end(), words.begin(), words.end());
    Environment whole = {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}, {"SDL_VIDEODRIVER", ""}};
    whole.insert(whole.end(), environment.begin(), environment.end());
    return Running(folder, command, whole).wait();
}

const char* const small_scene = R"([render]
size = [40, 30]

[camera]
position = [0, 1, 5]
look_at = [0, 1, 0]

[camera.above]
position = [0, 6, 0.1]
look_at = [0, 0, 0]

[[light]]
name = "sun"
type = "point"
position = [3, 5, 4]
intensity = 0.75

[[light]]
name = "lamp"
type = "point"
position = [-3, 2, 4]
intensity = 0.25

[material.red]
color = "red"
reflectivity = 0.3

[[sphere]]
center = [0, 1, 0]
radius = 1
material = "red"

[[box]]
min = [-4, -0.2, -4]
max = [4, 0, 4]
)";

std::string scene_file(const std::string& name) { return std::string(LANCER_SOURCE_FOLDER) + "/scenes/" + name; }

}  // namespace lancer::test
