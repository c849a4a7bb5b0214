#include "lancer/base/file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "lancer/base/failure.h"

namespace lancer {

namespace {

class Descriptor {
public:
    explicit Descriptor(const std::string& path) : number_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {}
    ~Descriptor() {
        if (number_ >= 0) {
            ::close(number_);
        }
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int number() const { return number_; }

private:
    int number_;
};

}  // namespace

std::optional<FileBytes> read_file(const std::string& path, const SourcePosition& named_at, Diagnostics& diagnostics, std::size_t limit) {
    const auto refuse = [&](const std::string& why) {
        diagnostics.error(named_at, fmt::format("cannot read \"{}\": {}", path, why));
        return std::nullopt;
    };
    if (path.find('\0') != std::string::npos) {
        return refuse("its name contains a zero byte");
    }
    const Descriptor file(path);  // O_NONBLOCK: a named pipe must not hang us
    if (file.number() < 0) {
        const int reason = errno;
        if (reason == EMFILE || reason == ENFILE || reason == ENOMEM || reason == EIO) {
            throw MachineFailure(fmt::format("cannot read \"{}\": {}", path, std::strerror(reason)));
        }
        return refuse(reason == ENOENT ? "there is no such file" : std::strerror(reason));
    }
    struct stat facts {};
    if (::fstat(file.number(), &facts) != 0) {
        throw MachineFailure(fmt::format("cannot read \"{}\": {}", path, std::strerror(errno)));
    }
    if (S_ISDIR(facts.st_mode)) {
        return refuse("it is a folder");
    }
    if (!S_ISREG(facts.st_mode)) {
        return refuse("it is not a regular file");
    }
    const std::size_t size = static_cast<std::size_t>(facts.st_size);
    if (size > limit) {
        return refuse(fmt::format("it has {} bytes, and at most {} are accepted", size, limit));
    }

    FileBytes bytes{std::make_unique_for_overwrite<char[]>(size), 0};
    while (bytes.size < size) {
        const ssize_t count = ::read(file.number(), bytes.data.get() + bytes.size, size - bytes.size);
        if (count == 0) {
            break;  // it shrank while we read; the parser will say what is missing
        }
        if (count < 0) {
            if (errno == EINTR) {
                continue;
            }
            throw MachineFailure(fmt::format("cannot read \"{}\": {}", path, std::strerror(errno)));
        }
        bytes.size += static_cast<std::size_t>(count);
    }
    return bytes;
}

std::string path_beside(const std::string& from_file, const std::string& path) {
    return (std::filesystem::path(from_file).parent_path() / path).lexically_normal().string();
}

std::string file_ending(const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    for (char& c : ending) {
        if (c >= 'A' && c <= 'Z') {
            c = static_cast<char>(c - 'A' + 'a');
        }
    }
    return ending;
}

}  // namespace lancer
