// Clear borders: what is not reflected goes through, bent.
#ifndef LANCER_KERNEL_BSDF_DIELECTRIC_H
#define LANCER_KERNEL_BSDF_DIELECTRIC_H

#include "lancer/kernel/bsdf/film.h"
#include "lancer/kernel/bsdf/stretched.h"
#include "lancer/kernel/warp.h"

NAMESPACE_BEGIN

// Facets that hardly bend light can't be told from where it goes.
FN Mask is_rough_border(IN(Closure) c) { return both(is_rough(c), abs(c.index.x - Float(1.0f)) > Float(2.0e-3f)); }

// Light that has met several facets: what is given back on the side of wo, and beyond [Kulla and Conty 2017].
struct BorderLoss {
    Float mean_front;
    Float mean_behind;
    Float through;  // the share of it that goes beyond: so that both directions agree
};

FN BorderLoss border_loss(IN(WorldRecord) world, IN(Closure) c, Mask mask) {
    Float eta = c.index.x;
    Facets f = facets_of(c);
    BorderLoss loss;
    loss.mean_front = max(mean_border_lost(world, f, eta, mask), Float(1.0e-6f));
    loss.mean_behind = max(mean_border_lost(world, f, Float(1.0f) / eta, mask), Float(1.0e-6f));
    // Of light from all directions a border lets as much through as comes back from the other side; there it fills a wider cone.
    Float denser = max(eta, Float(1.0f) / eta);
    Float passes = Float(1.0f) - mean_albedo(world, coat_place(denser, Float(0.0f), f), mask);
    passes = select(eta < Float(1.0f), passes * eta * eta, passes);
    loss.through = passes * min(Float(1.0f), loss.mean_behind / loss.mean_front);
    return loss;
}

FN BsdfValue dielectric_value(IN(WorldRecord) world, IN(Closure) c, Vec3 wo, Vec3 wi, Mask mask) {
    BsdfValue v = no_value();
    Mask rough = both(both(mask, is_rough_border(c)), wo.z > Float(0.0f));
    Mask reflects = wi.z > Float(0.0f);
    if (some(rough)) {
        Float eta = c.index.x;
        Facets f = facets_of(c);
        // The facet that takes wo to wi: half way between them, or where Snell's law puts it.
        Vec3 m = select(reflects, wo + wi, wo + wi * eta);
        Float size = dot(m, m);
        m = m / sqrt(max(size, Float(SMALLEST)));
        m = select(m.z < Float(0.0f), -m, m);
        Float o = dot(wo, m);
        Float i = dot(wi, m);
        Mask same_side = i > Float(0.0f);
        Mask good = both(rough, both(size > Float(SMALLEST), o > Float(0.0f)));
        good = either(both(good, both(reflects, same_side)), without(without(good, reflects), same_side));
        Spectrum share = border_share(c, o);
        Float chance = mean(share);
        Float facets = facets_density(f, m);
        Float seen = facets_seen(f, wo);
        Float both_seen = facets_seen_both(f, wo, wi);
        Float quarter = facets / max(Float(4.0f) * wo.z, Float(SMALLEST));
        Float bend = o + eta * i;
        Float through = facets * abs(o * i) * eta * eta / max(wo.z * bend * bend, Float(SMALLEST));
        Spectrum passed = vec4_all(Float(1.0f)) - share;
        // A path carries radiance, which is squeezed together on the denser side.
        Spectrum value = select(reflects, share * (quarter * both_seen), passed * (through * both_seen / (eta * eta)));
        Float density = seen * select(reflects, chance * quarter, (Float(1.0f) - chance) * through);
        value = select(good, value, black());
        density = select(good, density, Float(0.0f));
        // By several facets.
        BorderLoss loss = border_loss(world, c, rough);
        Float lost_out = select(c.once, Float(0.0f), border_lost(world, f, eta, wo, rough));
        Float lost_in = border_lost(world, f, select(reflects, eta, Float(1.0f) / eta), wi, rough);
        lost_in = lost_in / select(reflects, loss.mean_front, loss.mean_behind);
        Float side = abs(wi.z) * Float(1.0f / PI) * select(reflects, Float(1.0f) - loss.through, loss.through);
        Float several = lost_out * lost_in * side;
        value = value + vec4_all(select(reflects, several, several / (eta * eta)));
        v.value = select(rough, c.color * value, v.value);
        v.density = select(rough, between(density, side, lost_out), v.density);
        // What disperses goes through with its first wavelength only.
        Spectrum first_only = vec4_of(v.value.x * Float(4.0f), Float(0.0f), Float(0.0f), Float(0.0f));
        v.value = select(without(both(rough, c.disperses), reflects), first_only, v.value);
    }
    return v;
}

FN BsdfSample dielectric_sample(IN(WorldRecord) world, IN(Closure) c, Vec3 wo, Float choice, Vec2 u, Mask mask) {
    BsdfSample s = no_sample();
    Float eta = c.index.x;
    Mask rough = both(mask, is_rough_border(c));
    Mask good = both(mask, wo.z > Float(0.0f));
    Vec3 m = vec3_of(Float(0.0f), Float(0.0f), Float(1.0f));
    Float rest = choice;
    Mask several = nowhere();
    BorderLoss loss;
    if (some(rough)) {
        m = select(rough, facets_visible_normal(facets_of(c), wo, u), m);
        loss = border_loss(world, c, rough);
        Float lost = select(c.once, Float(0.0f), border_lost(world, facets_of(c), eta, wo, rough));
        several = both(rough, choice < lost);
        rest = select(
            rough, select(several, choice / max(lost, Float(SMALLEST)), (choice - lost) / max(Float(1.0f) - lost, Float(SMALLEST))), rest);
    }
    Float o = dot(wo, m);
    Spectrum share = border_share(c, o);
    Float chance = mean(share);
    Float cos_t = sqrt(max(squared_cos_t(o, eta), Float(0.0f)));
    Mask reflects = rest < chance;
    Vec3 mirrored = m * (Float(2.0f) * o) - wo;
    Vec3 bent = m * (o / eta - cos_t) - wo / eta;
    s.wi = select(reflects, mirrored, normalize(bent));
    // Smooth: the share over its chance. The radiance is squeezed together on the denser side.
    Spectrum passed = (vec4_all(Float(1.0f)) - share) / max((Float(1.0f) - chance) * eta * eta, Float(SMALLEST));
    s.weight = c.color * select(reflects, share / max(chance, Float(SMALLEST)), passed);
    Spectrum first_only = vec4_of(s.weight.x * Float(4.0f), Float(0.0f), Float(0.0f), Float(0.0f));
    s.weight = select(without(c.disperses, reflects), first_only, s.weight);
    s.transmits = without(good, reflects);
    s.discrete = without(good, rough);
    s.valid = s.discrete;
    if (some(rough)) {
        Vec3 diffuse = cosine_hemisphere(u);
        reflects = select_mask(several, rest >= loss.through, reflects);
        diffuse.z = select(reflects, diffuse.z, -diffuse.z);
        s.wi = select(several, diffuse, s.wi);
        s.transmits = without(good, reflects);
        Mask good_side = either(both(reflects, s.wi.z > Float(0.0f)), both(s.transmits, s.wi.z < Float(0.0f)));
        BsdfValue v = dielectric_value(world, c, wo, s.wi, rough);
        s.weight = select(rough, v.value / max(v.density, Float(SMALLEST)), s.weight);
        s.density = select(rough, v.density, s.density);
        s.valid = either(s.valid, both(both(rough, good_side), v.density > Float(0.0f)));
    }
    return s;
}

// ---- A pane so thin that it does not shift the ray: all the light that goes to and fro inside of it at once. ---------------------------

FN BsdfSample thin_dielectric_sample(IN(Closure) c, Vec3 wo, Float choice) {
    BsdfSample s = no_sample();
    Spectrum share = pane_spectrum(wo.z, c.index);
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
