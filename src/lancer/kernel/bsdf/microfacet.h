// Surfaces of tiny mirrors: how their normals are distributed, how much of them is seen, and how one is drawn [Walter et al. 2007].
// GGX or Beckmann's distribution, stretched along the frame's axes by roughness_x and roughness_y.
#ifndef LANCER_KERNEL_BSDF_MICROFACET_H
#define LANCER_KERNEL_BSDF_MICROFACET_H

#include "lancer/kernel/bsdf/closure.h"
#include "lancer/kernel/bsdf/error_function.h"

NAMESPACE_BEGIN

const float SMOOTH = 1.0e-3f;  // below this roughness a surface is a mirror: float directions can't tell

struct Facets {
    Float x;  // root mean square slopes times sqrt(2), of Beckmann's; of GGX the width alike
    Float y;
    Mask beckmann;
    Mask separate;
    Mask once;
};

// Whether the surface is one of facets; else it is smooth.
FN Mask is_rough(IN(Closure) c) { return max(c.roughness_x, c.roughness_y) >= Float(SMOOTH); }

FN Facets facets_of(IN(Closure) c) {
    Facets f;
    f.x = max(c.roughness_x, Float(SMOOTH));
    f.y = max(c.roughness_y, Float(SMOOTH));
    f.beckmann = c.beckmann;
    f.separate = c.separate;
    f.once = c.once;
    return f;
}

FN Facets ggx_facets(Float roughness) {
    Facets f;
    f.x = max(roughness, Float(SMOOTH));
    f.y = f.x;
    f.beckmann = nowhere();
    f.separate = f.beckmann;
    f.once = f.beckmann;
    return f;
}

// Facets with a normal m, per solid angle of normals and area of the surface.
FN Float facets_density(IN(Facets) f, Vec3 m) {
    Float x = m.x / f.x;
    Float y = m.y / f.y;
    Float s = x * x + y * y + m.z * m.z;
    Float density = Float(1.0f) / max(Float(PI) * f.x * f.y * s * s, Float(SMALLEST));
    if (some(f.beckmann)) {
        Float z2 = max(m.z * m.z, Float(1.0e-12f));
        Float gaussian = exponential(-(x * x + y * y) / z2) / (Float(PI) * f.x * f.y * z2 * z2);
        density = select(f.beckmann, gaussian, density);
    }
    return density;
}

// Smith's lambda: 1 / G1 - 1, the share of facets that others hide, over the share that is seen.
FN Float facets_lambda(IN(Facets) f, Vec3 w) {
    Float x = f.x * w.x;
    Float y = f.y * w.y;
    Float slope = (x * x + y * y) / max(w.z * w.z, Float(SMALLEST));
    // Half of sqrt(1 + slope) - 1, without cancellation.
    Float lambda = Float(0.5f) * slope / (Float(1.0f) + sqrt(Float(1.0f) + slope));
    if (some(f.beckmann)) {
        Float a = min(Float(1.0f) / sqrt(max(slope, Float(1.0e-12f))), Float(9.0f));
        Float e = exponential(-a * a);
        Float gaussian = Float(0.5f) * (e / (a * Float(SQRT_PI)) - complementary_error_function(a, e));
        lambda = select(f.beckmann, max(gaussian, Float(0.0f)), lambda);
    }
    return lambda;
}

FN Float facets_seen(IN(Facets) f, Vec3 w) { return Float(1.0f) / (Float(1.0f) + facets_lambda(f, w)); }

// Both directions at once; wi may be on the other side. With heights correlated, or as if the two had nothing to do with each other
// [Walter et al. 2007, eq. 23].
FN Float facets_seen_both(IN(Facets) f, Vec3 wo, Vec3 wi) {
    Float a = facets_lambda(f, wo);
    Float b = facets_lambda(f, wi);
    return Float(1.0f) / (Float(1.0f) + a + b + select(f.separate, a * b, Float(0.0f)));
}

// A slope along the line of sight among those that Beckmann's surface of roughness 1 shows to a direction of slope `a` = cot of its angle: the root
// of u = C(x) / C(a), C(x) = a (1 + erf x) / 2 + exp(-x^2) / (2 sqrt pi), by Newton's steps for erf x, from where they can't overshoot
// [Heitz and d'Eon 2014; Jakob 2014].
FN Float beckmann_visible_slope(Float a, Float u) {
    Float end = error_function(a);
    Float e = exponential(-a * a);
    Float goal = u * (a * (Float(1.0f) + end) + e * Float(1.0f / SQRT_PI));  // twice C
    Float y = max(u * (end + Float(1.0f)) - Float(1.0f), Float(-0.9999999f));
    Float x = inverse_error_function(y);
    for (int i = 0; i < 7; ++i) {
        Float value = a * (Float(1.0f) + y) + exponential(-x * x) * Float(1.0f / SQRT_PI);
        y = y + (goal - value) / max(a - x, Float(1.0e-4f));
        y = min(max(y, Float(-0.9999999f)), min(end, Float(0.9999999f)));
        x = inverse_error_function(y);
    }
    return x;
}

// A normal among those seen from wo, with density D G1 |wo.m| / wo.z [Dupuy and Benyoub 2023].
FN Vec3 facets_visible_normal(IN(Facets) f, Vec3 wo, Vec2 u) {
    Vec3 standard = normalize(vec3_of(wo.x * f.x, wo.y * f.y, wo.z));
    Float z = (Float(1.0f) - u.x) * (Float(1.0f) + standard.z) - standard.z;
    Float r = sqrt(clamp01(Float(1.0f) - z * z));
    Vec2 p = on_circle(u.y);
    Vec3 h = vec3_of(r * p.x, r * p.y, z) + standard;
    Vec3 normal = normalize(vec3_of(h.x * f.x, h.y * f.y, max(h.z, Float(1.0e-6f))));
    if (some(f.beckmann)) {
        Float sine = sqrt(standard.x * standard.x + standard.y * standard.y);
        Mask slanted = sine > Float(1.0e-6f);
        Float cosine_turn = select(slanted, standard.x / max(sine, Float(1.0e-6f)), Float(1.0f));
        Float sine_turn = select(slanted, standard.y / max(sine, Float(1.0e-6f)), Float(0.0f));
        Float along = beckmann_visible_slope(min(standard.z / max(sine, Float(1.0e-6f)), Float(1.0e4f)), u.x);
        Float across = inverse_error_function(min(max(Float(2.0f) * u.y - Float(1.0f), Float(-0.9999999f)), Float(0.9999999f)));
        Float slope_x = cosine_turn * along - sine_turn * across;
        Float slope_y = sine_turn * along + cosine_turn * across;
        normal = select(f.beckmann, normalize(vec3_of(-slope_x * f.x, -slope_y * f.y, Float(1.0f))), normal);
    }
    return normal;
}

FN Float facets_visible_density(IN(Facets) f, Vec3 wo, Vec3 m) {
    return facets_density(f, m) * facets_seen(f, wo) * max(dot(wo, m), Float(0.0f)) / max(wo.z, Float(SMALLEST));
}

NAMESPACE_END

#endif
