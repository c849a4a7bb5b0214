// From the place of a pixel and random numbers to the ray with which a path begins.
#ifndef LANCER_KERNEL_PATH_CAMERA_H
#define LANCER_KERNEL_PATH_CAMERA_H

#include "lancer/kernel/camera.h"
#include "lancer/kernel/sampler.h"
#include "lancer/kernel/tables.h"
#include "lancer/kernel/warp.h"

NAMESPACE_BEGIN

// ---- The pixel's filter, drawn from: each sample counts the same but for its sign [Ernst et al. 2006]. -------------------

struct FilterSample {
    Float place;  // pixels from the pixel's middle
    Float weight;
};

FN FilterSample sample_filter(IN(WorldRecord) world, Float u, Mask mask) {
    Float at = u * Float(float(FILTER_STEPS));
    Int step = to_int(at);
    Float low = gather_float(world.filter_places, step, mask);
    Float high = gather_float(world.filter_places, step + Int(1), mask);
    FilterSample s;
    s.place = low + (high - low) * (at - to_float(step));
    Float weight = Float(world.filter_record.weight);
    s.weight = select(abs(s.place) > Float(world.filter_record.negative_from), -weight, weight);
    return s;
}

// ---- The ray ---------------------------------------------------------------------------------------------------------------------------

// Through the point (x, y) of the film, in pixels from the upper left corner; `lens` in the unit disk.
FN Ray lens_ray(IN(CameraRecord) camera, Float x, Float y, Vec2 lens) {
    Ray ray;
    ray.origin = broadcast(camera.position);
    ray.reach = Float(FAR);
    if (camera.kind == CAMERA_PERSPECTIVE) {
        Vec3 towards = broadcast(camera.corner) + broadcast(camera.step_x) * x + broadcast(camera.step_y) * y;
        if (camera.lens_radius > 0.0f) {
            // `towards` reaches the plane at distance 1: scaled, the plane that is sharp.
            Vec3 sharp = towards * Float(camera.focus_distance);
            Vec3 off = (broadcast(camera.right) * lens.x + broadcast(camera.down) * lens.y) * Float(camera.lens_radius);
            ray.origin = ray.origin + off;
            towards = sharp - off;
        }
        ray.direction = normalize(towards);
    } else if (camera.kind == CAMERA_ORTHOGRAPHIC) {
        ray.origin = broadcast(camera.corner) + broadcast(camera.step_x) * x + broadcast(camera.step_y) * y;
        ray.direction = broadcast(camera.forward);
    } else {
        // The picture's middle looks along `forward`, its right half to the right.
        Vec2 around = on_circle(x * Float(1.0f / camera.width) + Float(0.5f));
        Vec2 tilt = on_circle(y * Float(0.5f / camera.height));
        Float ring = tilt.y;
        ray.direction = normalize(broadcast(camera.forward) * (around.x * ring) + broadcast(camera.right) * (around.y * ring) -
                                  broadcast(camera.down) * tilt.x);
    }
    return ray;
}

NAMESPACE_END

#endif
