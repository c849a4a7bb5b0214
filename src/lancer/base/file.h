// Whole files in memory.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "lancer/base/diagnostic.h"

namespace lancer {

// The bytes of a file; not zero-terminated.
struct FileBytes {
    std::unique_ptr<char[]> data;
    std::size_t size = 0;

    std::string_view view() const { return {data.get(), size}; }
};

// Reads a regular file. What the user can put right (a missing file, a folder, a lack of permission, more than `limit` bytes) is an error at
// `named_at`, where the user named the file. Throws MachineFailure when the disk fails.
std::optional<FileBytes> read_file(const std::string& path, const SourcePosition& named_at, Diagnostics& diagnostics,
                                   std::size_t limit = static_cast<std::size_t>(-1));

// `path` as seen from the folder of `from_file`; absolute paths stay as they are.
std::string path_beside(const std::string& from_file, const std::string& path);

// The file's ending in lower case with its dot: ".toml"; empty when there is none.
std::string file_ending(const std::string& path);

}  // namespace lancer
