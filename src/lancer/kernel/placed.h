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

// Where a line is inside of the infinite cone x^2 + z^2 = (bottom + k y)^2, k = top - bottom (0: a cylinder), and where it is between the
// planes y = 0 and y = 1 that end it.
struct ConeSpan {
    Float side_in;
    Float side_out;
    Float ends_in;
    Float ends_out;
    Mask meets;
};

// The origin is first moved to the point of the line nearest the shape's middle: far origins would cost all digits of the discriminant.
FN ConeSpan cone_span(IN(PlacedRecord) cone, Vec3 o, Vec3 d) {
    Vec3 from_middle = o - vec3_of(Float(0.0f), Float(0.5f), Float(0.0f));
    Float shift = -dot(from_middle, d) / dot(d, d);
    Vec3 p = o + d * shift;
    Float k = Float(cone.top_radius) - Float(cone.bottom_radius);
    Float radius = Float(cone.bottom_radius) + k * p.y;
    Float slope = k * d.y;
    Float a = d.x * d.x + d.z * d.z - slope * slope;
    Float b = p.x * d.x + p.z * d.z - slope * radius;
    Float c = p.x * p.x + p.z * p.z - radius * radius;
    Float discriminant = b * b - a * c;
    Float zero = Float(0.0f);
    Float far = Float(FAR);
    Mask steep = a < zero;  // the line goes from one nappe into the other: it always meets both
    ConeSpan span;
    span.meets = either(discriminant >= zero, steep);
    Float q = -(b + with_sign_of(sqrt(max(discriminant, zero)), b));
    Mask two_roots = abs(q) > zero;
    Float one = select(two_roots, q / a, zero);
    Float other = select(two_roots, c / q, zero);
    Float first = min(one, other) + shift;
    Float second = max(one, other) + shift;
    // Inside between the roots; on a steep line before the first or behind the second, where the nappe is that counts.
    Mask widens = slope > zero;
    span.side_in = select(steep, select(widens, second, -far), first);
    span.side_out = select(steep, select(widens, far, first), second);
    // A line along the axis of a cylinder has no roots: it is inside everywhere or nowhere.
    Mask along = without(abs(a) <= zero, two_roots);
    span.side_in = select(along, -far, span.side_in);
    span.side_out = select(along, far, span.side_out);
    span.meets = without(span.meets, both(along, c >= zero));
    Float inverse = Float(1.0f) / select(abs(d.y) < Float(SMALLEST), Float(SMALLEST), d.y);
    Float y_0 = -o.y * inverse;
    Float y_1 = (Float(1.0f) - o.y) * inverse;
    span.ends_in = min(y_0, y_1);
    span.ends_out = max(y_0, y_1);
    return span;
}

// A capped cone is the body that side and ends enclose together, so that no ray slips in at a rim; without caps there are the side's two points.
FN Float cone_distance(IN(PlacedRecord) cone, Vec3 o, Vec3 d) {
    ConeSpan span = cone_span(cone, o, d);
    Float zero = Float(0.0f);
    Float t = Float(FAR);
    if (cone.capped != 0) {
        Float near = max(span.side_in, span.ends_in);
        Float far = min(span.side_out, span.ends_out);
        Float first = select(near > zero, near, far);
        t = select(both(span.meets, both(far > zero, near < far)), first, t);
    } else {
        Mask out_meets = both(span.side_out > zero, both(span.side_out >= span.ends_in, span.side_out <= span.ends_out));
        Mask in_meets = both(span.side_in > zero, both(span.side_in >= span.ends_in, span.side_in <= span.ends_out));
        t = select(both(span.meets, out_meets), span.side_out, t);
        t = select(both(span.meets, in_meets), span.side_in, t);
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

struct ConePoint {
    Vec3 p;
    Vec3 n;  // outwards, of any length
};

// The point of the cone nearest `p`, on the part that cone_distance met; a point within a cap or a side keeps `room` from the rim, so that a
// ray that goes on inside has a way to go.
FN ConePoint cone_point(IN(PlacedRecord) cone, Vec3 o, Vec3 d, Vec3 p, Vec3 room) {
    Float zero = Float(0.0f);
    Float one = Float(1.0f);
    Mask on_end = one < zero;
    Mask on_top = on_end;
    if (cone.capped != 0) {
        ConeSpan span = cone_span(cone, o, d);
        Mask outside = max(span.side_in, span.ends_in) > zero;
        on_end = either(both(outside, span.ends_in > span.side_in), without(span.ends_out < span.side_out, outside));
        on_top = either(both(outside, d.y < zero), without(d.y > zero, outside));
    }
    Float k = Float(cone.top_radius) - Float(cone.bottom_radius);
    Float y_room = min(room.y, Float(0.5f));
    Float y = select(on_end, select(on_top, one, zero), min(max(p.y, y_room), one - y_room));
    Float radius = Float(cone.bottom_radius) + k * y;
    Float ring = sqrt(p.x * p.x + p.z * p.z);
    Float widest = max(radius - max(room.x, room.z), zero);
    Float scale = select(on_end, min(ring, widest), radius) / max(ring, Float(SMALLEST));
    ConePoint point;
    point.p = vec3_of(p.x * scale, y, p.z * scale);
    Vec3 up = vec3_of(zero, one, zero);
    Vec3 side = select(ring > zero, vec3_of(p.x, -k * ring, p.z), select(k > zero, -up, up));
    point.n = select(on_end, select(on_top, up, -up), side);
    return point;
}

// How far rounding can put a point of the shape off its surface, in object space, if it is taken to world space and a ray from there comes back.
// The maps as floats and their products and sums lose at most 5 units of rounding of all that is added up, on either way; the formulas of the
// shapes less than 6, of lengths up to 1.
FN Vec3 placed_rounding(IN(PlacedRecord) shape) {
    Vec3 farthest = reach_linear(shape.to_world, vec3_all(Float(1.0f))) + abs(broadcast(shape.to_world.shift));
    Vec3 back = reach_linear(shape.to_object, farthest) + abs(broadcast(shape.to_object.shift));
    return back * Float(10.0f * ROUNDING) + vec3_all(Float(6.0f * ROUNDING));
}

// How many such units a point keeps from the edges of its face: leaving it, a ray is moved along the normal by up to 3 of them for a turned
// shape (each coordinate of the world may hold a share of three), and along the face by more where the shape is stretched.
const float ROOM = 8.0f;

// Of a point of a canonical shape; `n` is its normal there.
FN Vec2 placed_uv(int kind, Vec3 p, Vec3 n) {
    Vec2 uv = vec2_of(Float(0.0f), Float(0.0f));
    if (kind == OBJECT_PLACED_SPHERE) {
        uv = sphere_uv(n);
    } else if (kind == OBJECT_PLACED_BOX) {
        uv = cube_uv(p, n);
    } else if (kind == OBJECT_PLACED_DISK) {
        uv = vec2_of(p.x * Float(0.5f) + Float(0.5f), Float(0.5f) - p.z * Float(0.5f));
    } else {
        uv = vec2_of(angle_of(p.x, p.z) * Float(0.5f / PI) + Float(0.5f), p.y);
    }
    return uv;
}

FN SurfacePoint placed_surface(IN(PlacedRecord) shape, int kind, IN(Ray) ray, Float t) {
    SurfacePoint s = no_surface();
    Vec3 o = apply_affine(shape.to_object, ray.origin);
    Vec3 d = apply_linear(shape.to_object, ray.direction);
    Vec3 p = o + d * t;
    Vec3 n = vec3_of(Float(0.0f), Float(1.0f), Float(0.0f));
    Vec3 rounding = placed_rounding(shape);
    if (kind == OBJECT_PLACED_SPHERE) {
        n = normalize(p);
        p = n;
    } else if (kind == OBJECT_PLACED_BOX) {
        Vec3 one = vec3_all(Float(1.0f));
        Ray local_ray;
        local_ray.origin = o;
        local_ray.direction = d;
        local_ray.reach = ray.reach;
        n = slab_normal(-one, one, local_ray, slab_reciprocal(d));
        p = onto_face(-one, one, rounding * Float(ROOM), n, p);
    } else if (kind == OBJECT_PLACED_DISK) {
        p = vec3_of(p.x, Float(0.0f), p.z);
    } else {
        ConePoint point = cone_point(shape, o, d, p, rounding * Float(ROOM));
        p = point.p;
        n = point.n;
    }
    s.uv = placed_uv(kind, p, n);
    s.local = apply_affine(shape.to_author, p);
    s.local_in = -normalize(apply_linear(shape.to_author, n));
    s.position = apply_affine(shape.to_world, p);
    s.error = reach_linear(shape.to_world, rounding);
    s.normal = normalize(apply_transposed(shape.to_object, n));
    s.shading = s.normal;
    return s;
}

NAMESPACE_END

#endif
