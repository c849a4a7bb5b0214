// Triangles as they are seen from a point: how much they cover of the directions there, and directions drawn evenly over that.
#ifndef LANCER_KERNEL_EMITTER_SOLID_ANGLE_H
#define LANCER_KERNEL_EMITTER_SOLID_ANGLE_H

#include "lancer/kernel/tables.h"
#include "lancer/kernel/warp.h"

NAMESPACE_BEGIN

const float LEAST_VOLUME = 1.0e-4f;  // of the three directions: nearer to the triangle's plane rounding would show

struct SeenTriangle {
    Vec3 a;  // ways to the corners
    Vec3 b;
    Vec3 c;
    Vec3 to_a;  // and directions, length 1
    Vec3 to_b;
    Vec3 to_c;
    Float volume;       // of the three directions, not signed
    Float solid_angle;  // 0 where it is to be drawn by its area
};

// [Van Oosterom and Strackee 1983]
FN SeenTriangle see_triangle(Vec3 a, Vec3 b, Vec3 c, Vec3 from) {
    SeenTriangle t;
    t.a = a - from;
    t.b = b - from;
    t.c = c - from;
    t.to_a = t.a / max(length(t.a), Float(SMALLEST));
    t.to_b = t.b / max(length(t.b), Float(SMALLEST));
    t.to_c = t.c / max(length(t.c), Float(SMALLEST));
    t.volume = abs(dot(t.to_a, cross(t.to_b, t.to_c)));
    Float rest = ((Float(1.0f) + dot(t.to_a, t.to_b)) + dot(t.to_b, t.to_c)) + dot(t.to_c, t.to_a);
    t.solid_angle = Float(2.0f) * angle_of(t.volume, rest);
    t.solid_angle = select(t.volume > Float(LEAST_VOLUME), t.solid_angle, Float(0.0f));
    return t;
}

// Barycentric coordinates (of b, of c) of a point whose direction is drawn evenly over the triangle: one number cuts off a part of the solid angle by an
// arc from b to the opposite side, the other goes along that arc [Arvo 1995; differs: the arc's end follows from the tangent of half the part's angle].
FN Vec2 on_seen_triangle(IN(SeenTriangle) t, Vec2 u) {
    Vec2 part = on_circle(u.x * t.solid_angle * Float(0.25f / PI));  // cosine and sine of half of it
    Float along = dot(t.to_a, t.to_c);
    Vec3 off = t.to_c - t.to_a * along;
    Float sine = max(length(off), Float(SMALLEST));
    off = off / sine;
    // Of half the angle between a and the arc's end.
    Float x = part.x * (t.volume / sine) - part.y * dot(t.to_b, off);
    Float y = part.y * (Float(1.0f) + dot(t.to_a, t.to_b));
    Float size = max(x * x + y * y, Float(SMALLEST));
    Vec3 end = t.to_a * ((x * x - y * y) / size) + off * (Float(2.0f) * x * y / size);
    // Evenly in the cosine, from b on.
    Vec3 chord = end - t.to_b;
    Float whole = Float(0.5f) * dot(chord, chord);  // 1 - cosine of the arc
    Float height = u.y * whole;
    Vec3 onwards = chord + t.to_b * whole;
    onwards = onwards / max(length(onwards), Float(SMALLEST));
    Vec3 direction = t.to_b * (Float(1.0f) - height) + onwards * sqrt(max(height * (Float(2.0f) - height), Float(0.0f)));
    Float of_a = abs(dot(direction, cross(t.b, t.c)));
    Float of_b = abs(dot(direction, cross(t.c, t.a)));
    Float of_c = abs(dot(direction, cross(t.a, t.b)));
    Float sum = max((of_a + of_b) + of_c, Float(SMALLEST));
    return vec2_of(of_b / sum, of_c / sum);
}

NAMESPACE_END

#endif
