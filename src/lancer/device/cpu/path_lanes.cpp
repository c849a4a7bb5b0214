// Compiled once for each instruction set: the path integrator on as many paths as a register holds.
//
// Paths are followed in batches, vertex by vertex: all first vertices of a batch, then all second ones, and so on. After each vertex the paths that
// go on are moved together, so that registers stay full to the end, and neighbours stay neighbours as long as they can.
#include <cstddef>

#include "lancer/device/cpu/follow.h"
#include "lancer/device/cpu/lane_hits.h"
#include "lancer/kernel/path.h"

namespace lancer::LANCER_KERNEL {

constexpr std::size_t BATCH = 1024;  // paths; their states fit into the second-level cache

// A PathState without its mask: rows of registers.
constexpr std::size_t PATH_ROWS = offsetof(PathState, alive) / sizeof(Float);
static_assert(offsetof(PathState, alive) == PATH_ROWS * sizeof(Float) && sizeof(UInt) == sizeof(Float) && sizeof(Int) == sizeof(Float));

struct PathBatch {
    alignas(64) std::uint32_t rows[PATH_ROWS][BATCH + LANES];
    std::uint32_t slots[BATCH + LANES];  // which sample of the range it is
};

// The lanes of `alive` side by side, from `place` on. May write up to LANES entries.
FN void store_together(const UInt& row, unsigned alive, std::uint32_t* place) {
#if defined(__AVX512F__)
    _mm512_storeu_si512(place, _mm512_maskz_compress_epi32(static_cast<__mmask16>(alive), row));
#else
    alignas(64) std::uint32_t lanes[LANES];
    row.store_aligned(lanes);
    for (unsigned left = alive; left != 0; left &= left - 1) {
        *place++ = lanes[__builtin_ctz(left)];
    }
#endif
}

FN std::size_t put_path(const PathState& path, const UInt& slots, unsigned alive, std::size_t place, PathBatch& batch) {
    UInt rows[PATH_ROWS];
    std::memcpy(rows, &path, sizeof(rows));
    for (std::size_t i = 0; i < PATH_ROWS; ++i) {
        store_together(rows[i], alive, batch.rows[i] + place);
    }
    store_together(slots, alive, batch.slots + place);
    return place + static_cast<std::size_t>(__builtin_popcount(alive));
}

FN PathState take_path(const PathBatch& batch, std::size_t place, Mask alive) {
    UInt rows[PATH_ROWS];
    for (std::size_t i = 0; i < PATH_ROWS; ++i) {
        rows[i] = UInt::load_unaligned(batch.rows[i] + place);
    }
    PathState path;
    std::memcpy(&path, rows, sizeof(rows));
    path.alive = alive;
    return path;
}

// What the lanes of `ended` have found.
FN void put_radiance(const kernel::WorldRecord& world, const PathState& path, const UInt& slots, Mask ended, glm::vec3* radiance) {
    const Vec3 rgb = spectrum_to_rgb(world, path.radiance, path.nanometres, ended) * path.weight;
    alignas(64) float x[LANES];
    alignas(64) float y[LANES];
    alignas(64) float z[LANES];
    alignas(64) std::uint32_t slot[LANES];
    rgb.x.store_aligned(x);
    rgb.y.store_aligned(y);
    rgb.z.store_aligned(z);
    slots.store_aligned(slot);
    for (unsigned left = mask_bits(ended); left != 0; left &= left - 1) {
        const int lane = __builtin_ctz(left);
        glm::vec3& out = radiance[slot[lane]];
        out.x = x[lane];
        out.y = y[lane];
        out.z = z[lane];
    }
}

FN Mask first_lanes(std::size_t count) {
    alignas(64) float number[LANES];
    for (int lane = 0; lane < LANES; ++lane) {
        number[lane] = static_cast<float>(lane);
    }
    return Float::load_aligned(number) < Float(static_cast<float>(count));
}

// One vertex of the paths in a register; those that end give what they have found, the others go to `place`.
FN std::size_t follow_vertex(const kernel::WorldRecord& world, int depth, PathState& path, const UInt& slots, std::size_t place,
                             PathBatch& batch, glm::vec3* radiance, RayTally& tally) {
    const Mask before = path.alive;
    path_step(world, depth, path, tally);
    const Mask ended = without(before, path.alive);
    if (some(ended)) {
        put_radiance(world, path, slots, ended, radiance);
    }
    return put_path(path, slots, mask_bits(path.alive), place, batch);
}

#define LANCER_FOLLOW LANCER_JOIN(follow_paths_, LANCER_ISA)

void LANCER_FOLLOW(const kernel::WorldRecord& world, const PathRange& range, glm::vec3* radiance, RayCounts& counts) {
    RayTally tally{0, 0, 0};
    PathBatch batch;  // on the stack, a sixth of a megabyte; filled as far as it is read
    const std::size_t width = static_cast<std::size_t>(range.x1 - range.x0);
    const std::size_t samples = static_cast<std::size_t>(range.sample_count);
    const std::size_t all = range.paths();
    for (std::size_t begin = 0; begin < all; begin += BATCH) {
        const std::size_t end = all - begin < BATCH ? all : begin + BATCH;
        std::size_t going = 0;
        for (std::size_t first = begin; first < end; first += LANES) {
            const std::size_t here = end - first < LANES ? end - first : LANES;
            alignas(64) float x[LANES];
            alignas(64) float y[LANES];
            alignas(64) std::uint32_t columns[LANES];
            alignas(64) std::uint32_t rows[LANES];
            alignas(64) std::uint32_t number[LANES];
            alignas(64) std::uint32_t slot[LANES];
            for (std::size_t lane = 0; lane < LANES; ++lane) {
                const std::size_t path = first + (lane < here ? lane : 0);
                const std::size_t pixel = path / samples;
                columns[lane] = static_cast<std::uint32_t>(range.x0) + static_cast<std::uint32_t>(pixel % width);
                rows[lane] = static_cast<std::uint32_t>(range.y0) + static_cast<std::uint32_t>(pixel / width);
                x[lane] = static_cast<float>(columns[lane]);
                y[lane] = static_cast<float>(rows[lane]);
                number[lane] = static_cast<std::uint32_t>(range.first_sample) + static_cast<std::uint32_t>(path % samples);
                slot[lane] = static_cast<std::uint32_t>(path);
            }
            const UInt key = pixel_key(UInt::load_aligned(columns), UInt::load_aligned(rows), UInt(static_cast<std::uint32_t>(world.seed)));
            PathState path =
                start_path(world, Float::load_aligned(x), Float::load_aligned(y), key, UInt::load_aligned(number), first_lanes(here));
            going = follow_vertex(world, 0, path, UInt::load_aligned(slot), going, batch, radiance, tally);
        }
        for (int depth = 1; going > 0; ++depth) {
            std::size_t kept = 0;
            for (std::size_t first = 0; first < going; first += LANES) {
                const UInt slots = UInt::load_unaligned(batch.slots + first);
                PathState path = take_path(batch, first, first_lanes(going - first));
                kept = follow_vertex(world, depth, path, slots, kept, batch, radiance, tally);
            }
            going = kept;
        }
    }
    counts.camera += static_cast<std::uint64_t>(tally.camera);
    counts.secondary += static_cast<std::uint64_t>(tally.secondary);
    counts.shadow += static_cast<std::uint64_t>(tally.shadow);
}

}  // namespace lancer::LANCER_KERNEL
