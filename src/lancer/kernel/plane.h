// The infinite plane.
#ifndef LANCER_KERNEL_PLANE_H
#define LANCER_KERNEL_PLANE_H

#include "lancer/kernel/placed.h"

NAMESPACE_BEGIN

// FAR for rays parallel to it, also for those that lie in it.
FN Float plane_distance(IN(PlaneRecord) plane, IN(Ray) ray) {
    Vec3 n = broadcast(plane.normal);
    Float across = dot(n, ray.direction);
    Float t = (Float(plane.offset) - dot(n, ray.origin)) / across;
    return select(both(t > Float(0.0f), t < Float(FAR)), t, Float(FAR));
}

// Two directions in the plane with that normal.
FN UvAxes plane_axes(Vec3 m) {
    Vec3 side = select(abs(m.y) > Float(0.999f), vec3_of(Float(1.0f), Float(0.0f), Float(0.0f)), vec3_of(m.z, Float(0.0f), -m.x));
    UvAxes axes;
    axes.u = normalize(side - m * dot(m, side));
    axes.v = cross(m, axes.u);
    return axes;
}

// Texture coordinates are metres along two axes in the plane, as the author wrote it.
FN SurfacePoint plane_surface(IN(PlaneRecord) plane, IN(Ray) ray, Float t) {
    SurfacePoint s = no_surface();
    Vec3 n = broadcast(plane.normal);
    Vec3 p = ray.origin + ray.direction * t;
    Float off = dot(n, p) - Float(plane.offset);
    s.position = p - n * off;
    s.error = (abs(s.position) + vec3_all(abs(Float(plane.offset)))) * Float(6.0f * ROUNDING);
    s.normal = n;
    s.shading = n;
    s.local = apply_affine(plane.to_author, s.position);
    Vec3 m = broadcast(plane.author_normal);
    s.local_in = -m;
    UvAxes axes = plane_axes(m);
    s.uv = vec2_of(dot(axes.u, s.local), dot(axes.v, s.local));
    return s;
}

NAMESPACE_END

#endif
