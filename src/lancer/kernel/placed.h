// Canonical shapes under any affine map: the ray is taken into the shape's own space, where its direction need not have length 1, so that t
// keeps its meaning.
#ifndef LANCER_KERNEL_PLACED_H
#define LANCER_KERNEL_PLACED_H

#include "lancer/kernel/box.h"
#include "lancer/kernel/sphere.h"

NAMESPACE_BEGIN

FN Vec3 apply_linear(IN(AffineRecord) map, Vec3 v) {
    return vec3_of(dot(broadcast(map.row_x), v), dot(broadcast(map.row_y), v), dot(broadcast(map.row_z), v));
}

FN Vec3 apply_affine(IN(AffineRecord) map, Vec3 p) { return apply_linear(map, p) + broadcast(map.shift); }

// The transposed linear part: takes normals from the map's target space back to its source.
FN Vec3 apply_transposed(IN(AffineRecord) map, Vec3 n) {
    return broadcast(map.row_x) * n.x + broadcast(map.row_y) * n.y + broadcast(map.row_z) * n.z;
}

// Each coordinate of |M| v: how far a box of half-size v reaches after the map.
FN Vec3 reach_linear(IN(AffineRecord) map, Vec3 v) {
    return vec3_of(dot(abs(broadcast(map.row_x)), v), dot(abs(broadcast(map.row_y)), v), dot(abs(broadcast(map.row_z)), v));
}

FN Float unit_sphere_distance(Vec3 o, Vec3 d) {
    Float a = dot(d, d);
    Float b = -dot(o, d);
    Vec3 l = o + d * (b / a);
    Float discriminant = Float(1.0f) - dot(l, l);
    Float c = dot(o, o) - Float(1.0f);
    Float q = b + with_sign_of(sqrt(max(discriminant * a, Float(0.0f))), b);
    Float one = q / a;
    Float other = c / q;
    Float near = min(one, other);
    Float first = select(near > Float(0.0f), near, max(one, other));
    return select(both(discriminant >= Float(0.0f), first > Float(0.0f)), first, Float(FAR));
}

FN Float unit_disk_distance(Vec3 o, Vec3 d) {
    Float t = -o.y / d.y;
    Float x = o.x + t * d.x;
    Float z = o.z + t * d.z;
    return select(both(both(t > Float(0.0f), t < Float(FAR)), x * x + z * z <= Float(1.0f)), t, Float(FAR));
}

// The disk of a radius at height y, as a candidate against t.
FN Float cap_distance(Vec3 o, Vec3 d, float height, float radius, Float t) {
    Float s = (Float(height) - o.y) / d.y;
    Float x = o.x + s * d.x;
    Float z = o.z + s * d.z;
    Mask meets = both(both(s > Float(0.0f), s < t), x * x + z * z <= Float(radius * radius));
    return select(meets, s, t);
}

// x^2 + z^2 = (bottom + k y)^2 for 0 <= y <= 1, with k = top - bottom; cylinders have k = 0. The origin is first moved to the point of the ray
// nearest the shape's middle: far origins would cost all digits of the discriminant.
FN Float cone_distance(IN(PlacedRecord) cone, Vec3 o, Vec3 d) {
    Vec3 from_middle = o - vec3_of(Float(0.0f), Float(0.5f), Float(0.0f));
    Float shift = -dot(from_middle, d) / dot(d, d);
    Vec3 p = o + d * shift;
    float k = cone.top_radius - cone.bottom_radius;
    Float radius = Float(cone.bottom_radius) + Float(k) * p.y;
    Float slope = Float(k) * d.y;
    Float a = d.x * d.x + d.z * d.z - slope * slope;
    Float b = p.x * d.x + p.z * d.z - slope * radius;
    Float c = p.x * p.x + p.z * p.z - radius * radius;
    Float discriminant = b * b - a * c;
    Mask meets = discriminant >= Float(0.0f);
    Float q = -(b + with_sign_of(sqrt(max(discriminant, Float(0.0f))), b));
    Float t_one = q / a + shift;
    Float t_other = c / q + shift;
    Float y_one = o.y + t_one * d.y;
    Float y_other = o.y + t_other * d.y;
    Float zero = Float(0.0f);
    Float one = Float(1.0f);
    Mask good_one = both(both(meets, both(t_one > zero, t_one < Float(FAR))), both(y_one >= zero, y_one <= one));
    Mask good_other = both(both(meets, both(t_other > zero, t_other < Float(FAR))), both(y_other >= zero, y_other <= one));
    Float t = select(good_one, t_one, Float(FAR));
    t = select(both(good_other, t_other < t), t_other, t);
    if (cone.capped != 0) {
        t = cap_distance(o, d, 0.0f, cone.bottom_radius, t);
        t = cap_distance(o, d, 1.0f, cone.top_radius, t);
    }
    return t;
}

FN Float placed_distance(IN(PlacedRecord) shape, int kind, IN(Ray) ray) {
    Vec3 o = apply_affine(shape.to_object, ray.origin);
    Vec3 d = apply_linear(shape.to_object, ray.direction);
    Float t = Float(FAR);
    if (kind == OBJECT_PLACED_SPHERE) {
        t = unit_sphere_distance(o, d);
    } else if (kind == OBJECT_PLACED_BOX) {
        t = slab_distance(vec3_all(Float(-1.0f)), vec3_all(Float(1.0f)), o, slab_reciprocal(d));
    } else if (kind == OBJECT_PLACED_DISK) {
        t = unit_disk_distance(o, d);
    } else {
        t = cone_distance(shape, o, d);
    }
    return t;
}

// Which of the cone's three parts p lies on decides its normal: the nearest one, in units of the height and of the radius.
FN Vec3 cone_normal(IN(PlacedRecord) cone, Vec3 p) {
    float k = cone.top_radius - cone.bottom_radius;
    Float ring = sqrt(p.x * p.x + p.z * p.z);
    Float to_side = abs(ring - (Float(cone.bottom_radius) + Float(k) * p.y));
    Float zero = Float(0.0f);
    Vec3 side = vec3_of(p.x, -Float(k) * ring, p.z);
    Vec3 n = select(ring > zero, side, vec3_of(zero, Float(1.0f), zero));
    if (cone.capped != 0) {
        n = select(abs(p.y) < to_side, vec3_of(zero, Float(-1.0f), zero), n);
        n = select(both(abs(p.y - Float(1.0f)) < to_side, Float(cone.top_radius) > zero), vec3_of(zero, Float(1.0f), zero), n);
    }
    return n;
}

FN SurfacePoint placed_surface(IN(PlacedRecord) shape, int kind, IN(Ray) ray, Float t) {
    SurfacePoint s;
    Vec3 p = apply_affine(shape.to_object, ray.origin) + apply_linear(shape.to_object, ray.direction) * t;
    Vec3 n = vec3_of(Float(0.0f), Float(1.0f), Float(0.0f));
    s.uv = vec2_of(Float(0.0f), Float(0.0f));
    if (kind == OBJECT_PLACED_SPHERE) {
        n = normalize(p);
        p = n;
        s.uv = sphere_uv(n);
    } else if (kind == OBJECT_PLACED_BOX) {
        n = cube_normal(p);
        p = p * (vec3_all(Float(1.0f)) - abs(n)) + n;
        s.uv = cube_uv(p, n);
    } else if (kind == OBJECT_PLACED_DISK) {
        p = vec3_of(p.x, Float(0.0f), p.z);
        s.uv = vec2_of(p.x * Float(0.5f) + Float(0.5f), Float(0.5f) - p.z * Float(0.5f));
    } else {
        n = cone_normal(shape, p);
        s.uv = vec2_of(angle_of(p.x, p.z) * Float(0.5f / PI) + Float(0.5f), p.y);
    }
    s.local = apply_affine(shape.to_author, p);
    s.position = apply_affine(shape.to_world, p);
    // Rounding in object space, there and back again, seen in world space.
    Vec3 back = reach_linear(shape.to_object, abs(s.position)) + abs(broadcast(shape.to_object.shift));
    Vec3 object_error = (back + abs(p) + vec3_all(Float(1.0f))) * Float(8.0f * ROUNDING);
    s.error = reach_linear(shape.to_world, object_error) +
              (reach_linear(shape.to_world, abs(p)) + abs(broadcast(shape.to_world.shift))) * Float(4.0f * ROUNDING);
    s.normal = normalize(apply_transposed(shape.to_object, n));
    s.shading = s.normal;
    return s;
}

NAMESPACE_END

#endif
