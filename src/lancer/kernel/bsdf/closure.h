// What a material is at one point, for one path: everything that its BSDF needs, with textures and spectra looked up.
//
// Directions are in the shading frame: `wo` points to where the path came from and has z > 0 (the frame is turned to its side), `wi` to where it goes; z
// is along the normal. Values of a BSDF come with the cosine of wi, and densities are per solid angle of wi.
#ifndef LANCER_KERNEL_BSDF_CLOSURE_H
#define LANCER_KERNEL_BSDF_CLOSURE_H

#include "lancer/kernel/spectrum.h"

NAMESPACE_BEGIN

struct Closure {
    Int kind;             // BSDF_*
    Spectrum color;       // reflectance or tint
    Spectrum index;       // conductors: n; others: index behind the surface over the one in front
    Spectrum extinction;  // conductors: k; plastic and principled: tint of what the surface reflects
    Spectrum sheen;       // principled, as are all fields from `metalness` on: see MaterialRecord; of Burley's see there
    Float roughness_x;
    Float roughness_y;
    Float metalness;
    Float transmission;
    Float coat;
    Float coat_roughness;
    Float coat_index;
    Vec3 coat_normal;
    Float sheen_roughness;
    Spectrum film;  // thickness over wavelength, 0: none
    Float film_index;
    Mask disperses;  // `index` differs from wavelength to wavelength: what is refracted goes on with the first only
    Mask beckmann;
    Mask separate;  // facets hide one another towards either direction by itself
    Mask once;      // light that meets several facets is lost
    Mask saturates;
    Mask thin;
};

FN Mask all_or_none(bool yes) { return Float(yes ? 1.0f : 0.0f) > Float(0.5f); }

FN Mask nowhere() { return Float(1.0f) < Float(0.0f); }

FN Closure no_closure() {
    Closure c;
    c.kind = Int(BSDF_NONE);
    c.color = black();
    c.index = vec4_all(Float(1.0f));
    c.extinction = black();
    c.sheen = black();
    c.roughness_x = Float(0.0f);
    c.roughness_y = Float(0.0f);
    c.metalness = Float(0.0f);
    c.transmission = Float(0.0f);
    c.coat = Float(0.0f);
    c.coat_roughness = Float(0.0f);
    c.coat_index = Float(1.5f);
    c.coat_normal = vec3_of(Float(0.0f), Float(0.0f), Float(1.0f));
    c.sheen_roughness = Float(0.0f);
    c.film = black();
    c.film_index = Float(1.0f);
    c.disperses = nowhere();
    c.beckmann = nowhere();
    c.separate = nowhere();
    c.once = nowhere();
    c.saturates = nowhere();
    c.thin = nowhere();
    return c;
}

FN Mask select_mask(Mask mask, Mask a, Mask b) { return either(both(mask, a), without(b, mask)); }

FN Closure select_closure(Mask mask, IN(Closure) a, IN(Closure) b) {
    Closure c;
    c.kind = select(mask, a.kind, b.kind);
    c.color = select(mask, a.color, b.color);
    c.index = select(mask, a.index, b.index);
    c.extinction = select(mask, a.extinction, b.extinction);
    c.sheen = select(mask, a.sheen, b.sheen);
    c.roughness_x = select(mask, a.roughness_x, b.roughness_x);
    c.roughness_y = select(mask, a.roughness_y, b.roughness_y);
    c.metalness = select(mask, a.metalness, b.metalness);
    c.transmission = select(mask, a.transmission, b.transmission);
    c.coat = select(mask, a.coat, b.coat);
    c.coat_roughness = select(mask, a.coat_roughness, b.coat_roughness);
    c.coat_index = select(mask, a.coat_index, b.coat_index);
    c.coat_normal = select(mask, a.coat_normal, b.coat_normal);
    c.sheen_roughness = select(mask, a.sheen_roughness, b.sheen_roughness);
    c.film = select(mask, a.film, b.film);
    c.film_index = select(mask, a.film_index, b.film_index);
    c.disperses = select_mask(mask, a.disperses, b.disperses);
    c.beckmann = select_mask(mask, a.beckmann, b.beckmann);
    c.separate = select_mask(mask, a.separate, b.separate);
    c.once = select_mask(mask, a.once, b.once);
    c.saturates = select_mask(mask, a.saturates, b.saturates);
    c.thin = select_mask(mask, a.thin, b.thin);
    return c;
}

struct BsdfValue {
    Spectrum value;  // f |cos wi|
    Float density;
};

struct BsdfSample {
    Vec3 wi;
    Spectrum weight;  // f |cos wi| / density, or what a mirror direction passes on
    Float density;    // 0 for a direction that can only be met by chance (`discrete`)
    Mask discrete;    // a mirror or a smooth border
    Mask transmits;
    Mask valid;  // false: the light is swallowed
};

FN BsdfValue no_value() {
    BsdfValue v;
    v.value = black();
    v.density = Float(0.0f);
    return v;
}

FN BsdfSample no_sample() {
    BsdfSample s;
    s.wi = vec3_of(Float(0.0f), Float(0.0f), Float(1.0f));
    s.weight = black();
    s.density = Float(0.0f);
    s.discrete = Float(1.0f) < Float(0.0f);
    s.transmits = s.discrete;
    s.valid = s.discrete;
    return s;
}

FN BsdfValue select_value(Mask mask, IN(BsdfValue) a, IN(BsdfValue) b) {
    BsdfValue v;
    v.value = select(mask, a.value, b.value);
    v.density = select(mask, a.density, b.density);
    return v;
}

FN BsdfSample select_sample(Mask mask, IN(BsdfSample) a, IN(BsdfSample) b) {
    BsdfSample s;
    s.wi = select(mask, a.wi, b.wi);
    s.weight = select(mask, a.weight, b.weight);
    s.density = select(mask, a.density, b.density);
    s.discrete = select_mask(mask, a.discrete, b.discrete);
    s.transmits = select_mask(mask, a.transmits, b.transmits);
    s.valid = select_mask(mask, a.valid, b.valid);
    return s;
}

NAMESPACE_END

#endif
