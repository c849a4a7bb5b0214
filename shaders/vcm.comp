// One invocation for each sample of bidirectional paths that are merged with photons, too. All samples of one call have the same number.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference2 : require
#extension GL_EXT_scalar_block_layout : require

#include "lancer/kernel/all_objects.h"
#include "lancer/kernel/bidirectional.h"
#include "lancer/kernel/bidirectional/photon_record.h"

layout(local_size_x = 64) in;

layout(buffer_reference, scalar) readonly buffer WorldBuffer { WorldRecord world; };
layout(buffer_reference, scalar) writeonly buffer RadianceBuffer { vec3 radiance[]; };
struct SplatRecord {
    vec2 film;   // in pixels
    vec3 light;  // linear RGB, to be weighed by the filter of each pixel
};
layout(buffer_reference, scalar) writeonly buffer SplatBuffer { SplatRecord splats[]; };
layout(buffer_reference, scalar) buffer VertexBuffer { BidirVertex vertices[]; };
layout(buffer_reference, scalar) readonly buffer PhotonBuffer { PhotonRecord photons[]; };
layout(buffer_reference, scalar) readonly buffer BucketBuffer { uint first[]; };

layout(push_constant, scalar) uniform Work {
    WorldBuffer world;
    RadianceBuffer radiance;  // linear RGB, the filter's weight included
    SplatBuffer splats;       // max_depth + 2 for each pixel
    VertexBuffer vertices;    // of paths of light; max_depth + 1 for each pixel
    PhotonBuffer photons;     // of this sample, bucket by bucket
    BucketBuffer buckets;     // the first photon of each, and the end of the last
    uint bucket_mask;
    int x0;                   // of the part of the picture
    int y0;
    int width;
    int sample_number;
    int count;                // of pixels
} work;

Hit closest_hit(const WorldRecord world, const Ray ray, bool alive) { return closest_of_all(world, ray, alive); }
bool occluded(const WorldRecord world, const Ray ray, bool alive) { return occluded_by_any(world, ray, alive); }

void keep_light_vertex(const WorldRecord world, int number, const BidirVertex vertex) {
    work.vertices.vertices[int(gl_GlobalInvocationID.x) * (world.max_depth + 1) + number] = vertex;
}
BidirVertex light_vertex(const WorldRecord world, int number) {
    return work.vertices.vertices[int(gl_GlobalInvocationID.x) * (world.max_depth + 1) + number];
}

int splats_put = 0;  // by this invocation

void put_splat(const WorldRecord world, const FilmSplat splat, vec4 nanometres) {
    SplatRecord put;
    put.film = splat.film;
    put.light = splat.valid ? spectrum_to_rgb(world, splat.light, nanometres, true) : vec3(0.0f);
    work.splats.splats[int(gl_GlobalInvocationID.x) * (world.max_depth + 2) + splats_put] = put;
    ++splats_put;
}

// Photons are not kept, but looked up again: there may be many around one place.
struct PhotonWalk {
    vec3 place;
    float radius;
    uint buckets[8];  // each once
    int count;
    int at;
    uint next;
};
PhotonWalk walk;

// The next one within the radius; none after the last.
bool walk_on(inout uint found) {
    while (walk.at < walk.count) {
        uint end = work.buckets.first[walk.buckets[walk.at] + 1u];
        while (walk.next < end) {
            vec3 way = work.photons.photons[walk.next].position - walk.place;
            found = walk.next;
            ++walk.next;
            if (dot(way, way) < walk.radius * walk.radius) {
                return true;
            }
        }
        ++walk.at;
        walk.next = walk.at < walk.count ? work.buckets.first[walk.buckets[walk.at]] : 0u;
    }
    return false;
}

void walk_again() {
    walk.at = 0;
    walk.next = work.buckets.first[walk.buckets[0]];
}

int gather_photons(const WorldRecord world, vec3 position, float radius, bool mask) {
    walk.place = position;
    walk.radius = radius;
    walk.count = 0;
    for (int corner = 0; corner < 8; ++corner) {
        int x = photon_cell(position.x - radius, radius) + (corner & 1);
        int y = photon_cell(position.y - radius, radius) + ((corner >> 1) & 1);
        int z = photon_cell(position.z - radius, radius) + (corner >> 2);
        uint bucket = photon_bucket(x, y, z, work.bucket_mask);
        bool known = false;
        for (int i = 0; i < walk.count; ++i) {
            known = known || walk.buckets[i] == bucket;
        }
        if (!known) {
            walk.buckets[walk.count] = bucket;
            ++walk.count;
        }
    }
    walk_again();
    int found = 0;
    uint photon = 0u;
    while (walk_on(photon)) {
        ++found;
    }
    walk_again();
    return found;
}

// They are asked for one after another.
Photon gathered_photon(const WorldRecord world, int number, bool mask) {
    uint found = 0u;
    walk_on(found);
    PhotonRecord kept = work.photons.photons[found];
    Photon p;
    p.position = kept.position;
    p.normal = kept.normal;
    p.from = kept.from;
    p.light = kept.light;
    p.ways.meet = kept.meet;
    p.ways.join = kept.join;
    p.ways.merge = kept.merge;
    p.depth = int(kept.depth_and_single >> 1);
    p.single = (kept.depth_and_single & 1u) != 0u;
    return p;
}

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= work.count) {
        return;
    }
    int x = work.x0 + i % work.width;
    int y = work.y0 + i / work.width;
    int number = work.sample_number;
    PixelSample one;
    one.x = float(x);
    one.y = float(y);
    one.key = pixel_key(uint(x), uint(y), uint(work.world.world.seed));
    one.number = uint(number);
    one.light = path_of_light(work.world.world, uint(x), uint(y), one.number);
    one.mask = true;
    RayTally tally = RayTally(0, 0, 0);
    bool sound = true;
    Subpath camera = start_from_camera(work.world.world, one.x, one.y, one.key, one.number, light_paths(work.world.world), true);
    camera.path.nanometres = photon_wavelengths(work.world.world, number, true);
    PhotonField field = photon_field(work.world.world, number);
    MergeWeights merging = merge_weights(field);
    int kept = follow_light(work.world.world, one, camera.path.nanometres, true, merging, sound, tally);
    work.radiance.radiance[i] = follow_camera(work.world.world, one, kept, true, field, merging, camera, sound, tally);
}
