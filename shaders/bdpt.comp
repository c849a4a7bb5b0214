// One invocation for each sample of bidirectional paths, each with a path of light of its own.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference2 : require
#extension GL_EXT_scalar_block_layout : require

#include "lancer/kernel/all_objects.h"
#include "lancer/kernel/bidirectional.h"

layout(local_size_x = 64) in;

layout(buffer_reference, scalar) readonly buffer WorldBuffer { WorldRecord world; };
layout(buffer_reference, scalar) writeonly buffer RadianceBuffer { vec3 radiance[]; };
struct SplatRecord {
    vec2 film;   // in pixels
    vec3 light;  // linear RGB, to be weighed by the filter of each pixel
};
layout(buffer_reference, scalar) writeonly buffer SplatBuffer { SplatRecord splats[]; };
layout(buffer_reference, scalar) buffer VertexBuffer { BidirVertex vertices[]; };

layout(push_constant, scalar) uniform Work {
    WorldBuffer world;
    RadianceBuffer radiance;  // linear RGB, the filter's weight included; a pixel's samples together
    SplatBuffer splats;       // max_depth + 2 for each sample
    VertexBuffer vertices;    // of paths of light; max_depth + 1 for each sample
    int x0;                   // of the part of the picture
    int y0;
    int width;
    int first_sample;
    int samples;              // of each pixel
    int count;                // of all
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

// None are merged.
int gather_photons(const WorldRecord world, vec3 position, float radius, bool mask) { return 0; }
Photon gathered_photon(const WorldRecord world, int number, bool mask) {
    Photon none;
    return none;
}

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= work.count) {
        return;
    }
    int pixel = i / work.samples;
    int x = work.x0 + pixel % work.width;
    int y = work.y0 + pixel / work.width;
    int number = work.first_sample + i % work.samples;
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
    int kept = follow_light(work.world.world, one, camera.path.nanometres, true, no_merging(), sound, tally);
    PhotonField nothing = photon_field(work.world.world, 0);
    work.radiance.radiance[i] = follow_camera(work.world.world, one, kept, false, nothing, no_merging(), camera, sound, tally);
}
