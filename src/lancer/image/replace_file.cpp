#include "lancer/image/replace_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>

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

}  // namespace

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
    do {  // a name may be left over from a process that was killed
        name_ = fmt::format("{}/.lancer-{}-{}.part", folder, ::getpid(), count++);
        descriptor_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    } while (descriptor_ < 0 && (errno == EEXIST || errno == EINTR));
    if (descriptor_ < 0) {
        fail(path_, errno);
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
    const int closed = ::close(descriptor_);  // network file systems report a full disk here
    descriptor_ = -1;
    if (closed != 0 && errno != EINTR) {
        fail(path_, errno);
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
