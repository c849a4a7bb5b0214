// Burley's surface, as films and games know it, after the formulas that were published [Burley 2012; Burley 2015]: metal, coloured body or clear
// body under a clear coat and a sheen; or a sheet without thickness. It keeps no account of light: what facets, coat and body take of it adds up
// to somewhat more or less than there is. Scenes of other programs are written for it; BSDF_PRINCIPLED is what lancer itself offers.
//
// Of the closure it takes, besides what the principled surface does: `sheen_roughness`, how much sheen; `sheen`, how much the sheen and then what
// is reflected takes of the base's colour, how flat the body looks, and the luminance of the base; `film_index`, the share of the body's light
// that a sheet lets through.
#ifndef LANCER_KERNEL_BSDF_BURLEY_H
#define LANCER_KERNEL_BSDF_BURLEY_H

#include "lancer/kernel/bsdf/fresnel.h"
#include "lancer/kernel/bsdf/microfacet.h"
#include "lancer/kernel/warp.h"

NAMESPACE_BEGIN

// By Schlick's formula: of what is not reflected straight on, the share that is reflected at an angle [Schlick 1994].
FN Float grazing_share(Float cosine) {
    Float off = clamp01(Float(1.0f) - cosine);
    return off * off * off * off * off;
}

FN Spectrum grazing_fresnel(Spectrum straight, Float cosine) {
    return straight + (vec4_all(Float(1.0f)) - straight) * grazing_share(cosine);
}

// The base's colour, as bright as white, by a share; else white.
FN Spectrum base_tint(IN(Closure) c, Float share) {
    Spectrum tint = select(c.sheen.w > Float(0.0f), c.color / max(c.sheen.w, Float(1.0e-6f)), vec4_all(Float(1.0f)));
    return vec4_all(Float(1.0f) - share) + tint * share;
}

struct BurleyParts {
    Facets facets;
    Facets passing;  // of a sheet, for what goes through
    Mask outside;
    Float body;   // the share of the diffuse body
    Float clear;  // and of the clear one
    Float facet_chance;
    Float coat_chance;  // the rest: body
};

FN BurleyParts burley_parts(IN(Closure) c) {
    BurleyParts p;
    p.facets = facets_of(c);
    // The longer slopes lie along u.
    p.facets.x = max(c.roughness_y, Float(SMOOTH));
    p.facets.y = max(c.roughness_x, Float(SMOOTH));
    p.facets.beckmann = nowhere();
    p.facets.separate = Float(0.0f) < Float(1.0f);
    p.outside = either(c.index.x >= Float(1.0f), c.thin);
    // A sheet bends light twice, by about this [Burley 2015, fig. 15].
    Float narrower = square(max(Float(0.65f) * c.index.x - Float(0.35f), Float(0.0f)));
    p.passing = p.facets;
    p.passing.x = max(p.facets.x * narrower, Float(SMOOTH));
    p.passing.y = max(p.facets.y * narrower, Float(SMOOTH));
    Float metalness = select(c.thin, Float(0.0f), c.metalness);
    p.body = select(p.outside, (Float(1.0f) - metalness) * (Float(1.0f) - c.transmission), Float(0.0f));
    p.clear = (Float(1.0f) - metalness) * c.transmission;
    Float facets = select(c.thin, c.transmission, Float(1.0f));
    Float coat = select(without(p.outside, c.thin), Float(0.25f) * c.coat, Float(0.0f));
    Float all = facets + coat + p.body;
    p.facet_chance = facets / all;
    p.coat_chance = coat / all;
    return p;
}

// The coat's facets have longer tails than GGX's.
FN Float coat_facets(Float alpha, Float cosine) {
    Float a2 = alpha * alpha;
    return (a2 - Float(1.0f)) / (Float(PI) * natural_log(a2) * (Float(1.0f) + (a2 - Float(1.0f)) * cosine * cosine));
}

FN Float coat_alpha(IN(Closure) c) { return min(max(c.coat_roughness, Float(1.0e-3f)), Float(0.9f)); }

// The body: diffuse, brighter towards where the light comes from where it is rough; or flat, as if light went about in it.
FN Float burley_diffuse(IN(Closure) c, Float from, Float to, Float cosine) {
    Float a = grazing_share(from);
    Float b = grazing_share(to);
    Float retro = Float(2.0f) * sqrt(max(c.roughness_x * c.roughness_y, Float(0.0f))) * cosine * cosine;
    Float plain = (Float(1.0f) - Float(0.5f) * a) * (Float(1.0f) - Float(0.5f) * b) + retro * (a + b + a * b * (retro - Float(1.0f)));
    Float flat_ = (Float(1.0f) + (Float(0.5f) * retro - Float(1.0f)) * a) * (Float(1.0f) + (Float(0.5f) * retro - Float(1.0f)) * b);
    flat_ = Float(1.25f) * (flat_ * (Float(1.0f) / max(from + to, Float(1.0e-6f)) - Float(0.5f)) + Float(0.5f));
    return plain + (flat_ - plain) * c.sheen.z;
}

FN BsdfValue burley_value(IN(Closure) c, Vec3 wo, Vec3 wi, Mask mask) {
    BsdfValue v = no_value();
    BurleyParts p = burley_parts(c);
    Float eta = c.index.x;
    Float one = Float(1.0f);
    Float down = abs(wi.z);
    Mask here = both(mask, wo.z > Float(0.0f));
    Mask back = wi.z > Float(0.0f);
    // What goes through a sheet is mirrored by it first.
    Vec3 mirrored = vec3_of(wi.x, wi.y, down);
    Mask straight = either(back, c.thin);
    Vec3 m = select(straight, wo + mirrored, wo + wi * eta);
    m = m / sqrt(max(dot(m, m), Float(SMALLEST)));
    m = select(m.z < Float(0.0f), -m, m);
    Float o = dot(wo, m);
    Float i = dot(select(straight, mirrored, wi), m);
    Float cos_t = Float(0.0f);
    Float bare = fresnel(max(o, Float(0.0f)), eta, cos_t);
    Float straight_on = square((eta - one) / (eta + one));
    Spectrum tinted = grazing_fresnel(base_tint(c, one) * straight_on, o);
    Float quarter = Float(0.25f) / max(wo.z, Float(SMALLEST));
    // Facets that mirror.
    Mask mirrors = both(both(here, back), both(o > Float(0.0f), i > Float(0.0f)));
    Float metalness = select(c.thin, Float(0.0f), c.metalness);
    Spectrum clear = vec4_all((one - c.sheen.y) * bare) + tinted * c.sheen.y;
    Spectrum reflected = clear * (one - metalness) + grazing_fresnel(c.color, o) * metalness;
    reflected = select(c.thin, clear * c.transmission, select(p.outside, reflected, vec4_all(p.clear * bare)));
    Float facets = facets_density(p.facets, m) * quarter;
    Float seen = facets_seen(p.facets, wo);
    Float passes = select(p.outside, p.clear * (one - bare), one - bare);
    Float passing_chance = select(c.thin, Float(0.5f), passes);
    Spectrum value = reflected * (facets * facets_seen_both(p.facets, wo, mirrored));
    Float density = p.facet_chance * (one - passing_chance) * facets * seen;
    value = select(mirrors, value, black());
    density = select(mirrors, density, Float(0.0f));
    // Facets that let through: into a body, or through a sheet.
    Mask through = both(without(here, back), o > Float(0.0f));
    Mask into = without(both(through, i < Float(0.0f)), c.thin);
    if (some(into)) {
        Float bend = o + eta * i;
        Float bent = facets_density(p.facets, m) * abs(o * i) * eta * eta / max(wo.z * bend * bend, Float(SMALLEST));
        Float passed = p.clear * (one - bare) * bent * facets_seen_both(p.facets, wo, wi) / (eta * eta);
        value = select(into, sqrt(c.color) * passed, value);
        density = select(into, p.facet_chance * passing_chance * bent * seen, density);
    }
    Mask sheet = both(through, c.thin);
    if (some(sheet)) {
        Float narrow = facets_density(p.passing, m) * quarter;
        Float passed = c.transmission * (one - bare) * narrow * facets_seen_both(p.passing, wo, mirrored);
        Float diffuse = (one - c.transmission) * c.film_index * down * Float(1.0f / PI);
        value = select(sheet, c.color * (passed + diffuse), value);
        Float body = (one - p.facet_chance) * c.film_index * down * Float(1.0f / PI);
        density = select(sheet, p.facet_chance * Float(0.5f) * narrow * facets_seen(p.passing, wo) + body, density);
    }
    // Coat, body and sheen.
    Mask above = both(both(here, back), both(p.outside, o > Float(0.0f)));
    if (some(above)) {
        Float stays = select(c.thin, one - c.film_index, one);
        Float diffuse = burley_diffuse(c, wo.z, down, i);
        Spectrum body = c.color * (p.body * stays * diffuse * Float(1.0f / PI));
        Spectrum sheen = base_tint(c, c.sheen.x) * (c.sheen_roughness * stays * grazing_share(i));
        sheen = sheen * select(c.thin, one - c.transmission, one - metalness);
        Float alpha = coat_alpha(c);
        Float coat = coat_facets(alpha, m.z);
        Facets shadows = ggx_facets(Float(0.25f));
        Float coat_light = Float(0.25f) * c.coat * (Float(0.04f) + Float(0.96f) * grazing_share(o)) * coat;
        coat_light = select(c.thin, Float(0.0f), coat_light * facets_seen(shadows, wo) * facets_seen(shadows, wi));
        value = value + select(above, (body + sheen + vec4_all(coat_light)) * down, black());
        Float rest = max(one - p.facet_chance - p.coat_chance, Float(0.0f)) * stays * down * Float(1.0f / PI);
        Float half_way = p.coat_chance * coat * m.z * Float(0.25f) / max(o, Float(1.0e-6f));
        density = density + select(above, rest + half_way, Float(0.0f));
    }
    v.value = select(here, value, v.value);
    v.density = select(here, density, v.density);
    // What disperses goes through with its first wavelength only.
    Spectrum first_only = vec4_of(v.value.x * Float(4.0f), Float(0.0f), Float(0.0f), Float(0.0f));
    v.value = select(without(both(here, c.disperses), either(back, c.thin)), first_only, v.value);
    return v;
}

FN BsdfSample burley_sample(IN(Closure) c, Vec3 wo, Float choice, Vec2 u, Mask mask) {
    BsdfSample s = no_sample();
    BurleyParts p = burley_parts(c);
    Float eta = c.index.x;
    Mask here = both(mask, wo.z > Float(0.0f));
    Mask facets = choice < p.facet_chance;
    Mask coat = without(choice < p.facet_chance + p.coat_chance, facets);
    // The part of the number that the choice has left over.
    Float before = select(facets, Float(0.0f), select(coat, p.facet_chance, p.facet_chance + p.coat_chance));
    Float share = select(facets, p.facet_chance, select(coat, p.coat_chance, Float(1.0f) - p.facet_chance - p.coat_chance));
    Float rest = clamp01((choice - before) / max(share, Float(SMALLEST)));
    // The body, on this side or through a sheet.
    Vec3 wi = cosine_hemisphere(u);
    Mask beyond = without(without(both(c.thin, rest < c.film_index), facets), coat);
    wi.z = select(beyond, -wi.z, wi.z);
    // Facets of the base.
    Mask sheet_through = both(c.thin, rest < Float(0.5f));
    Facets drawn = p.facets;
    drawn.x = select(sheet_through, p.passing.x, drawn.x);
    drawn.y = select(sheet_through, p.passing.y, drawn.y);
    Vec3 m = facets_visible_normal(drawn, wo, u);
    if (some(coat)) {
        Float a2 = square(coat_alpha(c));
        Float z2 = (Float(1.0f) - exponential(natural_log(a2) * (Float(1.0f) - u.y))) / (Float(1.0f) - a2);
        Float ring = sqrt(clamp01(Float(1.0f) - z2));
        Vec2 around = on_circle(u.x);
        m = select(coat, vec3_of(ring * around.x, ring * around.y, sqrt(clamp01(z2))), m);
    }
    Float o = dot(wo, m);
    Vec3 mirrored = m * (Float(2.0f) * o) - wo;
    Float cos_t = Float(0.0f);
    Float bare = fresnel(max(o, Float(0.0f)), eta, cos_t);
    Float passes = select(p.outside, p.clear * (Float(1.0f) - bare), Float(1.0f) - bare);
    Mask bends = without(both(facets, rest < passes), c.thin);
    Vec3 bent = normalize(m * (o / eta - sqrt(max(squared_cos_t(o, eta), Float(0.0f)))) - wo / eta);
    Vec3 turned = vec3_of(mirrored.x, mirrored.y, -mirrored.z);
    Vec3 by_facet = select(bends, bent, select(both(sheet_through, facets), turned, mirrored));
    s.wi = select(either(facets, coat), by_facet, wi);
    s.transmits = both(here, s.wi.z < Float(0.0f));
    Mask through = either(beyond, both(facets, either(bends, sheet_through)));
    Mask right_side = either(both(through, s.wi.z < Float(0.0f)), without(s.wi.z > Float(0.0f), through));
    BsdfValue v = burley_value(c, wo, s.wi, here);
    s.weight = v.value / max(v.density, Float(SMALLEST));
    s.density = v.density;
    s.valid = both(both(here, right_side), v.density > Float(0.0f));
    return s;
}

NAMESPACE_END

#endif
