// From the place of a pixel and random numbers to the ray with which a path begins.
#ifndef LANCER_KERNEL_PATH_CAMERA_H
#define LANCER_KERNEL_PATH_CAMERA_H

#include "lancer/kernel/camera.h"
#include "lancer/kernel/sampler.h"
#include "lancer/kernel/warp.h"

NAMESPACE_BEGIN

// ---- The pixel's filter, drawn from: each sample counts the same [Ernst, Stamminger, Greiner 2006]. ------------------------------------

// One coordinate of a point drawn from a filter's absolute value around the pixel's middle, in pixels; `sign` is -1 where the filter is negative.
FN Float tent_place(Float u, Float radius) {
    Mask lower = u < Float(0.5f);
    Float rest = select(lower, u, Float(1.0f) - u);
    Float place = Float(1.0f) - sqrt(max(rest * Float(2.0f), Float(0.0f)));
    return select(lower, -place, place) * radius;
}

FN Vec2 filter_place(IN(FilterRecord) filter_, Vec2 u) {
    Float radius = Float(filter_.radius);
    Vec2 place = vec2_of((u.x * Float(2.0f) - Float(1.0f)) * radius, (u.y * Float(2.0f) - Float(1.0f)) * radius);
    if (filter_.kind == FILTER_TENT) {
        place = vec2_of(tent_place(u.x, radius), tent_place(u.y, radius));
    }
    return place;
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
