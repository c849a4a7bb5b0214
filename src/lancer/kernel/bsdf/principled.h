// The layered surface of glTF's metallic-roughness materials and their extensions: a sheen, over a clear coat, over a base that is a metal, a
// diffuse body under a clear border, or a clear body; or a mixture of the three. Where glTF does not say, OpenPBR's layers are meant.
//
// A layer takes from what is under it as much as it reflects of light from either direction, whichever reflects more: so both ways are the same,
// and no light is made.
#ifndef LANCER_KERNEL_BSDF_PRINCIPLED_H
#define LANCER_KERNEL_BSDF_PRINCIPLED_H

#include "lancer/kernel/bsdf/conductor.h"
#include "lancer/kernel/bsdf/dielectric.h"
#include "lancer/kernel/bsdf/film.h"
#include "lancer/kernel/bsdf/plastic.h"
#include "lancer/kernel/bsdf/sheen.h"
#include "lancer/kernel/frame.h"

NAMESPACE_BEGIN

// ---- Metal by the colour that it has from above [Schlick 1994], perhaps under a thin film. --------------------------------------------------

FN Spectrum colored_metal(IN(Closure) c, Float cosine) {
    Float off = Float(1.0f) - clamp01(cosine);
    Float off_2 = off * off;
    Spectrum share = c.color + (vec4_all(Float(1.0f)) - c.color) * (off_2 * off_2 * off);
    Mask film = has_film(c);
    if (some(film)) {
        share = select(film, film_over_metal(c, cosine), share);
    }
    return share;
}

FN BsdfValue metal_value(IN(WorldRecord) world, IN(Closure) c, Vec3 wo, Vec3 wi, Mask mask) {
    BsdfValue v = no_value();
    Mask good = both(both(mask, is_rough(c)), both(wo.z > Float(0.0f), wi.z > Float(0.0f)));
    if (some(good)) {
        Facets f = facets_of(c);
        Vec3 m = normalize(wo + wi);
        Float facets = facets_density(f, m) * Float(0.25f) / max(wo.z, Float(SMALLEST));
        Spectrum once = colored_metal(c, dot(wo, m)) * (facets * facets_seen_both(f, wo, wi));
        Float lost_out = facet_loss(world, f, wo, good);
        Float lost_in = facet_loss(world, f, wi, good);
        Float lost = mean_facet_loss(world, f, good);
        Float diffuse = wi.z * Float(1.0f / PI);
        Spectrum tint = several_times(c.color + (vec4_all(Float(1.0f)) - c.color) * Float(1.0f / 21.0f), lost);
        v.value = select(good, once + tint * (lost_out * lost_in / max(lost, Float(1.0e-6f)) * diffuse), v.value);
        v.density = select(good, between(facets * facets_seen(f, wo), diffuse, lost_out), v.density);
    }
    return v;
}

FN BsdfSample metal_sample(IN(WorldRecord) world, IN(Closure) c, Vec3 wo, Float choice, Vec2 u, Mask mask) {
    BsdfSample s = no_sample();
    Mask rough = both(mask, is_rough(c));
    s.discrete = without(both(mask, wo.z > Float(0.0f)), rough);
    s.wi = vec3_of(-wo.x, -wo.y, wo.z);
    s.weight = colored_metal(c, wo.z);
    s.valid = both(mask, wo.z > Float(0.0f));
    if (some(rough)) {
        Facets f = facets_of(c);
        Vec3 m = facets_visible_normal(f, wo, u);
        Vec3 wi = m * (Float(2.0f) * dot(wo, m)) - wo;
        wi = select(choice < facet_loss(world, f, wo, rough), cosine_hemisphere(u), wi);
        s.wi = select(rough, wi, s.wi);
        s.valid = both(s.valid, s.wi.z > Float(0.0f));
    }
    return s;
}

// ---- A clear sheet without inside: light goes straight through, or is spread by facets as if mirrored and turned over. ----------------------

FN BsdfValue sheet_value(IN(WorldRecord) world, IN(Closure) c, Vec3 wo, Vec3 wi, Mask mask) {
    BsdfValue v = no_value();
    Mask good = both(both(mask, is_rough(c)), wo.z > Float(0.0f));
    if (some(good)) {
        Facets f = facets_of(c);
        Mask reflects = wi.z > Float(0.0f);
        Vec3 turned = vec3_of(wi.x, wi.y, abs(wi.z));
        Vec3 m = normalize(wo + turned);
        Spectrum once = border_share(c, dot(wo, m));
        Spectrum share = once * Float(2.0f) / (vec4_all(Float(1.0f)) + once);
        Float chance = mean(share);
        Float facets = facets_density(f, m) * Float(0.25f) / max(wo.z, Float(SMALLEST));
        Spectrum part = select(reflects, share, vec4_all(Float(1.0f)) - share);
        Float lost_out = facet_loss(world, f, wo, good);
        Float lost_in = facet_loss(world, f, turned, good);
        Float lost = max(mean_facet_loss(world, f, good), Float(1.0e-6f));
        Float half_ = turned.z * Float(0.5f / PI);
        v.value = select(good, part * (facets * facets_seen_both(f, wo, turned)) + vec4_all(lost_out * lost_in / lost * half_), v.value);
        Float density = facets * facets_seen(f, wo) * select(reflects, chance, Float(1.0f) - chance);
        v.density = select(good, between(density, half_, lost_out), v.density);
    }
    return v;
}

FN BsdfSample sheet_sample(IN(WorldRecord) world, IN(Closure) c, Vec3 wo, Float choice, Vec2 u, Mask mask) {
    BsdfSample s = no_sample();
    Mask rough = both(mask, is_rough(c));
    Vec3 m = vec3_of(Float(0.0f), Float(0.0f), Float(1.0f));
    Float rest = choice;
    Mask several = nowhere();
    if (some(rough)) {
        Facets f = facets_of(c);
        m = select(rough, facets_visible_normal(f, wo, u), m);
        Float lost = facet_loss(world, f, wo, rough);
        several = both(rough, choice < lost);
        Float within = select(several, choice / max(lost, Float(SMALLEST)), (choice - lost) / max(Float(1.0f) - lost, Float(SMALLEST)));
        rest = select(rough, within, rest);
    }
    Float o = dot(wo, m);
    Spectrum once = border_share(c, o);
    Spectrum share = once * Float(2.0f) / (vec4_all(Float(1.0f)) + once);
    Float chance = mean(share);
    Mask reflects = rest < select(several, Float(0.5f), chance);
    Vec3 mirrored = select(several, cosine_hemisphere(u), m * (Float(2.0f) * o) - wo);
    s.valid = both(both(mask, wo.z > Float(0.0f)), both(o > Float(0.0f), mirrored.z > Float(0.0f)));
    s.wi = vec3_of(mirrored.x, mirrored.y, select(reflects, mirrored.z, -mirrored.z));
    s.transmits = without(s.valid, reflects);
    s.discrete = without(s.valid, rough);
    // Straight through a smooth sheet, not turned over.
    s.wi = select(both(s.discrete, s.transmits), -wo, s.wi);
    Spectrum passed = (vec4_all(Float(1.0f)) - share) / max(Float(1.0f) - chance, Float(SMALLEST));
    s.weight = select(reflects, share / max(chance, Float(SMALLEST)), passed);
    return s;
}

// ---- The parts, and the chances to draw from each. ------------------------------------------------------------------------------------------

struct PrincipledParts {
    Coat coat;
    Mask outside;     // of the body: the layers are there
    Float sheen_out;  // what the sheen, white, reflects of light along wo; at most 1
    Float coat_out;
    Float sheen_chance;
    Float coat_chance;
    Float metal_chance;
    Float clear_chance;  // the rest: plastic
};

// A direction as the coat has it: z is along its own normal.
FN Vec3 towards_coat(IN(Closure) c, Vec3 w) {
    Vec3 local = w;
    Mask bent = c.coat_normal.z < Float(1.0f);
    if (some(bent)) {
        local = select(bent, to_local(frame_around(c.coat_normal), w), local);
    }
    return local;
}

FN Vec3 from_coat(IN(Closure) c, Vec3 w) {
    Vec3 outside = w;
    Mask bent = c.coat_normal.z < Float(1.0f);
    if (some(bent)) {
        outside = select(bent, to_world(frame_around(c.coat_normal), w), outside);
    }
    return outside;
}

FN PrincipledParts principled_parts(IN(WorldRecord) world, IN(Closure) c, Vec3 wo, Mask mask) {
    PrincipledParts p;
    p.coat = coat_of(c.coat_index, ggx_facets(c.coat_roughness), c.coat_roughness >= Float(SMOOTH));
    p.outside = either(c.index.x >= Float(1.0f), c.thin);
    p.sheen_out = Float(0.0f);
    p.coat_out = Float(0.0f);
    Mask sheen = both(mask, largest(c.sheen) > Float(0.0f));
    if (some(sheen)) {
        p.sheen_out = select(sheen, sheen_albedo(world, c.sheen_roughness, wo.z, sheen), p.sheen_out);
    }
    Mask coated = both(mask, c.coat > Float(0.0f));
    if (some(coated)) {
        p.coat_out = select(coated, coat_albedo(world, p.coat, towards_coat(c, wo), coated), p.coat_out);
    }
    Float under_sheen = Float(1.0f) - largest(c.sheen) * min(p.sheen_out, Float(1.0f));
    Float coat = c.coat * p.coat_out * under_sheen;
    p.sheen_chance = select(p.outside, Float(1.0f) - under_sheen, Float(0.0f));
    p.coat_chance = select(p.outside, coat, Float(0.0f));
    Float base = Float(1.0f) - p.sheen_chance - p.coat_chance;
    p.metal_chance = base * c.metalness;
    p.clear_chance = base * (Float(1.0f) - c.metalness) * c.transmission;
    return p;
}

FN Float plastic_share(IN(Closure) c) { return (Float(1.0f) - c.metalness) * (Float(1.0f) - c.transmission); }

FN Spectrum clear_tint(IN(Closure) c, Mask reflects) { return select(reflects, c.extinction, c.color); }

FN Closure untinted(IN(Closure) c) {
    Closure clear = c;
    clear.color = vec4_all(Float(1.0f));
    return clear;
}

// What the sheen lets through along wo and wi, both ways alike; and what the coat does.
FN Vec2 principled_layers(IN(WorldRecord) world, IN(Closure) c, IN(PrincipledParts) p, Vec3 wi, Mask mask) {
    Float sheen_left = Float(1.0f);
    Float coat_left = Float(1.0f);
    Mask sheen = both(mask, largest(c.sheen) > Float(0.0f));
    if (some(sheen)) {
        Float most = min(max(p.sheen_out, sheen_albedo(world, c.sheen_roughness, abs(wi.z), sheen)), Float(1.0f));
        sheen_left = select(sheen, Float(1.0f) - largest(c.sheen) * most, sheen_left);
    }
    Mask coated = both(mask, c.coat > Float(0.0f));
    if (some(coated)) {
        Float most = max(p.coat_out, coat_albedo(world, p.coat, towards_coat(c, wi), coated));
        coat_left = select(coated, Float(1.0f) - c.coat * most, coat_left);
    }
    return vec2_of(sheen_left, coat_left);
}

FN BsdfValue principled_parts_value(IN(WorldRecord) world, IN(Closure) c, IN(PrincipledParts) p, Vec3 wo, Vec3 wi, Mask mask) {
    Mask reflects = wi.z > Float(0.0f);
    Vec2 layers = principled_layers(world, c, p, wi, mask);
    BsdfValue v = no_value();
    Mask metal = both(mask, c.metalness > Float(0.0f));
    if (some(metal)) {
        BsdfValue m = metal_value(world, c, wo, wi, metal);
        v.value = v.value + m.value * c.metalness;
        v.density = v.density + m.density * p.metal_chance;
    }
    Mask clear = both(mask, both(c.transmission > Float(0.0f), c.metalness < Float(1.0f)));
    if (some(clear)) {
        BsdfValue m = dielectric_value(world, untinted(c), wo, wi, without(clear, c.thin));
        Mask sheet = both(clear, c.thin);
        if (some(sheet)) {
            m = select_value(sheet, sheet_value(world, c, wo, wi, sheet), m);
        }
        v.value = v.value + m.value * clear_tint(c, reflects) * ((Float(1.0f) - c.metalness) * c.transmission);
        v.density = v.density + m.density * p.clear_chance;
    }
    Mask plastic = both(mask, plastic_share(c) > Float(0.0f));
    if (some(plastic)) {
        BsdfValue m = plastic_value(world, c, wo, wi, plastic);
        Float chance = Float(1.0f) - p.sheen_chance - p.coat_chance - p.metal_chance - p.clear_chance;
        v.value = v.value + m.value * plastic_share(c);
        v.density = v.density + m.density * chance;
    }
    v.value = v.value * (layers.x * layers.y);
    Mask above = both(both(mask, p.outside), both(reflects, wo.z > Float(0.0f)));
    Mask coated = both(above, c.coat > Float(0.0f));
    if (some(coated)) {
        Vec3 o = towards_coat(c, wo);
        Vec3 i = towards_coat(c, wi);
        coated = both(coated, both(o.z > Float(0.0f), i.z > Float(0.0f)));
        Vec2 m = coat_value(p.coat, o, i);
        v.value = select(coated, v.value + vec4_all(m.x * c.coat * layers.x), v.value);
        v.density = select(coated, v.density + m.y * p.coat_chance, v.density);
    }
    Mask sheen = both(above, largest(c.sheen) > Float(0.0f));
    if (some(sheen)) {
        // Where the sheen alone would give back more than arrives it is dimmed, both ways alike.
        Float most = max(max(p.sheen_out, sheen_albedo(world, c.sheen_roughness, wi.z, sheen)), Float(1.0f));
        Float fibres = sheen_value(wo, wi, c.sheen_roughness) / most;
        v.value = select(sheen, v.value + c.sheen * fibres, v.value);
        v.density = select(sheen, v.density + p.sheen_chance * wi.z * Float(1.0f / PI), v.density);
    }
    return v;
}

FN BsdfValue principled_value(IN(WorldRecord) world, IN(Closure) c, Vec3 wo, Vec3 wi, Mask mask) {
    PrincipledParts p = principled_parts(world, c, wo, mask);
    return principled_parts_value(world, c, p, wo, wi, mask);
}

FN BsdfSample principled_sample(IN(WorldRecord) world, IN(Closure) c, Vec3 wo, Float choice, Vec2 u, Mask mask) {
    PrincipledParts p = principled_parts(world, c, wo, mask);
    Mask good = both(mask, wo.z > Float(0.0f));
    BsdfSample s = no_sample();
    Float chance = Float(1.0f);  // of the part that is drawn from
    Float share = Float(1.0f);   // of that part in the whole, but for the layers
    Float before = p.sheen_chance;
    Mask sheen = both(good, choice < before);
    s.wi = select(sheen, cosine_hemisphere(u), s.wi);
    s.valid = sheen;
    Mask left_over = without(good, sheen);

    Mask coated = both(left_over, choice < before + p.coat_chance);
    if (some(coated)) {
        Vec3 o = towards_coat(c, wo);
        Vec3 m = select(p.coat.rough, facets_visible_normal(p.coat.facets, o, u), vec3_of(Float(0.0f), Float(0.0f), Float(1.0f)));
        s.wi = select(coated, from_coat(c, m * (Float(2.0f) * dot(o, m)) - o), s.wi);
        s.weight = select(coated, vec4_all(p.coat_out), s.weight);
        s.discrete = without(coated, p.coat.rough);
        s.valid = either(s.valid, both(coated, s.wi.z > Float(0.0f)));
        chance = select(coated, p.coat_chance, chance);
        share = select(coated, c.coat, share);
    }
    before = before + p.coat_chance;
    left_over = without(left_over, coated);

    Mask metal = both(left_over, choice < before + p.metal_chance);
    if (some(metal)) {
        Float within = (choice - before) / max(p.metal_chance, Float(SMALLEST));
        s = select_sample(metal, metal_sample(world, c, wo, within, u, metal), s);
        chance = select(metal, p.metal_chance, chance);
        share = select(metal, c.metalness, share);
    }
    before = before + p.metal_chance;
    left_over = without(left_over, metal);

    Mask clear = both(left_over, choice < before + p.clear_chance);
    if (some(clear)) {
        Float within = min((choice - before) / max(p.clear_chance, Float(SMALLEST)), Float(0.99999994f));
        BsdfSample m = dielectric_sample(world, untinted(c), wo, within, u, without(clear, c.thin));
        Mask sheet = both(clear, c.thin);
        if (some(sheet)) {
            m = select_sample(sheet, sheet_sample(world, c, wo, within, u, sheet), m);
        }
        m.weight = m.weight * select(m.transmits, c.color, c.extinction);
        s = select_sample(clear, m, s);
        chance = select(clear, p.clear_chance, chance);
        share = select(clear, (Float(1.0f) - c.metalness) * c.transmission, share);
    }
    before = before + p.clear_chance;
    left_over = without(left_over, clear);

    if (some(left_over)) {
        Float rest = max(Float(1.0f) - before, Float(SMALLEST));
        Float within = min((choice - before) / rest, Float(0.99999994f));
        s = select_sample(left_over, plastic_sample(world, c, wo, within, u, left_over), s);
        chance = select(left_over, rest, chance);
        share = select(left_over, plastic_share(c), share);
    }

    BsdfValue v = principled_parts_value(world, c, p, wo, s.wi, good);
    Vec2 layers = principled_layers(world, c, p, s.wi, good);
    Spectrum alone = s.weight * (share * layers.x * select(coated, Float(1.0f), layers.y) / max(chance, Float(SMALLEST)));
    s.weight = select(s.discrete, alone, v.value / max(v.density, Float(SMALLEST)));
    s.density = select(s.discrete, Float(0.0f), v.density);
    s.valid = both(s.valid, either(s.discrete, v.density > Float(0.0f)));
    return s;
}

NAMESPACE_END

#endif
