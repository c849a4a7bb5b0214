// From two numbers, uniform in [0, 1), to points and directions; each with its density.
#ifndef LANCER_KERNEL_WARP_H
#define LANCER_KERNEL_WARP_H

#include "lancer/kernel/math.h"

NAMESPACE_BEGIN

// Uniform on the unit disk, squares going to squares around the middle, so that well spread numbers stay well spread [Shirley and Chiu 1997].
FN Vec2 on_disk(Vec2 u) {
    Float a = Float(2.0f) * u.x - Float(1.0f);
    Float b = Float(2.0f) * u.y - Float(1.0f);
    Mask wide = abs(a) > abs(b);
    Float radius = select(wide, a, b);
    Float other = select(wide, b, a);
    // An eighth of a turn for other = radius; the second half of the disk by the sign of the radius.
    Float ratio = select(abs(radius) > Float(0.0f), other / select(abs(radius) > Float(0.0f), radius, Float(1.0f)), Float(0.0f));
    Float turn = select(wide, ratio * Float(0.125f), Float(0.25f) - ratio * Float(0.125f));
    Vec2 direction = on_circle(turn + Float(1.0f));
    return vec2_of(radius * direction.x, radius * direction.y);
}

// Around +z with density cos / pi per solid angle.
FN Vec3 cosine_hemisphere(Vec2 u) {
    Vec2 p = on_disk(u);
    return vec3_of(p.x, p.y, sqrt(max(Float(1.0f) - p.x * p.x - p.y * p.y, Float(0.0f))));
}

// Uniform on the unit sphere: density 1 / (4 pi) per solid angle.
FN Vec3 on_sphere(Vec2 u) {
    Float z = Float(1.0f) - Float(2.0f) * u.x;
    Float r = sqrt(max(Float(1.0f) - z * z, Float(0.0f)));
    Vec2 p = on_circle(u.y);
    return vec3_of(r * p.x, r * p.y, z);
}

// Barycentric coordinates (of the second and third corner), uniform over the triangle [Heitz 2019].
FN Vec2 on_triangle(Vec2 u) {
    Mask upper = u.y > u.x;
    Float x = select(upper, u.x * Float(0.5f), u.x - u.y * Float(0.5f));
    Float y = select(upper, u.y - u.x * Float(0.5f), u.y * Float(0.5f));
    return vec2_of(x, y);
}

NAMESPACE_END

#endif
