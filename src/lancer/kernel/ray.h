// Rays, what they hit, and how the next ray leaves a surface without hitting it again.
#ifndef LANCER_KERNEL_RAY_H
#define LANCER_KERNEL_RAY_H

#include "lancer/kernel/math.h"

NAMESPACE_BEGIN

// Points origin + t * direction with 0 < t < reach. World-space directions have length 1.
struct Ray {
    Vec3 origin;
    Vec3 direction;
    Float reach;
};

// What stands first in the way: `t` is the ray's reach where nothing does, `object` -1 then. `part` is the triangle of a mesh, with
// barycentric coordinates u (of its second corner) and v (of its third).
struct Hit {
    Float t;
    Int object;
    Int part;
    Float u;
    Float v;
};

// The geometry of the point that was hit, in world space.
struct SurfacePoint {
    Vec3 position;
    Vec3 error;     // bound of how far rounding put `position` off the surface, each coordinate; how far along it is not counted
    Vec3 normal;    // of the surface itself, outwards, length 1
    Vec3 shading;   // smooth normal, on the side of `normal`, length 1
    Vec3 local;     // position in the author's space of the object, for solid textures
    Vec3 local_in;  // into the body there, about length 1: what lies under the point
    Vec2 uv;

    // What mapping.h finds where a material asks for it.
    Vec2 second_uv;
    Vec3 along_u;  // how the point moves with u and with v: metres for each unit; 0: not known
    Vec3 along_v;
    Vec2 across;         // two diameters of the patch that the path's beam covers, in uv,
    Vec2 down;           // at right angles on the surface
    Vec2 second_across;  // the same in the second uv
    Vec2 second_down;
    Vec3 local_across;  // and in the author's space
    Vec3 local_down;
    Vec4 vertex_color;
    Vec4 face_color;
};

// Two ways along a surface: d position / du and d position / dv, or the diameters of a patch.
struct UvAxes {
    Vec3 u;
    Vec3 v;
};

FN Ray select_ray(Mask mask, IN(Ray) yes, IN(Ray) no) {
    Ray ray;
    ray.origin = select(mask, yes.origin, no.origin);
    ray.direction = select(mask, yes.direction, no.direction);
    ray.reach = select(mask, yes.reach, no.reach);
    return ray;
}

FN SurfacePoint no_surface() {
    SurfacePoint s;
    s.position = vec3_all(Float(0.0f));
    s.error = s.position;
    s.normal = s.position;
    s.shading = s.position;
    s.local = s.position;
    s.local_in = s.position;
    s.uv = vec2_of(Float(0.0f), Float(0.0f));
    s.second_uv = s.uv;
    s.along_u = s.position;
    s.along_v = s.position;
    s.across = s.uv;
    s.down = s.uv;
    s.second_across = s.uv;
    s.second_down = s.uv;
    s.local_across = s.position;
    s.local_down = s.position;
    s.vertex_color = vec4_all(Float(1.0f));
    s.face_color = s.vertex_color;
    return s;
}

// 1 / direction with every zero made positive and every reciprocal finite, so that no slab test makes a NaN. A ray that lies in a face plane
// is then inside on the low face and outside on the high one, for +0 and for -0: boxes are half open.
FN Vec3 slab_reciprocal(Vec3 d) {
    Vec3 safe = vec3_of(select(abs(d.x) < Float(SMALLEST), Float(SMALLEST), d.x), select(abs(d.y) < Float(SMALLEST), Float(SMALLEST), d.y),
                        select(abs(d.z) < Float(SMALLEST), Float(SMALLEST), d.z));
    return reciprocal(safe);
}

// Where a ray towards `direction` starts so that the rounding of `position` can't put it on the wrong side: moved along the normal by the
// position's own error bound, plus the rounding of this very addition. [Pharr, Jakob, Humphreys 2016, 3.9; differs: the bound includes the
// last rounding instead of stepping to the next float.]
FN Vec3 leave_surface(Vec3 position, Vec3 error, Vec3 normal, Vec3 direction) {
    Vec3 bound = error + abs(position) * Float(2.0f * ROUNDING);
    Float distance = dot(abs(normal), bound);
    return position + normal * select(dot(normal, direction) < Float(0.0f), -distance, distance);
}

// Where a ray from afar ends: just before the surface. The ray's own rounding puts it off its line by some units for each unit of length, and so the
// distance to a plane.
FN Vec3 before_surface(Vec3 position, Vec3 error, Vec3 normal, Float distance, Vec3 back) {
    return leave_surface(position, error + vec3_all(distance * Float(8.0f * ROUNDING)), normal, back);
}

FN Vec3 mirror(Vec3 v, Vec3 n) { return n * (Float(2.0f) * dot(v, n)) - v; }  // the report's R = 2 (V.N) N - V

FN Hit no_hit(IN(Ray) ray) {
    Hit hit;
    hit.t = ray.reach;
    hit.object = Int(-1);
    hit.part = Int(0);
    hit.u = Float(0.0f);
    hit.v = Float(0.0f);
    return hit;
}

NAMESPACE_END

#endif
