// A right-handed frame around a normal, and directions in it: z along the normal, lengths and angles as in the world.
#ifndef LANCER_KERNEL_FRAME_H
#define LANCER_KERNEL_FRAME_H

#include "lancer/kernel/math.h"

NAMESPACE_BEGIN

struct Frame {
    Vec3 x;
    Vec3 y;
    Vec3 z;
};

// Any frame with z along `normal` (length 1), without a jump but where z crosses 0 [Duff et al. 2017].
FN Frame frame_around(Vec3 normal) {
    Float one_signed = with_sign_of(Float(1.0f), normal.z);
    Float a = Float(-1.0f) / (one_signed + normal.z);
    Float b = normal.x * normal.y * a;
    Frame f;
    f.x = vec3_of(Float(1.0f) + one_signed * normal.x * normal.x * a, one_signed * b, -one_signed * normal.x);
    f.y = vec3_of(b, one_signed + normal.y * normal.y * a, -normal.y);
    f.z = normal;
    return f;
}

// With x as near to `along` as can be; any where that is 0 or along the normal.
FN Frame frame_along(Vec3 normal, Vec3 along) {
    Frame f = frame_around(normal);
    Vec3 x = along - normal * dot(normal, along);
    Float size = dot(x, x);
    Mask good = size > Float(1.0e-6f) * dot(along, along);
    f.x = select(good, x / sqrt(max(size, Float(SMALLEST))), f.x);
    f.y = select(good, cross(normal, f.x), f.y);
    return f;
}

FN Vec3 to_local(IN(Frame) frame, Vec3 v) { return vec3_of(dot(v, frame.x), dot(v, frame.y), dot(v, frame.z)); }

FN Vec3 to_world(IN(Frame) frame, Vec3 v) { return frame.x * v.x + frame.y * v.y + frame.z * v.z; }

NAMESPACE_END

#endif
