#include "lancer/image/memory_file.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include <fmt/format.h>

#include "lancer/base/failure.h"

namespace lancer {

MemoryFile::MemoryFile(std::string_view bytes) : descriptor_(::memfd_create("lancer", MFD_CLOEXEC)) {
    const auto fail = [&] {
        const int reason = errno;
        if (descriptor_ >= 0) {
            ::close(descriptor_);
        }
        throw MachineFailure(fmt::format("cannot keep {} bytes as a file in memory: {}", bytes.size(), std::strerror(reason)));
    };
    if (descriptor_ < 0) {
        fail();
    }
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR) {
            fail();
        }
        bytes.remove_prefix(written > 0 ? static_cast<std::size_t>(written) : 0);
    }
    path_ = fmt::format("/proc/self/fd/{}", descriptor_);
}

MemoryFile::~MemoryFile() { ::close(descriptor_); }

}  // namespace lancer
