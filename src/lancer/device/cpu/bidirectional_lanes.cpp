// Compiled once for each instruction set: paths from both ends, as many as a register holds together, each with a path of light of its own.
#include <cstddef>
#include <limits>
#include <vector>

#include "lancer/device/cpu/follow.h"
#include "lancer/device/cpu/lane_hits.h"
#include "lancer/device/cpu/photon_map.h"
#include "lancer/kernel/bidirectional.h"

namespace lancer::LANCER_KERNEL {

// What is too large for registers: the vertices of the paths of light, one for each depth, each for all lanes; where their light falls; and the photons
// that were gathered last, for each lane. The world's record points to it.
struct Store {
    std::vector<BidirVertex> vertices;
    std::vector<Splat>* splats = nullptr;
    const PhotonMap* photons = nullptr;
    std::vector<const PhotonRecord*> gathered[LANES];
};

FN Store& store_of(IN(WorldRecord) world) { return *reinterpret_cast<Store*>(const_cast<int*>(world.light_vertices)); }

void keep_light_vertex(IN(WorldRecord) world, int number, IN(BidirVertex) vertex) {
    store_of(world).vertices[static_cast<std::size_t>(number)] = vertex;
}

BidirVertex light_vertex(IN(WorldRecord) world, int number) { return store_of(world).vertices[static_cast<std::size_t>(number)]; }

// The map has the radius of the sample that it was made for.
Int gather_photons(IN(WorldRecord) world, Vec3 position, Float, Mask mask) {
    Store& store = store_of(world);
    alignas(64) float x[LANES], y[LANES], z[LANES];
    alignas(64) std::int32_t count[LANES] = {};
    position.x.store_aligned(x);
    position.y.store_aligned(y);
    position.z.store_aligned(z);
    for (unsigned left = mask_bits(mask); left != 0; left &= left - 1) {
        const int lane = __builtin_ctz(left);
        store.gathered[lane].clear();
        store.photons->gather(vec3(x[lane], y[lane], z[lane]), store.gathered[lane]);
        count[lane] = static_cast<std::int32_t>(store.gathered[lane].size());
    }
    return Int::load_aligned(count);
}

Photon gathered_photon(IN(WorldRecord) world, int number, Mask mask) {
    const Store& store = store_of(world);
    constexpr int floats = 16;
    alignas(64) float rows[floats][LANES] = {};
    alignas(64) std::int32_t depth[LANES] = {};
    alignas(64) float single[LANES] = {};
    for (unsigned left = mask_bits(mask); left != 0; left &= left - 1) {
        const int lane = __builtin_ctz(left);
        const PhotonRecord& p = *store.gathered[lane][static_cast<std::size_t>(number)];
        for (int axis = 0; axis < 3; ++axis) {
            rows[axis][lane] = p.position[axis];
            rows[3 + axis][lane] = p.normal[axis];
            rows[6 + axis][lane] = p.from[axis];
        }
        for (int i = 0; i < 4; ++i) {
            rows[9 + i][lane] = p.light[i];
        }
        rows[13][lane] = p.meet;
        rows[14][lane] = p.join;
        rows[15][lane] = p.merge;
        depth[lane] = static_cast<std::int32_t>(p.depth_and_single / 2u);
        single[lane] = (p.depth_and_single & 1u) != 0 ? 1.0f : 0.0f;
    }
    const auto row = [&](int i) { return Float::load_aligned(rows[i]); };
    Photon p;
    p.position = vec3_of(row(0), row(1), row(2));
    p.normal = vec3_of(row(3), row(4), row(5));
    p.from = vec3_of(row(6), row(7), row(8));
    p.light = vec4_of(row(9), row(10), row(11), row(12));
    p.ways.meet = row(13);
    p.ways.join = row(14);
    p.ways.merge = row(15);
    p.depth = Int::load_aligned(depth);
    p.single = Float::load_aligned(single) > Float(0.5f);
    return p;
}

FN void put_photons(IN(BidirVertex) v, int depth, std::vector<PhotonRecord>* of_lanes) {
    const Vec3 from = to_world(v.frame, v.wo);
    const Float numbers[16] = {v.position.x,   v.position.y, v.position.z, v.normal.x,     v.normal.y,     v.normal.z,
                               from.x,         from.y,       from.z,       v.throughput.x, v.throughput.y, v.throughput.z,
                               v.throughput.w, v.ways.meet,  v.ways.join,  v.ways.merge};
    alignas(64) float rows[16][LANES];
    for (int i = 0; i < 16; ++i) {
        numbers[i].store_aligned(rows[i]);
    }
    for (unsigned left = mask_bits(v.valid); left != 0; left &= left - 1) {
        const int lane = __builtin_ctz(left);
        PhotonRecord p;
        for (int axis = 0; axis < 3; ++axis) {
            p.position[axis] = rows[axis][lane];
            p.normal[axis] = rows[3 + axis][lane];
            p.from[axis] = rows[6 + axis][lane];
        }
        for (int i = 0; i < 4; ++i) {
            p.light[i] = rows[9 + i][lane];
        }
        p.meet = rows[13][lane];
        p.join = rows[14][lane];
        p.merge = rows[15][lane];
        p.depth_and_single = 2u * static_cast<std::uint32_t>(depth) + (lane_is_on(v.single, lane) ? 1u : 0u);
        of_lanes[lane].push_back(p);
    }
}

#define LANCER_PHOTONS LANCER_JOIN(trace_photons_, LANCER_ISA)

// Path by path, whatever the number of lanes.
std::vector<PhotonRecord> LANCER_PHOTONS(const kernel::WorldRecord& world, int sample, int first, int count) {
    std::vector<PhotonRecord> photons;
    const MergeWeights merging = merge_weights(photon_field(world, sample));
    for (int begin = 0; begin < count; begin += LANES) {
        alignas(64) float on[LANES];
        alignas(64) std::uint32_t number[LANES];
        for (int lane = 0; lane < LANES; ++lane) {
            on[lane] = begin + lane < count ? 1.0f : 0.0f;
            number[lane] = static_cast<std::uint32_t>(first + begin + lane);
        }
        const Mask mask = Float::load_aligned(on) > Float(0.5f);
        const Vec4 nanometres = photon_wavelengths(world, sample, mask);
        LightStart start;
        Subpath lit = start_from_light(world, number_of_photons(sample, UInt::load_aligned(number)), nanometres, mask, start);
        std::vector<PhotonRecord> of_lanes[LANES];
        for (int depth = 0; some(lit.path.alive); ++depth) {
            BidirVertex v;
            photon_step(world, depth, start, merging, lit, v);
            v.valid = both(v.valid, is_sound(v.throughput));
            if (some(v.valid)) {
                put_photons(v, depth, of_lanes);
            }
        }
        for (const std::vector<PhotonRecord>& own : of_lanes) {
            photons.insert(photons.end(), own.begin(), own.end());
        }
    }
    return photons;
}

#define LANCER_RADIUS LANCER_JOIN(photon_radius_, LANCER_ISA)

float LANCER_RADIUS(const kernel::WorldRecord& world, int sample) { return lane_of(photon_field(world, sample).radius, 0); }

// All pixels whose filter reaches the place.
void put_splat(IN(WorldRecord) world, IN(FilmSplat) splat, Vec4 nanometres) {
    if (!some(splat.valid)) {
        return;
    }
    std::vector<Splat>& splats = *store_of(world).splats;
    const Vec3 rgb = spectrum_to_rgb(world, splat.light, nanometres, splat.valid);
    const float radius = world.filter_record.radius;
    const int reach = static_cast<int>(2.0f * radius) + 2;  // pixels along one side, at most
    const int width = static_cast<int>(world.camera.width);
    const int height = static_cast<int>(world.camera.height);
    const Float first_x = floor(splat.film.x - Float(radius + 0.5f)) + Float(0.5f);  // the middle of the first pixel
    const Float first_y = floor(splat.film.y - Float(radius + 0.5f)) + Float(0.5f);
    alignas(64) float r[LANES], g[LANES], b[LANES], x0[LANES], y0[LANES];
    rgb.x.store_aligned(r);
    rgb.y.store_aligned(g);
    rgb.z.store_aligned(b);
    first_x.store_aligned(x0);
    first_y.store_aligned(y0);
    std::vector<Float> across, down;
    for (int i = 0; i < reach; ++i) {
        across.push_back(filter_value(world, first_x + Float(static_cast<float>(i)) - splat.film.x, splat.valid));
        down.push_back(filter_value(world, first_y + Float(static_cast<float>(i)) - splat.film.y, splat.valid));
    }
    for (unsigned left = mask_bits(splat.valid); left != 0; left &= left - 1) {
        const int lane = __builtin_ctz(left);
        for (int j = 0; j < reach; ++j) {
            const float wy = lane_of(down[static_cast<std::size_t>(j)], lane);
            const int y = static_cast<int>(y0[lane] - 0.5f) + j;
            if (wy == 0.0f || y < 0 || y >= height) {
                continue;
            }
            for (int i = 0; i < reach; ++i) {
                const float w = wy * lane_of(across[static_cast<std::size_t>(i)], lane);
                int x = static_cast<int>(x0[lane] - 0.5f) + i;
                if (world.camera.kind == CAMERA_PANORAMA) {
                    x = x < 0 ? x + width : x >= width ? x - width : x;
                }
                if (w == 0.0f || x < 0 || x >= width) {
                    continue;
                }
                Splat one;
                one.pixel = static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(width) + static_cast<std::uint32_t>(x);
                one.light.x = r[lane] * w;
                one.light.y = g[lane] * w;
                one.light.z = b[lane] * w;
                splats.push_back(one);
            }
        }
    }
}

#define LANCER_BIDIRECTIONAL LANCER_JOIN(trace_bidirectional_, LANCER_ISA)

void LANCER_BIDIRECTIONAL(const kernel::WorldRecord& asked, const PathRange& range, PhotonMaps* maps, const PathSamples& samples,
                          RayCounts& counts) {
    RayTally tally{0, 0, 0};
    kernel::WorldRecord world = asked;
    const bool light_only = world.halves == HALF_OF_LIGHT;
    Store store;
    store.vertices.resize(static_cast<std::size_t>(light_only ? 0 : world.max_depth + 1));
    store.splats = samples.splats;
    world.light_vertices = reinterpret_cast<const int*>(&store);
    PhotonsInUse photons(maps);
    int sample_of_photons = -1;
    PhotonField field = photon_field(world, 0);
    MergeWeights merging = no_merging();
    const std::size_t width = static_cast<std::size_t>(range.x1 - range.x0);
    const std::size_t pixels = width * static_cast<std::size_t>(range.y1 - range.y0);
    // Registers hold one sample of neighbouring pixels.
    const std::size_t groups = (pixels + LANES - 1) / LANES;
    for (std::size_t group = 0; group < groups * static_cast<std::size_t>(range.sample_count); ++group) {
        const std::size_t sample = group / groups;
        const std::size_t first = group % groups * LANES;
        const std::size_t here = pixels - first < LANES ? pixels - first : LANES;
        alignas(64) float x[LANES];
        alignas(64) float y[LANES];
        alignas(64) float on[LANES];
        alignas(64) std::uint32_t columns[LANES];
        alignas(64) std::uint32_t rows[LANES];
        alignas(64) std::uint32_t number[LANES];
        std::size_t slot[LANES];
        for (std::size_t lane = 0; lane < LANES; ++lane) {
            const std::size_t pixel = first + (lane < here ? lane : 0);
            columns[lane] = static_cast<std::uint32_t>(range.x0) + static_cast<std::uint32_t>(pixel % width);
            rows[lane] = static_cast<std::uint32_t>(range.y0) + static_cast<std::uint32_t>(pixel / width);
            x[lane] = static_cast<float>(columns[lane]);
            y[lane] = static_cast<float>(rows[lane]);
            on[lane] = lane < here ? 1.0f : 0.0f;
            number[lane] = static_cast<std::uint32_t>(range.first_sample) + static_cast<std::uint32_t>(sample);
            slot[lane] = pixel * static_cast<std::size_t>(range.sample_count) + sample;
        }
        const Mask mask = Float::load_aligned(on) > Float(0.5f);
        const int sample_number = range.first_sample + static_cast<int>(sample);
        if (maps != nullptr && sample_number != sample_of_photons) {
            sample_of_photons = sample_number;
            store.photons = photons.of_sample(sample_number);
            field = photon_field(world, sample_number);
            merging = merge_weights(field);
        }
        PixelSample one;
        one.x = Float::load_aligned(x);
        one.y = Float::load_aligned(y);
        one.key = pixel_key(UInt::load_aligned(columns), UInt::load_aligned(rows), UInt(static_cast<std::uint32_t>(world.seed)));
        one.number = UInt::load_aligned(number);
        one.light = path_of_light(world, UInt::load_aligned(columns), UInt::load_aligned(rows), one.number);
        one.mask = mask;
        Subpath camera = start_from_camera(world, one.x, one.y, one.key, one.number, light_paths(world), mask);
        if (maps != nullptr) {
            camera.path.nanometres = photon_wavelengths(world, sample_number, mask);
        }
        Mask sound = mask;
        const int kept = follow_light(world, one, camera.path.nanometres, !light_only, merging, sound, tally);
        Vec3 rgb = vec3_all(Float(0.0f));
        if (!light_only) {
            rgb = follow_camera(world, one, kept, maps != nullptr, field, merging, camera, sound, tally);
        }
        const Vec3 result = select(sound, rgb, vec3_all(Float(std::numeric_limits<float>::quiet_NaN())));
        result.x.store_aligned(x);
        result.y.store_aligned(y);
        result.z.store_aligned(on);
        for (std::size_t lane = 0; lane < here; ++lane) {
            samples.radiance[slot[lane]].x = x[lane];
            samples.radiance[slot[lane]].y = y[lane];
            samples.radiance[slot[lane]].z = on[lane];
        }
    }
    counts.camera += static_cast<std::uint64_t>(tally.camera);
    counts.secondary += static_cast<std::uint64_t>(tally.secondary);
    counts.shadow += static_cast<std::uint64_t>(tally.shadow);
}

}  // namespace lancer::LANCER_KERNEL
