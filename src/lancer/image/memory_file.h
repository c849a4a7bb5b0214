// Bytes in memory as a file that has a path, for readers that want one.
#pragma once

#include <string>
#include <string_view>

namespace lancer {

// There as long as this object. Throws MachineFailure when the system has no room for it.
class MemoryFile {
public:
    explicit MemoryFile(std::string_view bytes);
    ~MemoryFile();
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    const std::string& path() const { return path_; }

private:
    int descriptor_ = -1;
    std::string path_;
};

}  // namespace lancer
