#include "lancer/app/farm/program.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "lancer/base/failure.h"

extern char** environ;

namespace lancer::app {

namespace {

struct Pipe {
    int read = -1;
    int write = -1;

    Pipe() {
        std::array<int, 2> ends{};
        if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
            throw MachineFailure(fmt::format("no pipe to another program: {}", std::strerror(errno)));
        }
        read = ends[0];
        write = ends[1];
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    ~Pipe() {
        close_end(read);
        close_end(write);
    }
    static void close_end(int& end) {
        if (end >= 0) {
            ::close(end);
            end = -1;
        }
    }
};

class FileActions {
public:
    FileActions() { posix_spawn_file_actions_init(&actions_); }
    ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
    FileActions(const FileActions&) = delete;
    FileActions& operator=(const FileActions&) = delete;

    void move(int from, int to) { posix_spawn_file_actions_adddup2(&actions_, from, to); }
    void read_nothing() { posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0); }
    const posix_spawn_file_actions_t* get() const { return &actions_; }

private:
    posix_spawn_file_actions_t actions_{};
};

pid_t start(const std::vector<std::string>& words, const FileActions& actions) {
    std::vector<std::string> copies = words;
    std::vector<char*> pointers;
    for (std::string& word : copies) {
        pointers.push_back(word.data());
    }
    pointers.push_back(nullptr);
    pid_t pid = -1;
    if (const int error = posix_spawnp(&pid, pointers.front(), actions.get(), nullptr, pointers.data(), environ); error != 0) {
        throw MachineFailure(fmt::format("cannot start {}: {}", words.front(), std::strerror(error)));
    }
    return pid;
}

int wait_for(pid_t pid) {
    int status = 0;
    while (::waitpid(pid, &status, 0) < 0) {
        if (errno != EINTR) {
            return 127;
        }
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

std::optional<std::string> find_program(const std::string& name) {
    const char* const path = std::getenv("PATH");
    const std::string list = path != nullptr ? path : "/usr/bin:/bin";
    for (std::size_t begin = 0; begin <= list.size();) {
        const std::size_t end = std::min(list.find(':', begin), list.size());
        const std::string file = (std::filesystem::path(list.substr(begin, end - begin)) / name).string();
        std::error_code ignored;
        if (::access(file.c_str(), X_OK) == 0 && std::filesystem::is_regular_file(file, ignored)) {
            return file;
        }
        begin = end + 1;
    }
    return std::nullopt;
}

ProgramResult run_program(const std::vector<std::string>& words) {
    Pipe out, err;
    FileActions actions;
    actions.read_nothing();
    actions.move(out.write, STDOUT_FILENO);
    actions.move(err.write, STDERR_FILENO);
    const pid_t pid = start(words, actions);
    Pipe::close_end(out.write);
    Pipe::close_end(err.write);
    ProgramResult result;
    std::array<pollfd, 2> listened = {pollfd{out.read, POLLIN, 0}, pollfd{err.read, POLLIN, 0}};
    std::array<std::string*, 2> texts = {&result.out, &result.err};
    while (listened[0].fd >= 0 || listened[1].fd >= 0) {
        if (::poll(listened.data(), listened.size(), -1) < 0 && errno != EINTR) {
            break;
        }
        for (std::size_t i = 0; i < listened.size(); ++i) {
            if (listened[i].fd < 0 || listened[i].revents == 0) {
                continue;
            }
            std::array<char, 4096> bytes{};
            const ssize_t count = ::read(listened[i].fd, bytes.data(), bytes.size());
            if (count > 0) {
                texts[i]->append(bytes.data(), static_cast<std::size_t>(count));
            } else if (count == 0 || errno != EINTR) {
                listened[i].fd = -1;  // poll passes over it
            }
        }
    }
    result.status = wait_for(pid);
    return result;
}

ProgramInput::ProgramInput(const std::vector<std::string>& words) {
    Pipe pipe;
    FileActions actions;
    actions.move(pipe.read, STDIN_FILENO);
    actions.move(STDERR_FILENO, STDOUT_FILENO);
    pid_ = start(words, actions);
    descriptor_ = std::exchange(pipe.write, -1);
}

ProgramInput::~ProgramInput() { finish(); }

bool ProgramInput::write(std::string_view bytes) {
    // A program that ended is an error of write(), not the end of this one.
    struct sigaction ignore {
    }, before{};
    ignore.sa_handler = SIG_IGN;
    ::sigaction(SIGPIPE, &ignore, &before);
    bool good = descriptor_ >= 0;
    while (good && !bytes.empty()) {
        const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
        good = count >= 0 || errno == EINTR;
        bytes.remove_prefix(count > 0 ? static_cast<std::size_t>(count) : 0);
    }
    ::sigaction(SIGPIPE, &before, nullptr);
    return good;
}

int ProgramInput::finish() {
    Pipe::close_end(descriptor_);
    return pid_ >= 0 ? wait_for(std::exchange(pid_, -1)) : 0;
}

std::string own_path() {
    std::error_code error;
    const std::filesystem::path path = std::filesystem::read_symlink("/proc/self/exe", error);
    return error ? "lancer" : path.string();
}

}  // namespace lancer::app
