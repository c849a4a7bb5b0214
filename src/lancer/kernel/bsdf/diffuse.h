// Lambert's surface: equally bright from everywhere. And a rough one, of small Lambertian facets.
#ifndef LANCER_KERNEL_BSDF_DIFFUSE_H
#define LANCER_KERNEL_BSDF_DIFFUSE_H

#include "lancer/kernel/bsdf/closure.h"
#include "lancer/kernel/warp.h"

NAMESPACE_BEGIN

FN BsdfValue diffuse_value(IN(Closure) c, Vec3 wi) {
    BsdfValue v;
    v.density = max(wi.z, Float(0.0f)) * Float(1.0f / PI);
    v.value = c.color * v.density;
    return v;
}

FN BsdfSample diffuse_sample(IN(Closure) c, Vec2 u) {
    BsdfSample s = no_sample();
    s.wi = cosine_hemisphere(u);
    s.density = s.wi.z * Float(1.0f / PI);
    s.weight = c.color;
    s.valid = s.wi.z > Float(0.0f);
    return s;
}

// ---- Rough: Oren and Nayar's facets with all the light that goes from facet to facet, so that white stays white
// [Portsmouth et al. 2024]. `roughness_x` is their roughness r from 0 to 1.

const float FON_1 = 0.28779262f;  // 1/2 - 2 / (3 pi)
const float FON_2 = 0.07248822f;  // 2/3 - 28 / (15 pi)

// What a white surface without light from facet to facet reflects of light from a direction; the exact integral in polynomial form.
FN Float fon_albedo(Float cosine, Float roughness) {
    Float a = Float(1.0f) / (Float(1.0f) + Float(FON_1) * roughness);
    Float c = Float(1.0f) - cosine;
    Float g = c * (Float(0.0571085289f) + c * (Float(0.491881867f) + c * (Float(-0.332181442f) + c * Float(0.0714429953f))));
    return (Float(1.0f) + roughness * g) * a;
}

FN BsdfValue rough_diffuse_value(IN(Closure) c, Vec3 wo, Vec3 wi) {
    Float r = c.roughness_x;
    Float a = Float(1.0f) / (Float(1.0f) + Float(FON_1) * r);
    Float s = dot(wo, wi) - wo.z * wi.z;
    Float over = select(s > Float(0.0f), s / max(max(wo.z, wi.z), Float(SMALLEST)), s);
    Spectrum single = c.color * (Float(1.0f / PI) * a * (Float(1.0f) + r * over));
    // The light that has met more than one facet.
    Float mean_albedo = (Float(1.0f) + Float(FON_2) * r) * a;
    Float left_out = max(Float(1.0f) - fon_albedo(wo.z, r), Float(1.0e-7f));
    Float left_in = max(Float(1.0f) - fon_albedo(wi.z, r), Float(1.0e-7f));
    Float left_mean = max(Float(1.0f) - mean_albedo, Float(1.0e-7f));
    Spectrum tint = c.color * c.color * mean_albedo / (vec4_all(Float(1.0f)) - c.color * left_mean);
    Spectrum several = tint * (Float(1.0f / PI) * left_out * left_in / left_mean);
    BsdfValue v;
    Float cosine = max(wi.z, Float(0.0f));
    v.value = (single + several) * cosine;
    v.density = cosine * Float(1.0f / PI);
    return v;
}

FN BsdfSample rough_diffuse_sample(IN(Closure) c, Vec3 wo, Vec2 u) {
    BsdfSample s = no_sample();
    s.wi = cosine_hemisphere(u);
    BsdfValue v = rough_diffuse_value(c, wo, s.wi);
    s.density = v.density;
    s.weight = v.value / max(v.density, Float(SMALLEST));
    s.valid = s.wi.z > Float(0.0f);
    return s;
}

NAMESPACE_END

#endif
