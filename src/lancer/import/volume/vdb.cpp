#include "lancer/import/volume/vdb.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "lancer/base/failure.h"
#include "lancer/image/modules.h"
#include "lancer/import/volume/module/interface.h"

namespace lancer {

namespace {

constexpr double most_values = 5e8;

const LancerVolumes& volumes_module() {
    static constexpr ModuleWords words = {
        "lancer_volumes.so", "lancer_volumes", "OpenVDB", "libopenvdb10.0", "the part of lancer that reads .vdb files", "libopenvdb-dev"};
    static const LancerVolumes& module = *static_cast<const LancerVolumes*>(find_module(words, lancer_volumes_version, module_folders()));
    return module;
}

struct Received {
    VoxelFile file;
    std::string reason;
};

void take_reason(void* receiver, const char* data, std::size_t size) { static_cast<Received*>(receiver)->reason.append(data, size); }

void take_voxels(void* receiver, const LancerVoxels* voxels) {
    VoxelFile& file = static_cast<Received*>(receiver)->file;
    auto data = std::make_shared<scene::VoxelData>();
    data->size = {voxels->size[0], voxels->size[1], voxels->size[2]};
    data->channels = voxels->channels;
    const std::size_t count = static_cast<std::size_t>(data->size.x) * static_cast<std::size_t>(data->size.y) *
                              static_cast<std::size_t>(data->size.z) * static_cast<std::size_t>(data->channels);
    data->values.assign(voxels->values, voxels->values + count);
    // Simulations leave traces below 0.
    for (float& value : data->values) {
        value = std::max(value, 0.0f);
    }
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            file.to_world[column][row] = voxels->to_world[4 * column + row];
        }
    }
    file.data = std::move(data);
    file.fades = true;
}

}  // namespace

std::optional<VoxelFile> read_vdb(std::string_view bytes, const std::string& path, const std::string& grid, const SourcePosition& named_at,
                                  Diagnostics& diagnostics) {
    Received received;
    try {
        if (!volumes_module().read(bytes.data(), bytes.size(), grid.c_str(), most_values, &received, take_voxels, take_reason)) {
            diagnostics.error(named_at, fmt::format("\"{}\" {}", path, received.reason));
        }
    } catch (const MachineFailure& failure) {
        diagnostics.error(named_at, fmt::format("\"{}\" can't be read: {}", path, failure.what()));
    }
    if (!received.file.data) {
        return std::nullopt;
    }
    const auto& values = received.file.data->values;
    if (!std::all_of(values.begin(), values.end(), [](float value) { return std::isfinite(value); })) {
        diagnostics.error(named_at, fmt::format("\"{}\" holds what is no finite number", path));
        return std::nullopt;
    }
    return std::move(received.file);
}

}  // namespace lancer
