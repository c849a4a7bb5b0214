// Triangles, alone and in meshes.
#ifndef LANCER_KERNEL_TRIANGLE_H
#define LANCER_KERNEL_TRIANGLE_H

#include "lancer/kernel/placed.h"

NAMESPACE_BEGIN

struct TriangleHit {
    Float t;  // FAR where there is none
    Float u;
    Float v;
};

// By the volumes that the ray spans with the three edges: two triangles that share an edge compute the same number for it, with opposite
// signs, so no ray slips between them [Davidovic, Engelhardt, Georgiev, Slusallek, Dachsbacher 2012].
FN TriangleHit triangle_hit(Vec3 a, Vec3 b, Vec3 c, IN(Ray) ray) {
    Vec3 va = a - ray.origin;
    Vec3 vb = b - ray.origin;
    Vec3 vc = c - ray.origin;
    Vec3 d = ray.direction;
    Float wa = dot(cross(vc + vb, vb - vc), d);
    Float wb = dot(cross(va + vc, vc - va), d);
    Float wc = dot(cross(vb + va, va - vb), d);
    Float sum = wa + wb + wc;
    Float least = min(min(wa, wb), wc);
    Float most = max(max(wa, wb), wc);
    Mask inside = either(least >= Float(0.0f), most <= Float(0.0f));
    Vec3 n = cross(b - a, c - a);
    Float along = dot(n, d);
    Float t = dot(n, va) / along;
    inside = both(inside, both(t > Float(0.0f), t < Float(FAR)));
    TriangleHit hit;
    hit.t = select(inside, t, Float(FAR));
    hit.u = wb / sum;
    hit.v = wc / sum;
    return hit;
}

FN SurfacePoint triangle_surface(Vec3 a, Vec3 b, Vec3 c, Float u, Float v) {
    SurfacePoint s;
    Float w = Float(1.0f) - u - v;
    s.position = a * w + b * u + c * v;
    s.error = (abs(a * w) + abs(b * u) + abs(c * v)) * Float(8.0f * ROUNDING) + max(max(abs(a), abs(b)), abs(c)) * Float(4.0f * ROUNDING);
    s.normal = normalize(cross(b - a, c - a));
    s.shading = s.normal;
    s.local = s.position;
    s.uv = vec2_of(u, v);
    return s;
}

NAMESPACE_END

#endif
