// Metals: mirrors, smooth or of small facets, that reflect as Fresnel's formulas say and swallow the rest.
#ifndef LANCER_KERNEL_BSDF_CONDUCTOR_H
#define LANCER_KERNEL_BSDF_CONDUCTOR_H

#include "lancer/kernel/bsdf/fresnel.h"
#include "lancer/kernel/bsdf/microfacet.h"

NAMESPACE_BEGIN

FN BsdfValue conductor_value(IN(Closure) c, Vec3 wo, Vec3 wi) {
    BsdfValue v = no_value();
    Vec3 m = normalize(wo + wi);
    Float ax = max(c.roughness_x, Float(SMOOTH));
    Float ay = max(c.roughness_y, Float(SMOOTH));
    Float cosine = dot(wo, m);
    Mask rough = max(c.roughness_x, c.roughness_y) >= Float(SMOOTH);
    Mask good = both(rough, both(both(wo.z > Float(0.0f), wi.z > Float(0.0f)), cosine > Float(0.0f)));
    Float facets = ggx_density(m, ax, ay);
    Spectrum reflected = c.color * fresnel_conductor_spectrum(cosine, c.index, c.extinction);
    Float quarter = Float(0.25f) / max(wo.z, Float(SMALLEST));
    v.value = select(good, reflected * (facets * ggx_seen_both(wo, wi, ax, ay) * quarter), v.value);
    v.density = select(good, facets * ggx_seen(wo, ax, ay) * quarter, v.density);
    return v;
}

FN BsdfSample conductor_sample(IN(Closure) c, Vec3 wo, Vec2 u) {
    BsdfSample s = no_sample();
    Float ax = max(c.roughness_x, Float(SMOOTH));
    Float ay = max(c.roughness_y, Float(SMOOTH));
    Mask smooth_ = max(c.roughness_x, c.roughness_y) < Float(SMOOTH);
    Vec3 m = ggx_visible_normal(wo, ax, ay, u);
    m = select(smooth_, vec3_of(Float(0.0f), Float(0.0f), Float(1.0f)), m);
    s.wi = m * (Float(2.0f) * dot(wo, m)) - wo;
    Float cosine = dot(wo, m);
    Spectrum reflected = c.color * fresnel_conductor_spectrum(cosine, c.index, c.extinction);
    Float seen = ggx_seen(wo, ax, ay);
    s.weight = select(smooth_, reflected, reflected * (ggx_seen_both(wo, s.wi, ax, ay) / seen));
    s.density = select(smooth_, Float(0.0f), ggx_density(m, ax, ay) * seen * Float(0.25f) / max(wo.z, Float(SMALLEST)));
    s.discrete = smooth_;
    s.valid = both(s.wi.z > Float(0.0f), cosine > Float(0.0f));
    return s;
}

NAMESPACE_END

#endif
