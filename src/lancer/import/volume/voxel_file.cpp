#include "lancer/import/volume/voxel_file.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include <fmt/format.h>

#include "lancer/base/file.h"
#include "lancer/import/volume/vdb.h"

namespace lancer {

namespace {

static_assert(std::endian::native == std::endian::little);

constexpr double most_values = 1e9;

template <class T>
T take(std::string_view bytes, std::size_t at) {
    T value;
    std::memcpy(&value, bytes.data() + at, sizeof(T));
    return value;
}

class Reader {
public:
    Reader(std::string_view bytes, const std::string& path, const SourcePosition& named_at, Diagnostics& diagnostics)
        : bytes_(bytes), path_(path), named_at_(named_at), diagnostics_(diagnostics) {}

    std::optional<VoxelFile> raw(const VoxelWords& words) {
        VoxelFile file;
        file.data = values(0, words.cells, words.channels);
        return file.data ? std::optional(std::move(file)) : std::nullopt;
    }

    // Magic, version, encoding, cells along x, y and z, channels, the box, values.
    std::optional<VoxelFile> vol() {
        constexpr std::size_t header = 48;
        if (bytes_.size() < header || bytes_.substr(0, 3) != "VOL") {
            return fail("is no .vol file");
        }
        if (bytes_[3] != 3 || take<std::int32_t>(bytes_, 4) != 1) {
            return fail(fmt::format("version {} and encoding {} of .vol are not read: only version 3 with 32-bit floats, 1", int(bytes_[3]),
                                    take<std::int32_t>(bytes_, 4)));
        }
        const glm::ivec3 cells(take<std::int32_t>(bytes_, 8), take<std::int32_t>(bytes_, 12), take<std::int32_t>(bytes_, 16));
        const int channels = take<std::int32_t>(bytes_, 20);
        if (channels != 1 && channels != 3) {
            return fail(fmt::format("has {} channels; 1 or 3 are read", channels));
        }
        VoxelFile file;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double low = static_cast<double>(take<float>(bytes_, 24 + 4 * axis)),
                         high = static_cast<double>(take<float>(bytes_, 36 + 4 * axis));
            if (!(high > low) || !std::isfinite(low) || !std::isfinite(high)) {
                return fail(fmt::format("lies in a box from {} to {} along {}", low, high, "xyz"[axis]));
            }
            const auto i = static_cast<int>(axis);
            file.to_world[i][i] = high - low;
            file.to_world[3][i] = low;
        }
        file.data = values(header, cells, channels);
        return file.data ? std::optional(std::move(file)) : std::nullopt;
    }

    std::nullopt_t fail(const std::string& problem) {
        diagnostics_.error(named_at_, fmt::format("\"{}\" {}", path_, problem));
        return std::nullopt;
    }

private:
    std::shared_ptr<const scene::VoxelData> values(std::size_t begin, const glm::ivec3& cells, int channels) {
        const double count = static_cast<double>(cells.x) * cells.y * cells.z * channels;
        if (cells.x < 1 || cells.y < 1 || cells.z < 1 || count > most_values) {
            fail(fmt::format("has {} x {} x {} cells", cells.x, cells.y, cells.z));
            return nullptr;
        }
        const auto size = static_cast<std::size_t>(count) * sizeof(float);
        if (bytes_.size() != begin + size) {
            fail(fmt::format("should have {} bytes for {} x {} x {} cells of {} channel{}, and has {}", begin + size, cells.x, cells.y,
                             cells.z, channels, channels > 1 ? "s" : "", bytes_.size()));
            return nullptr;
        }
        auto data = std::make_shared<scene::VoxelData>();
        data->size = cells;
        data->channels = channels;
        data->values.resize(static_cast<std::size_t>(count));
        std::memcpy(data->values.data(), bytes_.data() + begin, size);
        for (const float value : data->values) {
            if (!std::isfinite(value) || value < 0.0f) {
                fail(fmt::format("holds {}: expected finite numbers of at least 0", value));
                return nullptr;
            }
        }
        return data;
    }

    std::string_view bytes_;
    const std::string& path_;
    const SourcePosition& named_at_;
    Diagnostics& diagnostics_;
};

}  // namespace

std::optional<VoxelFile> read_voxels(std::string_view bytes, const std::string& path, const VoxelWords& words,
                                     const SourcePosition& named_at, Diagnostics& diagnostics) {
    Reader reader(bytes, path, named_at, diagnostics);
    const std::string ending = file_ending(path);
    if (ending == ".raw") {
        return reader.raw(words);
    }
    if (ending == ".vol") {
        return reader.vol();
    }
    if (ending == ".vdb") {
        return read_vdb(bytes, path, words.name, named_at, diagnostics);
    }
    return reader.fail("is no grid: those are read from .vdb, .vol and .raw files");
}

}  // namespace lancer
