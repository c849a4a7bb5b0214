// OpenVDB's files, through a module that is loaded when the first of them is read.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lancer/import/volume/voxel_file.h"

namespace lancer {

// What is wrong is an error at `named_at`, that the module is missing included: files may then still be there in other formats.
std::optional<VoxelFile> read_vdb(std::string_view bytes, const std::string& path, const std::string& grid, const SourcePosition& named_at,
                                  Diagnostics& diagnostics);

}  // namespace lancer
