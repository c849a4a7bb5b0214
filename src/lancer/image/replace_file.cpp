#include "lancer/image/replace_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "lancer/base/failure.h"

namespace lancer {
namespace {

[[noreturn]] void fail(const std::string& path, int error) {
    throw MachineFailure(fmt::format("cannot write {}: {}", path, std::strerror(error)));
}

std::string folder_of(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string::npos ? "." : slash == 0 ? "/" : path.substr(0, slash);
}

// Of this machine's files; others may write to the same folder.
std::string start_of_names() {
    char host[256] = {};
    ::gethostname(host, sizeof(host) - 1);
    return fmt::format(".lancer-{}-", host);
}

// Whoever writes a file holds its lock, which ends with the process. Whether the file is still there then.
bool lock(int descriptor) {
    struct stat status {};
    while (::flock(descriptor, LOCK_EX) != 0 && errno == EINTR) {
    }
    return ::fstat(descriptor, &status) != 0 || status.st_nlink > 0;
}

}  // namespace

void remove_leftovers(const std::string& path) {
    const std::string start = start_of_names();
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder_of(path), ignored)) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with(start) || !name.ends_with(".part")) {
            continue;
        }
        const int descriptor = ::open(entry.path().c_str(), O_RDONLY | O_CLOEXEC);
        if (descriptor >= 0 && ::flock(descriptor, LOCK_EX | LOCK_NB) == 0) {
            ::unlink(entry.path().c_str());
        }
        if (descriptor >= 0) {
            ::close(descriptor);
        }
    }
}

ReplacementFile::ReplacementFile(const std::string& path) : path_(path) {
    const std::string folder = folder_of(path);
    struct stat status {};
    if (::stat(folder.c_str(), &status) != 0) {
        throw MachineFailure(errno == ENOENT ? fmt::format("cannot write {}: there is no folder {}", path, folder)
                                             : fmt::format("cannot write {}: {}", path, std::strerror(errno)));
    }
    if (::stat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode)) {
        fail(path, EISDIR);
    }
    static std::atomic<unsigned> count = 0;
    const std::string start = start_of_names();
    for (;;) {  // a name may be left over from a process that was killed
        name_ = fmt::format("{}/{}{}-{}.part", folder, start, ::getpid(), count++);
        descriptor_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor_ >= 0 && lock(descriptor_)) {
            break;
        }
        if (descriptor_ >= 0) {  // taken for a leftover before it was locked
            ::close(descriptor_);
            descriptor_ = -1;
        } else if (errno != EEXIST && errno != EINTR) {
            fail(path_, errno);
        }
    }
}

ReplacementFile::~ReplacementFile() {
    if (descriptor_ >= 0) {
        ::close(descriptor_);
    }
    if (!in_place_) {
        ::unlink(name_.c_str());
    }
}

void ReplacementFile::write(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor_, bytes.data(), std::min<std::size_t>(bytes.size(), 1u << 30));
        if (written < 0 && errno != EINTR) {
            fail(path_, errno);
        }
        bytes.remove_prefix(written > 0 ? static_cast<std::size_t>(written) : 0);
    }
}

void ReplacementFile::flush() {
    while (::fdatasync(descriptor_) != 0) {
        if (errno == EINVAL || errno == ENOSYS) {
            return;  // a file system that knows no such thing
        }
        if (errno != EINTR) {
            fail(path_, errno);
        }
    }
}

void ReplacementFile::put_in_place() {
    // The lock is held until the file has its name: whoever found it without would take it for a leftover.
    const int still_locked = ::fcntl(descriptor_, F_DUPFD_CLOEXEC, 0);
    if (still_locked < 0) {
        fail(path_, errno);
    }
    const int closed = ::close(descriptor_) == 0 ? 0 : errno;  // network file systems report a full disk here
    descriptor_ = still_locked;
    if (closed != 0 && closed != EINTR) {
        fail(path_, closed);
    }
    if (std::rename(name_.c_str(), path_.c_str()) != 0) {
        fail(path_, errno);
    }
    in_place_ = true;
}

void replace_file(const std::string& path, std::string_view bytes) {
    ReplacementFile file(path);
    file.write(bytes);
    file.put_in_place();
}

}  // namespace lancer
