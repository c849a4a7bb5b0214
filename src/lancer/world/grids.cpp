#include "lancer/world/grids.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/matrix.hpp>

namespace lancer {

namespace {

constexpr int smallest_block = 4;  // cells
constexpr int most_blocks = 64;    // along an axis

kernel::AffineRecord affine(const glm::dmat4& map) {
    kernel::AffineRecord record{};
    kernel::vec3* rows[] = {&record.row_x, &record.row_y, &record.row_z};
    for (int i = 0; i < 3; ++i) {
        *rows[i] = kernel::vec3(glm::dvec3(map[0][i], map[1][i], map[2][i]));
    }
    record.shift = kernel::vec3(glm::dvec3(map[3]));
    return record;
}

// With a layer of zeros around all that is there, whose middles then lie where the values have faded.
scene::Grid padded(const scene::Grid& grid) {
    const scene::VoxelData& inner = *grid.data;
    auto outer = std::make_shared<scene::VoxelData>();
    outer->size = inner.size + 2;
    outer->channels = inner.channels;
    outer->values.resize(static_cast<std::size_t>(outer->size.x) * static_cast<std::size_t>(outer->size.y) *
                         static_cast<std::size_t>(outer->size.z) * static_cast<std::size_t>(outer->channels));
    const auto row = static_cast<std::ptrdiff_t>(inner.size.x) * inner.channels;
    for (std::ptrdiff_t z = 0; z < inner.size.z; ++z) {
        for (std::ptrdiff_t y = 0; y < inner.size.y; ++y) {
            const auto from = inner.values.begin() + (z * inner.size.y + y) * row;
            std::copy(from, from + row, outer->values.begin() + (((z + 1) * outer->size.y + y + 1) * outer->size.x + 1) * outer->channels);
        }
    }
    // The unit cube of the outer cells, seen from that of the inner ones.
    const glm::dvec3 cell = 1.0 / glm::dvec3(inner.size);
    glm::dmat4 grown(1.0);
    for (int i = 0; i < 3; ++i) {
        grown[i][i] = 1.0 + 2.0 * cell[i];
        grown[3][i] = -cell[i];
    }
    return {outer, grid.to_world * grown, false};
}

// What a cell's values are at most, as a density: a smooth spectrum of a color is never more than twice its largest component.
float most_of(const World& world, const float* values, int channels) {
    if (channels == 1) {
        return values[0];
    }
    return std::max({values[0], values[1], values[2]}) * (world.spectral ? 2.0f : 1.0f);
}

void add_blocks(const scene::VoxelData& data, kernel::GridRecord& record, World& world) {
    const int longest = std::max({data.size.x, data.size.y, data.size.z});
    record.block = std::max(smallest_block, (longest + most_blocks - 1) / most_blocks);
    const glm::ivec3 blocks = (data.size + record.block - 1) / record.block;
    record.blocks_x = blocks.x;
    record.blocks_y = blocks.y;
    record.blocks_z = blocks.z;
    record.first_block = static_cast<int>(world.voxels.size());
    std::vector<float> most(static_cast<std::size_t>(blocks.x) * static_cast<std::size_t>(blocks.y) * static_cast<std::size_t>(blocks.z));
    for (int z = 0; z < data.size.z; ++z) {
        for (int y = 0; y < data.size.y; ++y) {
            for (int x = 0; x < data.size.x; ++x) {
                const std::size_t cell =
                    (static_cast<std::size_t>(z) * static_cast<std::size_t>(data.size.y) + static_cast<std::size_t>(y)) *
                        static_cast<std::size_t>(data.size.x) +
                    static_cast<std::size_t>(x);
                const float value = most_of(world, &data.values[cell * static_cast<std::size_t>(data.channels)], data.channels);
                // A cell reaches half a cell beyond itself, into the blocks around.
                const glm::ivec3 low = glm::max(glm::ivec3(x - 1, y - 1, z - 1), 0) / record.block;
                const glm::ivec3 high = glm::min(glm::ivec3(x + 1, y + 1, z + 1), data.size - 1) / record.block;
                for (int k = low.z; k <= high.z; ++k) {
                    for (int j = low.y; j <= high.y; ++j) {
                        for (int i = low.x; i <= high.x; ++i) {
                            float& block = most[static_cast<std::size_t>((k * blocks.y + j) * blocks.x + i)];
                            block = std::max(block, value);
                        }
                    }
                }
            }
        }
    }
    world.voxels.insert(world.voxels.end(), most.begin(), most.end());
}

}  // namespace

int compile_grid(const scene::Grid& written, const SourcePosition& position, World& world, Diagnostics& diagnostics) {
    const scene::Grid grid = written.fades ? padded(written) : written;
    const scene::VoxelData& data = *grid.data;
    const double determinant = glm::determinant(glm::dmat3(grid.to_world));
    if (!(std::abs(determinant) > 0.0) || !std::isfinite(determinant)) {
        diagnostics.error(position, "this medium's grid has no volume");
        return -1;
    }
    if (world.voxels.size() + data.values.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()) / 2) {
        diagnostics.error(position,
                          fmt::format("the grids of this scene are too large: {} values", world.voxels.size() + data.values.size()));
        return -1;
    }
    kernel::GridRecord record{};
    record.to_grid = affine(glm::inverse(grid.to_world));
    record.columns = data.size.x;
    record.rows = data.size.y;
    record.layers = data.size.z;
    record.channels = data.channels;
    record.first = static_cast<int>(world.voxels.size());
    bool bad = false;
    for (const float value : data.values) {
        bad = bad || !std::isfinite(value);
        world.voxels.push_back(std::max(value, 0.0f));
    }
    if (bad) {
        diagnostics.error(position, "this medium's grid holds what is no finite number");
        return -1;
    }
    add_blocks(data, record, world);
    world.grids.push_back(record);
    return static_cast<int>(world.grids.size()) - 1;
}

}  // namespace lancer
