// Files with numbers in the cells of a box.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "lancer/base/diagnostic.h"
#include "lancer/scene/media.h"

namespace lancer {

struct VoxelFile {
    std::shared_ptr<const scene::VoxelData> data;
    glm::dmat4 to_world{1.0};  // from the unit cube, as the file has it
    bool fades = false;
};

// What a file may not say itself.
struct VoxelWords {
    std::string name;     // of one grid among several (.vdb); empty: the first
    glm::ivec3 cells{1};  // .raw
    int channels = 1;     // .raw
};

// By the ending of `path`: .vol, the format of Mitsuba (version 3, 32-bit floats); .raw, 32-bit little-endian floats and nothing else; .vdb, OpenVDB.
// Errors stand at `named_at`.
std::optional<VoxelFile> read_voxels(std::string_view bytes, const std::string& path, const VoxelWords& words,
                                     const SourcePosition& named_at, Diagnostics& diagnostics);

}  // namespace lancer
