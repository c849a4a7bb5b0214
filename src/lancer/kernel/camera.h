// The pinhole camera.
#ifndef LANCER_KERNEL_CAMERA_H
#define LANCER_KERNEL_CAMERA_H

#include "lancer/kernel/ray.h"
#include "lancer/kernel/records.h"

NAMESPACE_BEGIN

// Through the point (x, y) of the film, in pixels from the picture's upper left corner.
FN Ray camera_ray(IN(CameraRecord) camera, Float x, Float y) {
    Ray ray;
    ray.origin = broadcast(camera.position);
    ray.direction = normalize(broadcast(camera.corner) + broadcast(camera.step_x) * x + broadcast(camera.step_y) * y);
    ray.reach = Float(FAR);
    return ray;
}

NAMESPACE_END

#endif
