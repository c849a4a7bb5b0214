// One invocation for each sample of the path integrator, followed to its end.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference2 : require
#extension GL_EXT_scalar_block_layout : require

#include "lancer/kernel/all_objects.h"
#include "lancer/kernel/outcome.h"
#include "lancer/kernel/path.h"

layout(local_size_x = 64) in;

layout(buffer_reference, scalar) readonly buffer WorldBuffer { WorldRecord world; };
layout(buffer_reference, scalar) writeonly buffer RadianceBuffer { vec3 radiance[]; };

layout(push_constant, scalar) uniform Work {
    WorldBuffer world;
    RadianceBuffer radiance;  // linear RGB, the filter's weight included; a pixel's samples together
    int x0;                   // of the part of the picture
    int y0;
    int width;
    int first_sample;
    int samples;              // of each pixel
    int count;                // of all
} work;

Hit closest_hit(const WorldRecord world, const Ray ray, bool alive) { return closest_of_all(world, ray, alive); }
bool occluded(const WorldRecord world, const Ray ray, bool alive) { return occluded_by_any(world, ray, alive); }

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= work.count) {
        return;
    }
    int pixel = i / work.samples;
    int x = work.x0 + pixel % work.width;
    int y = work.y0 + pixel / work.width;
    uint key = pixel_key(uint(x), uint(y), uint(work.world.world.seed));
    uint number = uint(work.first_sample + i % work.samples);
    PathState path = start_path(work.world.world, float(x), float(y), key, number, true);
    RayTally tally = RayTally(0, 0, 0);
    Sight sight;
    for (int depth = 0; path.alive; ++depth) {
        path_step(work.world.world, depth, path, sight, tally);
    }
    work.radiance.radiance[i] = light_in_pixel(work.world.world, path, path.radiance, true);
}
