// Clear borders: what is not reflected goes through, bent.
#ifndef LANCER_KERNEL_BSDF_DIELECTRIC_H
#define LANCER_KERNEL_BSDF_DIELECTRIC_H

#include "lancer/kernel/bsdf/fresnel.h"
#include "lancer/kernel/bsdf/microfacet.h"

NAMESPACE_BEGIN

// Whether the surface is one of facets; else it is smooth.
FN Mask is_rough(IN(Closure) c) { return max(c.roughness_x, c.roughness_y) >= Float(SMOOTH); }

FN BsdfValue dielectric_value(IN(Closure) c, Vec3 wo, Vec3 wi) {
    BsdfValue v = no_value();
    Mask reflects = wi.z > Float(0.0f);
    Float eta = c.index.x;
    Float ax = max(c.roughness_x, Float(SMOOTH));
    Float ay = max(c.roughness_y, Float(SMOOTH));
    // The facet that takes wo to wi: half way between them, or where Snell's law puts it.
    Vec3 m = select(reflects, wo + wi, wo + wi * eta);
    Float size = dot(m, m);
    m = m / sqrt(max(size, Float(SMALLEST)));
    m = select(m.z < Float(0.0f), -m, m);
    Float o = dot(wo, m);
    Float i = dot(wi, m);
    Mask same_side = i > Float(0.0f);
    Mask good = both(both(is_rough(c), size > Float(SMALLEST)), both(wo.z > Float(0.0f), o > Float(0.0f)));
    good = either(both(good, both(reflects, same_side)), without(without(good, reflects), same_side));
    if (some(good)) {
        Spectrum share = fresnel_spectrum(o, c.index);
        Float chance = mean(share);
        Float facets = ggx_density(m, ax, ay);
        Float seen = ggx_seen(wo, ax, ay);
        Float both_seen = ggx_seen_both(wo, wi, ax, ay);
        Float quarter = facets / max(Float(4.0f) * wo.z, Float(SMALLEST));
        Float bend = o + eta * i;
        Float through = facets * abs(o * i) * eta * eta / max(wo.z * bend * bend, Float(SMALLEST));
        Spectrum passed = c.color * (vec4_all(Float(1.0f)) - share);
        // A path carries radiance, which is squeezed together on the denser side.
        v.value =
            select(good, select(reflects, c.color * share * (quarter * both_seen), passed * (through * both_seen / (eta * eta))), v.value);
        v.density = select(good, select(reflects, chance * quarter * seen, (Float(1.0f) - chance) * through * seen), v.density);
        // What disperses goes through with its first wavelength only.
        Spectrum first_only = vec4_of(v.value.x * Float(4.0f), Float(0.0f), Float(0.0f), Float(0.0f));
        v.value = select(without(both(good, c.disperses), reflects), first_only, v.value);
    }
    return v;
}

FN BsdfSample dielectric_sample(IN(Closure) c, Vec3 wo, Float choice, Vec2 u) {
    BsdfSample s = no_sample();
    Float eta = c.index.x;
    Float ax = max(c.roughness_x, Float(SMOOTH));
    Float ay = max(c.roughness_y, Float(SMOOTH));
    Mask rough = is_rough(c);
    Vec3 m = vec3_of(Float(0.0f), Float(0.0f), Float(1.0f));
    if (some(rough)) {
        m = select(rough, ggx_visible_normal(wo, ax, ay, u), m);
    }
    Float o = dot(wo, m);
    Spectrum share = fresnel_spectrum(o, c.index);
    Float chance = mean(share);
    Float cos_t = sqrt(max(squared_cos_t(o, eta), Float(0.0f)));
    Mask reflects = choice < chance;
    Vec3 mirrored = m * (Float(2.0f) * o) - wo;
    Vec3 bent = m * (o / eta - cos_t) - wo / eta;
    s.wi = select(reflects, mirrored, normalize(bent));
    s.transmits = without(o > Float(0.0f), reflects);
    s.discrete = without(o > Float(0.0f), rough);
    Mask good_side = either(both(reflects, s.wi.z > Float(0.0f)), both(s.transmits, s.wi.z < Float(0.0f)));
    s.valid = both(good_side, o > Float(0.0f));
    // Smooth: the share over its chance. The radiance is squeezed together on the denser side.
    Spectrum passed = (vec4_all(Float(1.0f)) - share) / max((Float(1.0f) - chance) * eta * eta, Float(SMALLEST));
    s.weight = c.color * select(reflects, share / max(chance, Float(SMALLEST)), passed);
    Spectrum first_only = vec4_of(s.weight.x * Float(4.0f), Float(0.0f), Float(0.0f), Float(0.0f));
    s.weight = select(both(s.transmits, c.disperses), first_only, s.weight);
    if (some(rough)) {
        Float seen = ggx_seen(wo, ax, ay);
        Float facets = ggx_density(m, ax, ay);
        Float i = dot(s.wi, m);
        Float bend = o + eta * i;
        Float quarter = facets / max(Float(4.0f) * wo.z, Float(SMALLEST));
        Float through = facets * abs(o * i) * eta * eta / max(wo.z * bend * bend, Float(SMALLEST));
        Float density = seen * select(reflects, chance * quarter, (Float(1.0f) - chance) * through);
        s.weight = select(rough, s.weight * (ggx_seen_both(wo, s.wi, ax, ay) / seen), s.weight);
        s.density = select(rough, density, s.density);
    }
    return s;
}

// ---- A pane so thin that it does not shift the ray: all the light that goes to and fro inside of it at once. ---------------------------

FN BsdfSample thin_dielectric_sample(IN(Closure) c, Vec3 wo, Float choice) {
    BsdfSample s = no_sample();
    Spectrum once = fresnel_spectrum(wo.z, c.index);
    Spectrum share = once * Float(2.0f) / (vec4_all(Float(1.0f)) + once);  // r + t r t + t r^3 t + ... with t = 1 - r
    Float chance = mean(share);
    Mask reflects = choice < chance;
    s.wi = select(reflects, vec3_of(-wo.x, -wo.y, wo.z), -wo);
    Spectrum passed = (vec4_all(Float(1.0f)) - share) / max(Float(1.0f) - chance, Float(SMALLEST));
    s.weight = c.color * select(reflects, share / max(chance, Float(SMALLEST)), passed);
    s.transmits = without(wo.z > Float(0.0f), reflects);
    s.discrete = wo.z > Float(0.0f);
    s.valid = s.discrete;
    return s;
}

NAMESPACE_END

#endif
