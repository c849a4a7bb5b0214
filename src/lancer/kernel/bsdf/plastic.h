// Plastic: a diffuse body under a clear border, smooth or of facets. What the border does not reflect, and light that several facets have met,
// goes into the body and comes out again: nothing is lost, and both ways are the same [Kulla and Conty 2017]. Or what several facets have met is
// lost: then only what one facet lets through reaches the body, and leaves it.
#ifndef LANCER_KERNEL_BSDF_PLASTIC_H
#define LANCER_KERNEL_BSDF_PLASTIC_H

#include "lancer/kernel/bsdf/albedo.h"
#include "lancer/kernel/bsdf/film.h"
#include "lancer/kernel/warp.h"

NAMESPACE_BEGIN

// A clear border of facets, or a smooth one, seen from outside.
struct Coat {
    Facets facets;
    Mask rough;
    Float eta;  // at least 1
    AlbedoPlace place;
};

FN Coat coat_of(Float eta, IN(Facets) facets, Mask rough) {
    Coat coat;
    coat.facets = facets;
    coat.rough = rough;
    coat.eta = max(eta, Float(1.0f) / eta);
    Float roughness = select(coat.rough, sqrt(mean_square_roughness(coat.facets)), Float(0.0f));
    coat.place = coat_place(coat.eta, roughness, facets);
    return coat;
}

// What it reflects of light from a direction.
FN Float coat_albedo(IN(WorldRecord) world, IN(Coat) coat, Vec3 w, Mask mask) {
    Float cos_t = Float(0.0f);
    Float share = fresnel(abs(w.z), coat.eta, cos_t);
    Mask rough = both(mask, coat.rough);
    if (some(rough)) {
        share = select(rough, albedo_at(world, coat.place, cosine_of_round_facets(coat.facets, w), rough), share);
    }
    return share;
}

// f cos of its facets, and the density of drawing from them; 0 where it is smooth.
FN Vec2 coat_value(IN(Coat) coat, Vec3 wo, Vec3 wi) {
    Vec3 m = normalize(wo + wi);
    Float cosine = dot(wo, m);
    Float cos_t = Float(0.0f);
    Float facets = facets_density(coat.facets, m) * Float(0.25f) / max(wo.z, Float(SMALLEST));
    Float value = fresnel(max(cosine, Float(0.0f)), coat.eta, cos_t) * facets * facets_seen_both(coat.facets, wo, wi);
    Mask good = both(both(coat.rough, cosine > Float(0.0f)), both(wo.z > Float(0.0f), wi.z > Float(0.0f)));
    return vec2_of(select(good, value, Float(0.0f)), select(good, facets * facets_seen(coat.facets, wo), Float(0.0f)));
}

// By how much a film on the border changes what it reflects.
FN Spectrum film_tint(IN(Closure) c, IN(Coat) coat, Float cosine) {
    Spectrum tint = vec4_all(Float(1.0f));
    Mask film = has_film(c);
    if (some(film)) {
        Float cos_t = Float(0.0f);
        Float bare = max(fresnel(abs(cosine), coat.eta, cos_t), Float(1.0e-4f));
        Spectrum with_film = vec4_of(film_over_border(abs(cosine), c.film.x, c.film_index, coat.eta),
                                     film_over_border(abs(cosine), c.film.y, c.film_index, coat.eta),
                                     film_over_border(abs(cosine), c.film.z, c.film_index, coat.eta),
                                     film_over_border(abs(cosine), c.film.w, c.film_index, coat.eta));
        tint = select(film, with_film / bare, tint);
    }
    return tint;
}

// Of light that meets the surface, the chance to draw from the border's reflection.
FN Float plastic_chance(IN(Closure) c, Float reflected) {
    Float border = reflected * max(largest(c.extinction), Float(1.0e-3f));
    Float body = (Float(1.0f) - reflected) * max(largest(c.color), Float(1.0e-3f));
    return border / max(border + body, Float(SMALLEST));
}

FN BsdfValue plastic_value(IN(WorldRecord) world, IN(Closure) c, Vec3 wo, Vec3 wi, Mask mask) {
    BsdfValue v = no_value();
    Mask good = both(mask, both(wo.z > Float(0.0f), wi.z > Float(0.0f)));
    if (some(good)) {
        Coat coat = coat_of(c.index.x, facets_of(c), is_rough(c));
        Float reflected_out = coat_albedo(world, coat, wo, good);
        Float reflected_in = coat_albedo(world, coat, wi, good);
        Float passes = Float(1.0f) - mean_albedo(world, coat.place, good);
        Spectrum body = c.color / passes;
        Float passed_out = Float(1.0f) - reflected_out;
        Float passed_in = Float(1.0f) - reflected_in;
        // Of light within, all but this is sent back by the border each time that it comes there.
        Float leaves = passes / (coat.eta * coat.eta);
        if (some(c.once)) {
            Float roughness = select(coat.rough, sqrt(mean_square_roughness(coat.facets)), Float(0.0f));
            AlbedoPlace front = border_place(coat.eta, roughness, coat.facets);
            AlbedoPlace behind = border_place(Float(1.0f) / coat.eta, roughness, coat.facets);
            passed_out = passed_out - select(c.once, albedo_at(world, front, cosine_of_round_facets(coat.facets, wo), good), Float(0.0f));
            passed_in = passed_in - select(c.once, albedo_at(world, front, cosine_of_round_facets(coat.facets, wi), good), Float(0.0f));
            // Light goes through the border as easily either way; what stays within is mirrored, and not lost.
            Float through = (passes - mean_albedo(world, front, good)) / (coat.eta * coat.eta);
            leaves = select(c.once, through + mean_albedo(world, behind, good), leaves);
            body = select(c.once, c.color / (coat.eta * coat.eta * leaves), body);
        }
        if (some(c.saturates)) {
            Spectrum several = c.color / (coat.eta * coat.eta) / (vec4_all(Float(1.0f)) - c.color * (Float(1.0f) - leaves));
            body = select(c.saturates, several, body);
        }
        Float diffuse = wi.z * Float(1.0f / PI);
        Spectrum passed = vec4_all(passed_out * passed_in);
        Mask film = has_film(c);
        if (some(film)) {
            // The table knows no films: as other layers do, it takes what it reflects of either direction, whichever is more.
            Spectrum most = max(film_tint(c, coat, wo.z) * reflected_out, film_tint(c, coat, wi.z) * reflected_in);
            Spectrum left_over = vec4_all(Float(1.0f)) - min(most, vec4_all(Float(1.0f)));
            passed = select(film, left_over * passes, passed);
        }
        Spectrum value = body * passed * diffuse;
        Float chance = plastic_chance(c, reflected_out);
        Float density = (Float(1.0f) - chance) * diffuse;
        if (some(coat.rough)) {
            Vec2 facets = coat_value(coat, wo, wi);
            Spectrum tint = c.extinction * film_tint(c, coat, dot(wo, normalize(wo + wi)));
            value = value + tint * facets.x;
            density = density + chance * facets.y;
        }
        v.value = select(good, value, v.value);
        v.density = select(good, density, v.density);
    }
    return v;
}

FN BsdfSample plastic_sample(IN(WorldRecord) world, IN(Closure) c, Vec3 wo, Float choice, Vec2 u, Mask mask) {
    BsdfSample s = no_sample();
    Mask good = both(mask, wo.z > Float(0.0f));
    Coat coat = coat_of(c.index.x, facets_of(c), is_rough(c));
    Float reflected = coat_albedo(world, coat, wo, good);
    Float chance = plastic_chance(c, reflected);
    Mask border = choice < chance;
    s.wi = cosine_hemisphere(u);
    Mask rough = both(good, both(border, coat.rough));
    if (some(rough)) {
        Vec3 m = facets_visible_normal(coat.facets, wo, u);
        s.wi = select(rough, m * (Float(2.0f) * dot(wo, m)) - wo, s.wi);
    }
    s.discrete = without(both(good, border), coat.rough);
    s.wi = select(s.discrete, vec3_of(-wo.x, -wo.y, wo.z), s.wi);
    BsdfValue v = plastic_value(world, c, wo, s.wi, good);
    Spectrum mirrored = c.extinction * film_tint(c, coat, wo.z) * (reflected / max(chance, Float(SMALLEST)));
    s.weight = select(s.discrete, mirrored, v.value / max(v.density, Float(SMALLEST)));
    s.density = select(s.discrete, Float(0.0f), v.density);
    s.valid = either(s.discrete, both(both(good, s.wi.z > Float(0.0f)), v.density > Float(0.0f)));
    return s;
}

NAMESPACE_END

#endif
