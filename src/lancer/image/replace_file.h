// Whole files, written so that a reader sees either the old one or the new one.
#pragma once

#include <string>
#include <string_view>

namespace lancer {

// Writes `bytes` to a temporary file in the folder of `path` and renames it to `path`. Throws MachineFailure with the path and the reason (no
// such folder, disk full, read-only, ...); the temporary is removed then, and what stood at `path` is untouched.
void replace_file(const std::string& path, std::string_view bytes);

}  // namespace lancer
