// From a point of the film to a ray.
#ifndef LANCER_KERNEL_CAMERA_H
#define LANCER_KERNEL_CAMERA_H

#include "lancer/kernel/ray.h"
#include "lancer/kernel/records.h"

NAMESPACE_BEGIN

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

// Through the middle of the lens.
FN Ray camera_ray(IN(CameraRecord) camera, Float x, Float y) { return lens_ray(camera, x, y, vec2_of(Float(0.0f), Float(0.0f))); }

// What one pixel sees: the width of its beam at the camera in metres, and by how much it grows a metre.
FN Vec2 pixel_beam(IN(CameraRecord) camera, Float x, Float y) {
    Vec2 beam = vec2_of(Float(0.0f), Float(0.0f));
    if (camera.kind == CAMERA_PERSPECTIVE) {
        Vec3 towards = broadcast(camera.corner) + broadcast(camera.step_x) * x + broadcast(camera.step_y) * y;
        beam.y = length(broadcast(camera.step_x)) / length(towards);
    } else if (camera.kind == CAMERA_ORTHOGRAPHIC) {
        beam.x = length(broadcast(camera.step_x));
    } else {
        beam.y = Float(PI / camera.height);
    }
    return beam;
}

NAMESPACE_END

#endif
