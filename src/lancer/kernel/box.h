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
    return select(both(far > Float(0.0f), near < far), first, Float(FAR));
}

FN Float box_distance(IN(BoxRecord) box, IN(Ray) ray, Vec3 inverse) {
    return slab_distance(broadcast(box.low), broadcast(box.high), ray.origin, inverse);
}

// Outward normal of the face that slab_distance meets: of the slab that is entered last, or left first by a ray from inside. From the ray and
// not from the point, whose rounding could name the other face of an edge: then light would leave a body that it never entered.
FN Vec3 slab_normal(Vec3 low, Vec3 high, IN(Ray) ray, Vec3 inverse) {
    Vec3 a = (low - ray.origin) * inverse;
    Vec3 b = (high - ray.origin) * inverse;
    Vec3 enter = min(a, b);
    Mask outside = max(max(enter.x, enter.y), enter.z) > Float(0.0f);
    Vec3 decides = select(outside, enter, -max(a, b));
    Vec3 facing = select(outside, -ray.direction, ray.direction);
    Mask is_x = both(decides.x >= decides.y, decides.x >= decides.z);
    Mask is_y = without(decides.y >= decides.z, is_x);
    Mask is_z = without(without(decides.z >= decides.z, is_x), is_y);
    Float zero = Float(0.0f);
    Float one = Float(1.0f);
    return vec3_of(select(is_x, with_sign_of(one, facing.x), zero), select(is_y, with_sign_of(one, facing.y), zero),
                   select(is_z, with_sign_of(one, facing.z), zero));
}

// A point on the face with that normal: on it exactly, and off its edges by `room`, so that a ray that goes on inside has a way to go.
FN Vec3 onto_face(Vec3 low, Vec3 high, Vec3 room, Vec3 normal, Vec3 p) {
    Vec3 center = (low + high) * Float(0.5f);
    Vec3 inner = min(max(p, min(low + room, center)), max(high - room, center));
    Vec3 face = vec3_of(select(normal.x > Float(0.0f), high.x, low.x), select(normal.y > Float(0.0f), high.y, low.y),
                        select(normal.z > Float(0.0f), high.z, low.z));
    Float half_ = Float(0.5f);
    return vec3_of(select(abs(normal.x) > half_, face.x, inner.x), select(abs(normal.y) > half_, face.y, inner.y),
                   select(abs(normal.z) > half_, face.z, inner.z));
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
    SurfacePoint s = no_surface();
    Vec3 low = broadcast(box.low);
    Vec3 high = broadcast(box.high);
    // The face's own coordinate is exact. Coming back, low - origin rounds by half an ulp of either.
    s.error = max(abs(low), abs(high)) * Float(4.0f * ROUNDING);
    s.normal = slab_normal(low, high, ray, slab_reciprocal(ray.direction));
    s.position = onto_face(low, high, s.error * Float(2.0f), s.normal, ray.origin + ray.direction * t);
    s.shading = s.normal;
    s.local = s.position;
    s.local_in = -s.normal;
    s.uv = cube_uv((s.position - (low + high) * Float(0.5f)) / ((high - low) * Float(0.5f)), s.normal);
    return s;
}

NAMESPACE_END

#endif
