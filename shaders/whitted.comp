// One invocation for each camera sample of the Whitted integrator.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference2 : require
#extension GL_EXT_scalar_block_layout : require

#include "lancer/kernel/all_objects.h"
#include "lancer/kernel/whitted.h"

layout(local_size_x = 64) in;

layout(buffer_reference, scalar) readonly buffer WorldBuffer { WorldRecord world; };
layout(buffer_reference, scalar) readonly buffer PointBuffer { vec2 points[]; };
layout(buffer_reference, scalar) writeonly buffer RadianceBuffer { vec3 radiance[]; };

layout(push_constant, scalar) uniform Work {
    WorldBuffer world;
    PointBuffer points;      // of the film, in pixels
    RadianceBuffer radiance;
    int count;
} work;

Hit closest_hit(const WorldRecord world, const Ray ray, bool alive) { return closest_of_all(world, ray, alive); }
bool occluded(const WorldRecord world, const Ray ray, bool alive) { return occluded_by_any(world, ray, alive); }

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= work.count) {
        return;
    }
    RayTally tally = RayTally(0, 0, 0);
    vec2 point = work.points.points[i];
    Ray ray = camera_ray(work.world.world.camera, point.x, point.y);
    work.radiance.radiance[i] = whitted_radiance(work.world.world, ray, true, tally);
}
