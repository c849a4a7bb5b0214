// Metals: mirrors, smooth or of small facets, that reflect as Fresnel's formulas say and swallow the rest. Light that meets several facets comes
// back by a second lobe, which makes a white metal as bright when rough as when smooth [Kulla and Conty 2017].
#ifndef LANCER_KERNEL_BSDF_CONDUCTOR_H
#define LANCER_KERNEL_BSDF_CONDUCTOR_H

#include "lancer/kernel/bsdf/fresnel.h"
#include "lancer/kernel/bsdf/stretched.h"
#include "lancer/kernel/warp.h"

NAMESPACE_BEGIN

// The colour of light that has met several facets, of mean reflectance `once` each.
FN Spectrum several_times(Spectrum once, Float lost) { return once * once * (Float(1.0f) - lost) / (vec4_all(Float(1.0f)) - once * lost); }

FN Spectrum mean_fresnel_conductor(Spectrum n, Spectrum k) {
    // The mean over the squared cosine, by the rule of Gauss and Legendre with two nodes.
    return (fresnel_conductor_spectrum(Float(0.45970084f), n, k) + fresnel_conductor_spectrum(Float(0.88807383f), n, k)) * Float(0.5f);
}

FN BsdfValue conductor_value(IN(WorldRecord) world, IN(Closure) c, Vec3 wo, Vec3 wi, Mask mask) {
    BsdfValue v = no_value();
    Mask good = both(both(mask, is_rough(c)), both(wo.z > Float(0.0f), wi.z > Float(0.0f)));
    if (some(good)) {
        Facets f = facets_of(c);
        Vec3 m = normalize(wo + wi);
        Float cosine = dot(wo, m);
        Float facets = facets_density(f, m) * Float(0.25f) / max(wo.z, Float(SMALLEST));
        Spectrum once = c.color * fresnel_conductor_spectrum(cosine, c.index, c.extinction) * (facets * facets_seen_both(f, wo, wi));
        Float lost_out = facet_loss(world, f, wo, good);
        Float lost_in = facet_loss(world, f, wi, good);
        Float lost = mean_facet_loss(world, f, good);
        Float diffuse = wi.z * Float(1.0f / PI);
        Spectrum tint = several_times(c.color * mean_fresnel_conductor(c.index, c.extinction), lost);
        v.value = select(good, once + tint * (lost_out * lost_in / max(lost, Float(1.0e-6f)) * diffuse), v.value);
        v.density = select(good, between(facets * facets_seen(f, wo), diffuse, lost_out), v.density);
    }
    return v;
}

FN BsdfSample conductor_sample(IN(WorldRecord) world, IN(Closure) c, Vec3 wo, Float choice, Vec2 u, Mask mask) {
    BsdfSample s = no_sample();
    Mask rough = both(mask, is_rough(c));
    Mask smooth_ = without(both(mask, wo.z > Float(0.0f)), rough);
    s.wi = vec3_of(-wo.x, -wo.y, wo.z);
    s.weight = c.color * fresnel_conductor_spectrum(wo.z, c.index, c.extinction);
    s.discrete = smooth_;
    s.valid = smooth_;
    if (some(rough)) {
        Facets f = facets_of(c);
        Vec3 m = facets_visible_normal(f, wo, u);
        Vec3 wi = m * (Float(2.0f) * dot(wo, m)) - wo;
        wi = select(choice < facet_loss(world, f, wo, rough), cosine_hemisphere(u), wi);
        BsdfValue v = conductor_value(world, c, wo, wi, rough);
        s.wi = select(rough, wi, s.wi);
        s.weight = select(rough, v.value / max(v.density, Float(SMALLEST)), s.weight);
        s.density = select(rough, v.density, s.density);
        s.valid = either(s.valid, both(rough, v.density > Float(0.0f)));
    }
    return s;
}

NAMESPACE_END

#endif
