// The sphere: |o + t d - c|^2 = r^2, the report's polynomial (3.1.1), solved without cancellation.
#ifndef LANCER_KERNEL_SPHERE_H
#define LANCER_KERNEL_SPHERE_H

#include "lancer/kernel/ray.h"
#include "lancer/kernel/records.h"

NAMESPACE_BEGIN

// Distance to the first point in front of the ray's origin, from outside or inside; FAR if there is none. The direction has length 1.
// The discriminant comes from the distance between the centre and the line, and the nearer root by division where subtraction would cancel
// [Haines, Günther, Akenine-Möller 2019]. Only lanes of `alive` need an answer.
FN Float sphere_distance(IN(SphereRecord) sphere, IN(Ray) ray, Mask alive) {
    Vec3 f = ray.origin - broadcast(sphere.center);
    Float b = -dot(f, ray.direction);
    Vec3 l = f + ray.direction * b;
    Float radius_2 = square(Float(sphere.radius));
    Float discriminant = radius_2 - dot(l, l);
    Float c = dot(f, f) - radius_2;
    // The line meets the sphere, and not behind an origin outside of it.
    Mask meets = both(discriminant >= Float(0.0f), either(b > Float(0.0f), c < Float(0.0f)));
    Float t = Float(FAR);
    if (some(both(meets, alive))) {
        Float q = b + with_sign_of(sqrt(max(discriminant, Float(0.0f))), b);
        Float other = c / q;
        Float near = min(q, other);
        Float far = max(q, other);
        Float first = select(near > Float(0.0f), near, far);
        t = select(both(meets, first > Float(0.0f)), first, Float(FAR));
    }
    return t;
}

FN Vec2 sphere_uv(Vec3 n) {
    Float ring = sqrt(max(n.x * n.x + n.z * n.z, Float(0.0f)));
    return vec2_of(angle_of(n.x, n.z) * Float(0.5f / PI) + Float(0.5f), Float(0.5f) + angle_of(n.y, ring) * Float(1.0f / PI));
}

// The point is put back on the sphere, which makes its error independent of the distance travelled.
FN SurfacePoint sphere_surface(IN(SphereRecord) sphere, IN(Ray) ray, Float t) {
    SurfacePoint s = no_surface();
    Vec3 center = broadcast(sphere.center);
    s.normal = normalize(ray.origin + ray.direction * t - center);
    s.position = center + s.normal * Float(sphere.radius);
    s.error = (abs(center) + vec3_all(Float(sphere.radius))) * Float(8.0f * ROUNDING);
    s.shading = s.normal;
    s.local = s.position;
    s.local_in = -s.normal;
    s.uv = vec2_of(Float(0.0f), Float(0.0f));
    return s;
}

NAMESPACE_END

#endif
