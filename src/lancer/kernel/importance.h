// The camera as paths of light see it: where on the film a point lies, and how much a pixel takes of the light that comes from there.
#ifndef LANCER_KERNEL_IMPORTANCE_H
#define LANCER_KERNEL_IMPORTANCE_H

#include "lancer/kernel/camera.h"

NAMESPACE_BEGIN

// A point joined to the camera.
struct CameraSight {
    Vec2 film;       // pixels from the upper left corner, as in lens_ray
    Vec3 direction;  // from the point to the camera, length 1
    Float distance;  // to the lens or to the film
    // With which a camera path whose point of the film is drawn with density 1 per square pixel arrives at the point, per square metre at right angles to its way.
    Float density;
    Mask valid;
};

// Of one pixel, on the plane at distance 1; of orthographic cameras on the film itself.
FN Float pixel_area(IN(CameraRecord) camera) { return length(cross(broadcast(camera.step_x), broadcast(camera.step_y))); }

// Per solid angle of the ray of a point of the film that is drawn with density 1 per square pixel; of orthographic cameras per square metre
// across the ray.
FN Float camera_density(IN(CameraRecord) camera, Vec3 direction) {
    Float density = Float(1.0f);
    if (camera.kind == CAMERA_PERSPECTIVE) {
        Float cosine = dot(direction, broadcast(camera.forward));
        density = Float(1.0f) / max(pixel_area(camera) * cosine * cosine * cosine, Float(SMALLEST));
    } else if (camera.kind == CAMERA_ORTHOGRAPHIC) {
        density = Float(1.0f) / max(pixel_area(camera), Float(SMALLEST));
    } else {
        Float down = dot(direction, broadcast(camera.down));
        Float ring = sqrt(max(Float(1.0f) - down * down, Float(0.0f)));
        density = Float(camera.width * camera.height / (2.0f * PI * PI)) / max(ring, Float(SMALLEST));
    }
    return density;
}

// Whether camera rays of one point of the film are parallel, wherever they begin: their density does not fall with the distance.
FN Mask is_parallel(IN(CameraRecord) camera) {
    return camera.kind == CAMERA_ORTHOGRAPHIC ? Float(0.0f) < Float(1.0f) : Float(1.0f) < Float(0.0f);
}

// From a point to the camera; `lens` in the unit disk. Points off the film, but within `margin` pixels of it, still count: filters reach there.
FN CameraSight see_point(IN(CameraRecord) camera, Vec3 from, Vec2 lens, Float margin) {
    CameraSight s;
    Vec3 eye = broadcast(camera.position);
    Vec3 forward = broadcast(camera.forward);
    Vec3 step_x = broadcast(camera.step_x);
    Vec3 step_y = broadcast(camera.step_y);
    if (camera.kind == CAMERA_PERSPECTIVE) {
        if (camera.lens_radius > 0.0f) {
            eye = eye + (broadcast(camera.right) * lens.x + broadcast(camera.down) * lens.y) * Float(camera.lens_radius);
        }
        Vec3 way = from - eye;
        Float depth = dot(way, forward);
        Float distance_2 = dot(way, way);
        s.distance = sqrt(distance_2);
        Vec3 towards = way / max(depth, Float(SMALLEST));
        if (camera.lens_radius > 0.0f) {
            towards = towards + (eye - broadcast(camera.position)) / Float(camera.focus_distance);
        }
        Vec3 on_film = towards - broadcast(camera.corner);
        s.film = vec2_of(dot(on_film, step_x) / dot(step_x, step_x), dot(on_film, step_y) / dot(step_y, step_y));
        s.direction = -way / max(s.distance, Float(SMALLEST));
        s.density = camera_density(camera, -s.direction) / max(distance_2, Float(SMALLEST));
        s.valid = depth > Float(0.0f);
    } else if (camera.kind == CAMERA_ORTHOGRAPHIC) {
        Vec3 way = from - broadcast(camera.corner);
        s.distance = dot(way, forward);
        s.film = vec2_of(dot(way, step_x) / dot(step_x, step_x), dot(way, step_y) / dot(step_y, step_y));
        s.direction = -forward;
        s.density = camera_density(camera, forward);
        s.valid = s.distance > Float(0.0f);
    } else {
        Vec3 way = from - eye;
        Float distance_2 = dot(way, way);
        s.distance = sqrt(distance_2);
        s.direction = -way / max(s.distance, Float(SMALLEST));
        // As lens_ray has it: a turn of x / width + 1/2 in the plane of forward and right, half a turn of y / height from above.
        Float ahead = dot(way, forward);
        Float right = dot(way, broadcast(camera.right));
        Float down = dot(way, broadcast(camera.down));
        Float turn = angle_of(right, ahead) * Float(0.5f / PI);
        Float ring = sqrt(max(ahead * ahead + right * right, Float(0.0f)));
        s.film = vec2_of((turn + Float(0.5f)) * Float(camera.width), angle_of(ring, -down) * Float(camera.height / PI));
        s.density = camera_density(camera, -s.direction) / max(distance_2, Float(SMALLEST));
        s.valid = distance_2 > Float(0.0f);
    }
    Mask across = both(s.film.x > -margin, s.film.x < Float(camera.width) + margin);
    Mask down = both(s.film.y > -margin, s.film.y < Float(camera.height) + margin);
    s.valid = both(s.valid, both(across, down));
    return s;
}

NAMESPACE_END

#endif
