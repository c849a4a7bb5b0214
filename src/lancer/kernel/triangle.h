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

// A corner as the ray sees it: its place across the ray, relative to the ray. Any two directions across will do, if they are the same for all
// triangles; these are [Duff et al. 2017].
FN Vec2 seen_along(Vec3 corner, Vec3 d) {
    Float sign = with_sign_of(Float(1.0f), d.z);
    Float a = Float(-1.0f) / (sign + d.z);
    Float b = d.x * d.y * a;
    Vec3 x = vec3_of(Float(1.0f) + sign * d.x * d.x * a, sign * b, -sign * d.x);
    Vec3 y = vec3_of(b, sign + d.y * d.y * a, -d.y);
    return vec2_of(dot(corner, x), dot(corner, y));
}

// Twice the area that the ray spans with an edge. The difference of two rounded products has the right sign or is zero, so it says truly on which
// side of the edge, as seen, the ray passes [Woop et al. 2013].
FN Float edge_area(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }

// To the triangle's plane; FAR where it is behind or parallel.
FN Float triangle_plane_distance(Vec3 a, Vec3 b, Vec3 c, IN(Ray) ray) {
    Vec3 n = cross(b - a, c - a);
    Float t = dot(n, a - ray.origin) / dot(n, ray.direction);
    return select(both(t > Float(0.0f), t < Float(FAR)), t, Float(FAR));
}

// Each corner is seen at the same place by all triangles that share it, and each edge answers them alike: no ray slips between triangles that
// share an edge or a corner.
FN TriangleHit triangle_hit(Vec3 a, Vec3 b, Vec3 c, IN(Ray) ray) {
    Vec3 d = ray.direction;
    Vec2 sa = seen_along(a - ray.origin, d);
    Vec2 sb = seen_along(b - ray.origin, d);
    Vec2 sc = seen_along(c - ray.origin, d);
    Float wa = edge_area(sb, sc);
    Float wb = edge_area(sc, sa);
    Float wc = edge_area(sa, sb);
    Float sum = wa + wb + wc;
    Float least = min(min(wa, wb), wc);
    Float most = max(max(wa, wb), wc);
    Mask inside = both(either(least >= Float(0.0f), most <= Float(0.0f)), abs(sum) > Float(0.0f));
    TriangleHit hit;
    hit.t = select(inside, triangle_plane_distance(a, b, c, ray), Float(FAR));
    hit.u = wb / sum;
    hit.v = wc / sum;
    return hit;
}

FN SurfacePoint triangle_surface(Vec3 a, Vec3 b, Vec3 c, Float u, Float v) {
    SurfacePoint s = no_surface();
    Float w = Float(1.0f) - u - v;
    s.position = a * w + b * u + c * v;
    s.error = (abs(a * w) + abs(b * u) + abs(c * v)) * Float(8.0f * ROUNDING) + max(max(abs(a), abs(b)), abs(c)) * Float(4.0f * ROUNDING);
    s.normal = normalize(cross(b - a, c - a));
    s.shading = s.normal;
    s.local = s.position;
    s.local_in = -s.normal;
    s.uv = vec2_of(u, v);
    return s;
}

NAMESPACE_END

#endif
