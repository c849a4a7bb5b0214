// The axis-aligned box: six planes, the report's slab test (3.1.2).
#ifndef LANCER_KERNEL_BOX_H
#define LANCER_KERNEL_BOX_H

#include "lancer/kernel/ray.h"
#include "lancer/kernel/records.h"

NAMESPACE_BEGIN

// Distance to the first face in front of the origin, from outside or inside; FAR if there is none. `inverse` is slab_reciprocal(direction).
FN Float slab_distance(Vec3 low, Vec3 high, Vec3 origin, Vec3 inverse) {
    Vec3 a = (low - origin) * inverse;
    Vec3 b = (high - origin) * inverse;
    Vec3 enter = min(a, b);
    Vec3 leave = max(a, b);
    Float near = max(max(enter.x, enter.y), enter.z);
    Float far = min(min(leave.x, leave.y), leave.z);
    Float first = select(near > Float(0.0f), near, far);
    return select(both(near < far, far > Float(0.0f)), first, Float(FAR));
}

FN Float box_distance(IN(BoxRecord) box, IN(Ray) ray, Vec3 inverse) {
    return slab_distance(broadcast(box.low), broadcast(box.high), ray.origin, inverse);
}

// Outward normal of the face of the box from -1 to 1 on which p lies: the axis along which p is farthest out.
FN Vec3 cube_normal(Vec3 p) {
    Vec3 a = abs(p);
    Float zero = Float(0.0f);
    Mask is_x = both(a.x >= a.y, a.x >= a.z);
    Mask is_y = without(a.y >= a.z, is_x);
    Mask is_z = without(without(a.z >= zero, is_x), is_y);
    return vec3_of(select(is_x, with_sign_of(Float(1.0f), p.x), zero), select(is_y, with_sign_of(Float(1.0f), p.y), zero),
                   select(is_z, with_sign_of(Float(1.0f), p.z), zero));
}

// Texture coordinates on each face of the box from -1 to 1, 0 to 1 across it.
FN Vec2 cube_uv(Vec3 p, Vec3 n) {
    Mask on_x = abs(n.x) > Float(0.5f);
    Mask on_y = abs(n.y) > Float(0.5f);
    Float u = select(on_x, -p.z * n.x, select(on_y, p.x, p.x * n.z));
    Float v = select(on_y, -p.z * n.y, p.y);
    return vec2_of(u * Float(0.5f) + Float(0.5f), v * Float(0.5f) + Float(0.5f));
}

FN SurfacePoint box_surface(IN(BoxRecord) box, IN(Ray) ray, Float t) {
    SurfacePoint s;
    Vec3 low = broadcast(box.low);
    Vec3 high = broadcast(box.high);
    Vec3 p = ray.origin + ray.direction * t;
    Vec3 center = (low + high) * Float(0.5f);
    Vec3 half_ = (high - low) * Float(0.5f);
    Vec3 relative = (p - center) / half_;
    s.normal = cube_normal(relative);
    // On the face exactly; along it the error does not matter.
    Vec3 face = vec3_of(select(s.normal.x > Float(0.0f), high.x, low.x), select(s.normal.y > Float(0.0f), high.y, low.y),
                        select(s.normal.z > Float(0.0f), high.z, low.z));
    Vec3 across = abs(s.normal);
    s.position = vec3_of(select(across.x > Float(0.5f), face.x, p.x), select(across.y > Float(0.5f), face.y, p.y),
                         select(across.z > Float(0.5f), face.z, p.z));
    s.error = max(abs(low), abs(high)) * Float(4.0f * ROUNDING);
    s.shading = s.normal;
    s.local = s.position;
    s.uv = cube_uv(relative, s.normal);
    return s;
}

NAMESPACE_END

#endif
