// Compiled once for each instruction set: the path integrator on as many paths as a register holds.
//
// Paths are followed in batches, vertex by vertex: all first vertices of a batch, then all second ones, and so on. After each vertex the paths that
// go on are moved together, so that registers stay full to the end. Those that go the same way are taken together: trees are descended, and objects
// that no ray of a register can meet are thrown out, the better the more the rays have in common. What a path finds does not depend on that.
#include <cstddef>
#include <limits>

#include "lancer/device/cpu/follow.h"
#include "lancer/device/cpu/lane_hits.h"
#include "lancer/kernel/outcome.h"

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

FN UInt take_row(const std::uint32_t* row, const UInt& places) {
#if defined(__AVX512F__)
    return _mm512_i32gather_epi32(places, row, 4);
#else
    alignas(64) std::uint32_t at[LANES];
    alignas(64) std::uint32_t values[LANES];
    places.store_aligned(at);
    for (int lane = 0; lane < LANES; ++lane) {
        values[lane] = row[at[lane]];
    }
    return UInt::load_aligned(values);
#endif
}

FN PathState take_path(const PathBatch& batch, const UInt& places, Mask alive) {
    UInt rows[PATH_ROWS];
    for (std::size_t i = 0; i < PATH_ROWS; ++i) {
        rows[i] = take_row(batch.rows[i], places);
    }
    PathState path;
    std::memcpy(&path, rows, sizeof(rows));
    path.alive = alive;
    return path;
}

// The places of the paths by the octant of their direction; within it as they stand.
FN void order_by_direction(const PathBatch& batch, std::size_t count, std::uint32_t* places) {
    constexpr std::size_t direction = offsetof(PathState, direction) / sizeof(Float);
    const auto octant = [&](std::size_t i) {
        return batch.rows[direction][i] >> 31 | (batch.rows[direction + 1][i] >> 31) << 1 | (batch.rows[direction + 2][i] >> 31) << 2;
    };
    std::uint32_t next[9] = {};
    for (std::size_t i = 0; i < count; ++i) {
        ++next[octant(i) + 1];
    }
    for (int k = 1; k < 8; ++k) {
        next[k] += next[k - 1];
    }
    for (std::size_t i = 0; i < count; ++i) {
        places[next[octant(i)]++] = static_cast<std::uint32_t>(i);
    }
    for (std::size_t i = 0; i < LANES; ++i) {
        places[count + i] = 0;
    }
}

// The lanes of a vector, to be handed over one by one.
struct LanesOf3 {
    alignas(64) float x[LANES];
    alignas(64) float y[LANES];
    alignas(64) float z[LANES];
};

FN void store_lanes(const Vec3& v, LanesOf3& lanes) {
    v.x.store_aligned(lanes.x);
    v.y.store_aligned(lanes.y);
    v.z.store_aligned(lanes.z);
}

FN void set(glm::vec3& to, const LanesOf3& lanes, int lane) {
    to.x = lanes.x[lane];
    to.y = lanes.y[lane];
    to.z = lanes.z[lane];
}

FN void put_colors(const Vec3& colors, const UInt& slots, Mask mask, glm::vec3* places) {
    LanesOf3 rgb;
    alignas(64) std::uint32_t slot[LANES];
    store_lanes(colors, rgb);
    slots.store_aligned(slot);
    for (unsigned left = mask_bits(mask); left != 0; left &= left - 1) {
        const int lane = __builtin_ctz(left);
        set(places[slot[lane]], rgb, lane);
    }
}

FN void put_spectra(const WorldRecord& world, const PathState& path, const UInt& slots, Mask mask, SpectralSample* places) {
    const Spectrum power = power_in_pixel(world, path, mask);
    const Float numbers[8] = {power.x,           power.y,           power.z,           power.w,
                              path.nanometres.x, path.nanometres.y, path.nanometres.z, path.nanometres.w};
    alignas(64) float lanes[8][LANES];
    alignas(64) std::uint32_t slot[LANES];
    for (int i = 0; i < 8; ++i) {
        numbers[i].store_aligned(lanes[i]);
    }
    slots.store_aligned(slot);
    for (unsigned left = mask_bits(mask); left != 0; left &= left - 1) {
        const int lane = __builtin_ctz(left);
        SpectralSample& place = places[slot[lane]];
        place.power.x = lanes[0][lane];
        place.power.y = lanes[1][lane];
        place.power.z = lanes[2][lane];
        place.power.w = lanes[3][lane];
        place.nanometres.x = lanes[4][lane];
        place.nanometres.y = lanes[5][lane];
        place.nanometres.z = lanes[6][lane];
        place.nanometres.w = lanes[7][lane];
    }
}

// What the lanes of `ended` have found.
FN void put_radiance(const kernel::WorldRecord& world, const PathState& path, const UInt& slots, Mask ended, const PathSamples& samples) {
    const Vec3 rgb = light_in_pixel(world, path, path.radiance, ended);
    const Vec3 none = vec3_all(Float(std::numeric_limits<float>::quiet_NaN()));
    put_colors(select(is_sound(path.radiance), rgb, none), slots, ended, samples.radiance.data());
    if (!samples.spectra.empty()) {
        put_spectra(world, path, slots, ended, samples.spectra.data());
    }
}

FN void put_first_hits(const kernel::WorldRecord& world, const PathState& path, const Sight& sight, const Vec3& view, const UInt& slots,
                       Mask alive, FirstHit* places) {
    const PathVertex& vertex = sight.vertex;
    Vec3 normal = select(dot(vertex.point.shading, view) > Float(0.0f), -vertex.point.shading, vertex.point.shading);
    LanesOf3 albedo, normals, position, uv_depth;
    alignas(64) float weight[LANES];
    alignas(64) std::int32_t object[LANES];
    alignas(64) std::int32_t material[LANES];
    alignas(64) std::uint32_t slot[LANES];
    store_lanes(vertex.albedo, albedo);
    store_lanes(normal, normals);
    store_lanes(vertex.point.position, position);
    store_lanes(vec3_of(vertex.uv.x, vertex.uv.y, depth_of(world.camera, vertex.point.position)), uv_depth);
    path.weight.store_aligned(weight);
    sight.hit.object.store_aligned(object);
    vertex.material.store_aligned(material);
    slots.store_aligned(slot);
    for (unsigned left = mask_bits(alive); left != 0; left &= left - 1) {
        const int lane = __builtin_ctz(left);
        FirstHit hit;
        hit.weight = weight[lane];
        if (object[lane] >= 0) {
            set(hit.albedo, albedo, lane);
            set(hit.normal, normals, lane);
            set(hit.position, position, lane);
            hit.uv.x = uv_depth.x[lane];
            hit.uv.y = uv_depth.y[lane];
            hit.depth = uv_depth.z[lane];
            hit.object = object[lane];
            hit.material = material[lane];
        }
        places[slot[lane]] = hit;
    }
}

FN Mask first_lanes(std::size_t count) {
    alignas(64) float number[LANES];
    for (int lane = 0; lane < LANES; ++lane) {
        number[lane] = static_cast<float>(lane);
    }
    return Float::load_aligned(number) < Float(static_cast<float>(count));
}

// One call's work: what is asked for, of which world.
struct PathWork {
    const kernel::WorldRecord& world;
    kernel::WorldRecord watched;  // the same, whose steps tell what they meet
    const PathSamples& samples;
    PathBatch* batch;  // where those that go on are put
};

// One vertex of the paths in a register; those that end give what they have found, the others go to `place`.
FN std::size_t follow_vertex(PathWork& work, int depth, PathState& path, const UInt& slots, std::size_t place, RayTally& tally) {
    const Mask before = path.alive;
    const Vec3 view = path.direction;
    const bool first = depth == 0 && !work.samples.first_hits.empty();
    const bool direct = depth <= 1 && !work.samples.direct.empty();
    Sight sight;
    if (first || direct) {
        sight.vertex = no_vertex();
        path_step(work.watched, depth, path, sight, tally);
    } else {
        path_step(work.world, depth, path, sight, tally);
    }
    const Mask ended = without(before, path.alive);
    if (some(ended)) {
        put_radiance(work.world, path, slots, ended, work.samples);
    }
    if (first) {
        put_first_hits(work.world, path, sight, view, slots, before, work.samples.first_hits.data());
    }
    if (direct) {
        // Light that the second vertex asks for has been scattered twice. A path that ends at the first has asked for none there, or all that it
        // asked for counts.
        const Spectrum light = depth == 0 ? path.radiance : sight.met;
        put_colors(light_in_pixel(work.world, path, light, before), slots, before, work.samples.direct.data());
    }
    return put_path(path, slots, mask_bits(path.alive), place, *work.batch);
}

FN kernel::WorldRecord watched(const kernel::WorldRecord& world) {
    kernel::WorldRecord result = world;
    result.watched = 1;
    return result;
}

#define LANCER_TRACE LANCER_JOIN(trace_paths_, LANCER_ISA)
#define LANCER_FAULT LANCER_JOIN(find_fault_, LANCER_ISA)

void LANCER_TRACE(const kernel::WorldRecord& world, const PathRange& range, const PathSamples& samples_asked, RayCounts& counts) {
    RayTally tally{0, 0, 0};
    PathBatch batches[2];  // on the stack, a third of a megabyte; filled as far as they are read
    std::uint32_t places[BATCH + LANES];
    PathWork work{world, watched(world), samples_asked, &batches[0]};
    const std::size_t width = static_cast<std::size_t>(range.x1 - range.x0);
    const std::size_t samples = static_cast<std::size_t>(range.sample_count);
    const std::size_t all = range.paths();
    for (std::size_t begin = 0; begin < all; begin += BATCH) {
        const std::size_t end = all - begin < BATCH ? all : begin + BATCH;
        std::size_t going = 0;
        work.batch = &batches[0];
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
            going = follow_vertex(work, 0, path, UInt::load_aligned(slot), going, tally);
        }
        for (int depth = 1; going > 0; ++depth) {
            const PathBatch& batch = *work.batch;
            work.batch = &batch == &batches[0] ? &batches[1] : &batches[0];
            order_by_direction(batch, going, places);
            std::size_t kept = 0;
            for (std::size_t first = 0; first < going; first += LANES) {
                const UInt here = UInt::load_unaligned(places + first);
                const UInt slots = take_row(batch.slots, here);
                PathState path = take_path(batch, here, first_lanes(going - first));
                kept = follow_vertex(work, depth, path, slots, kept, tally);
            }
            going = kept;
        }
    }
    counts.camera += static_cast<std::uint64_t>(tally.camera);
    counts.secondary += static_cast<std::uint64_t>(tally.secondary);
    counts.shadow += static_cast<std::uint64_t>(tally.shadow);
}

FN PathFault::What wrong_with(const Spectrum& light) {
    PathFault::What what = PathFault::What::none;
    for (const float value : {lane_of(light.x, 0), lane_of(light.y, 0), lane_of(light.z, 0), lane_of(light.w, 0)}) {
        if (!(value == value)) {
            return PathFault::What::not_a_number;
        }
        if (value < 0.0f) {
            what = PathFault::What::negative;
        } else if (value > FAR && what == PathFault::What::none) {
            what = PathFault::What::infinite;
        }
    }
    return what;
}

PathFault LANCER_FAULT(const kernel::WorldRecord& world, int x, int y, int sample) {
    RayTally tally{0, 0, 0};
    const kernel::WorldRecord record = watched(world);
    const UInt key =
        pixel_key(UInt(static_cast<std::uint32_t>(x)), UInt(static_cast<std::uint32_t>(y)), UInt(static_cast<std::uint32_t>(world.seed)));
    PathState path = start_path(world, Float(static_cast<float>(x)), Float(static_cast<float>(y)), UInt(key),
                                UInt(static_cast<std::uint32_t>(sample)), first_lanes(1));
    Sight sight;
    PathFault fault;
    for (int depth = 0; some(path.alive) && fault.what == PathFault::What::none; ++depth) {
        sight.vertex = no_vertex();
        path_step(record, depth, path, sight, tally);
        fault.what = wrong_with(path.radiance);
        if (fault.what == PathFault::What::none && some(path.alive)) {
            fault.what = wrong_with(path.throughput);
        }
        fault.vertex = depth;
        fault.object = lane_of(sight.hit.object, 0);
        fault.material = fault.object >= 0 ? lane_of(sight.vertex.material, 0) : -1;
    }
    return fault;
}

}  // namespace lancer::LANCER_KERNEL
