// The infinite plane.
#ifndef LANCER_KERNEL_PLANE_H
#define LANCER_KERNEL_PLANE_H

#include "lancer/kernel/ray.h"
#include "lancer/kernel/records.h"

NAMESPACE_BEGIN

// FAR for rays parallel to it, also for those that lie in it.
FN Float plane_distance(IN(PlaneRecord) plane, IN(Ray) ray) {
    Vec3 n = broadcast(plane.normal);
    Float across = dot(n, ray.direction);
    Float t = (Float(plane.offset) - dot(n, ray.origin)) / across;
    return select(both(t > Float(0.0f), t < Float(FAR)), t, Float(FAR));
}

// Texture coordinates are metres along two axes in the plane.
FN SurfacePoint plane_surface(IN(PlaneRecord) plane, IN(Ray) ray, Float t) {
    SurfacePoint s;
    Vec3 n = broadcast(plane.normal);
    Vec3 p = ray.origin + ray.direction * t;
    Float off = dot(n, p) - Float(plane.offset);
    s.position = p - n * off;
    s.error = (abs(s.position) + vec3_all(abs(Float(plane.offset)))) * Float(6.0f * ROUNDING);
    s.normal = n;
    s.shading = n;
    s.local = s.position;
    Vec3 side = select(abs(n.y) > Float(0.999f), vec3_of(Float(1.0f), Float(0.0f), Float(0.0f)), vec3_of(n.z, Float(0.0f), -n.x));
    Vec3 u = normalize(side - n * dot(n, side));
    Vec3 v = cross(n, u);
    s.uv = vec2_of(dot(u, s.position), dot(v, s.position));
    return s;
}

NAMESPACE_END

#endif
