// One invocation for each path of photons of one sample: what shaders/vcm.comp merges, once they are sorted into buckets.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference2 : require
#extension GL_EXT_scalar_block_layout : require

#include "lancer/kernel/all_objects.h"
#include "lancer/kernel/bidirectional.h"
#include "lancer/kernel/bidirectional/photon_record.h"

layout(local_size_x = 64) in;

layout(buffer_reference, scalar) readonly buffer WorldBuffer { WorldRecord world; };
layout(buffer_reference, scalar) writeonly buffer PhotonBuffer { PhotonRecord photons[]; };
layout(buffer_reference, scalar) writeonly buffer BucketBuffer { int buckets[]; };

layout(push_constant, scalar) uniform Work {
    WorldBuffer world;
    PhotonBuffer photons;   // max_depth + 1 for each path
    BucketBuffer buckets;   // of each of these; -1: there is none
    uint bucket_mask;
    int sample_number;
    int first;              // number of the first path
    int count;              // of paths
} work;

Hit closest_hit(const WorldRecord world, const Ray ray, bool alive) { return closest_of_all(world, ray, alive); }
bool occluded(const WorldRecord world, const Ray ray, bool alive) { return occluded_by_any(world, ray, alive); }

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= work.count) {
        return;
    }
    PhotonField field = photon_field(work.world.world, work.sample_number);
    MergeWeights merging = merge_weights(field);
    vec4 nanometres = photon_wavelengths(work.world.world, work.sample_number, true);
    LightStart start;
    Subpath lit = start_from_light(work.world.world, number_of_photons(work.sample_number, uint(work.first + i)), nanometres, true, start);
    int room = work.world.world.max_depth + 1;
    for (int depth = 0; depth < room; ++depth) {
        int at = i * room + depth;
        work.buckets.buckets[at] = -1;
        if (lit.path.alive) {
            BidirVertex v;
            photon_step(work.world.world, depth, start, merging, lit, v);
            if (v.valid && is_sound(v.throughput)) {
                PhotonRecord p;
                p.position = v.position;
                p.normal = v.normal;
                p.from = to_world(v.frame, v.wo);
                p.light = v.throughput;
                p.meet = v.ways.meet;
                p.join = v.ways.join;
                p.merge = v.ways.merge;
                p.depth_and_single = 2u * uint(depth) + (v.single ? 1u : 0u);
                work.photons.photons[at] = p;
                work.buckets.buckets[at] = int(photon_bucket(photon_cell(v.position.x, field.radius), photon_cell(v.position.y, field.radius),
                                                             photon_cell(v.position.z, field.radius), work.bucket_mask));
            }
        }
    }
}
