// Surfaces of tiny mirrors: how their normals are distributed, how much of them is seen, and how one is drawn [Walter et al. 2007].
// GGX, stretched along the frame's axes by roughness_x and roughness_y.
#ifndef LANCER_KERNEL_BSDF_MICROFACET_H
#define LANCER_KERNEL_BSDF_MICROFACET_H

#include "lancer/kernel/bsdf/closure.h"

NAMESPACE_BEGIN

const float SMOOTH = 1.0e-3f;  // below this roughness a surface is a mirror: float directions can't tell

FN Float ggx_density(Vec3 m, Float ax, Float ay) {
    Float x = m.x / ax;
    Float y = m.y / ay;
    Float s = x * x + y * y + m.z * m.z;
    return Float(1.0f) / max(Float(PI) * ax * ay * s * s, Float(SMALLEST));
}

// Smith's lambda: (1 / G1 - 1).
FN Float ggx_lambda(Vec3 w, Float ax, Float ay) {
    Float x = ax * w.x;
    Float y = ay * w.y;
    Float slope = (x * x + y * y) / max(w.z * w.z, Float(SMALLEST));
    // Half of sqrt(1 + slope) - 1, without cancellation.
    return Float(0.5f) * slope / (Float(1.0f) + sqrt(Float(1.0f) + slope));
}

FN Float ggx_seen(Vec3 w, Float ax, Float ay) { return Float(1.0f) / (Float(1.0f) + ggx_lambda(w, ax, ay)); }

// Both directions at once, with heights correlated; wi may be on the other side.
FN Float ggx_seen_both(Vec3 wo, Vec3 wi, Float ax, Float ay) {
    return Float(1.0f) / (Float(1.0f) + ggx_lambda(wo, ax, ay) + ggx_lambda(wi, ax, ay));
}

// A normal among those seen from wo, with density D G1 |wo.m| / wo.z [Dupuy and Benyoub 2023].
FN Vec3 ggx_visible_normal(Vec3 wo, Float ax, Float ay, Vec2 u) {
    Vec3 standard = normalize(vec3_of(wo.x * ax, wo.y * ay, wo.z));
    Float z = (Float(1.0f) - u.x) * (Float(1.0f) + standard.z) - standard.z;
    Float r = sqrt(clamp01(Float(1.0f) - z * z));
    Vec2 p = on_circle(u.y);
    Vec3 h = vec3_of(r * p.x, r * p.y, z) + standard;
    return normalize(vec3_of(h.x * ax, h.y * ay, max(h.z, Float(1.0e-6f))));
}

FN Float ggx_visible_density(Vec3 wo, Vec3 m, Float ax, Float ay) {
    return ggx_density(m, ax, ay) * ggx_seen(wo, ax, ay) * max(dot(wo, m), Float(0.0f)) / max(wo.z, Float(SMALLEST));
}

NAMESPACE_END

#endif
