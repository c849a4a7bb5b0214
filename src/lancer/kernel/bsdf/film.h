// The colours of a film as thin as light's wavelength: what both its borders reflect adds up as waves do [Belcour and Barla 2017, before their
// averaging over colours: a path has wavelengths].
#ifndef LANCER_KERNEL_BSDF_FILM_H
#define LANCER_KERNEL_BSDF_FILM_H

#include "lancer/kernel/bsdf/closure.h"
#include "lancer/kernel/bsdf/fresnel.h"

NAMESPACE_BEGIN

// Of a film of `film` times the wavelength over a body, all indices relative to the outside; Airy's sum of all ways to and fro.
FN Float film_reflectance(Float cosine, Float film, Float film_index, Float index) {
    Float sine_2 = Float(1.0f) - cosine * cosine;
    Float cos_film = sqrt(max(Float(1.0f) - sine_2 / (film_index * film_index), Float(0.0f)));
    Float cos_body = sqrt(max(Float(1.0f) - sine_2 / (index * index), Float(0.0f)));
    // Amplitudes, across the plane of the ray and within.
    Float across_1 = (cosine - film_index * cos_film) / (cosine + film_index * cos_film);
    Float within_1 = (film_index * cosine - cos_film) / (film_index * cosine + cos_film);
    Float across_2 = (film_index * cos_film - index * cos_body) / (film_index * cos_film + index * cos_body);
    Float within_2 = (index * cos_film - film_index * cos_body) / (index * cos_film + film_index * cos_body);
    Float turns = min(Float(2.0f) * film * film_index * cos_film, Float(1000.0f));  // to and fro, in wavelengths
    Float wave = on_circle(turns).x;
    Float a = Float(2.0f) * across_1 * across_2 * wave;
    Float b = Float(2.0f) * within_1 * within_2 * wave;
    Float across_1_2 = across_1 * across_1;
    Float across_2_2 = across_2 * across_2;
    Float within_1_2 = within_1 * within_1;
    Float within_2_2 = within_2 * within_2;
    Float across = (across_1_2 + across_2_2 + a) / (Float(1.0f) + across_1_2 * across_2_2 + a);
    Float within = (within_1_2 + within_2_2 + b) / (Float(1.0f) + within_1_2 * within_2_2 + b);
    return clamp01((across + within) * Float(0.5f));
}

// A clear index that reflects as much from above.
FN Float index_that_reflects(Float share) {
    Float root = sqrt(min(max(share, Float(0.0f)), Float(0.98f)));
    return (Float(1.0f) + root) / (Float(1.0f) - root);
}

// Of a clear border with a film on its outer side, seen from either; `eta`: index behind over index in front. A border that swallows nothing reflects
// the same share of a ray whichever way it goes.
FN Float film_over_border(Float cosine, Float film, Float film_index, Float eta) {
    Float cos_t_2 = squared_cos_t(cosine, eta);
    Mask within = eta < Float(1.0f);
    Float outer = select(within, sqrt(max(cos_t_2, Float(0.0f))), cosine);
    Float share = film_reflectance(max(outer, Float(1.0e-3f)), film, film_index, select(within, Float(1.0f) / eta, eta));
    return select(cos_t_2 <= Float(0.0f), Float(1.0f), share);
}

FN Spectrum film_over_border_spectrum(IN(Closure) c, Float cosine) {
    return vec4_of(film_over_border(cosine, c.film.x, c.film_index, c.index.x), film_over_border(cosine, c.film.y, c.film_index, c.index.y),
                   film_over_border(cosine, c.film.z, c.film_index, c.index.z),
                   film_over_border(cosine, c.film.w, c.film_index, c.index.w));
}

FN Mask has_film(IN(Closure) c) { return largest(c.film) > Float(0.0f); }

// What a clear border reflects, perhaps under a film.
FN Spectrum border_share(IN(Closure) c, Float cosine) {
    Spectrum share = fresnel_spectrum(cosine, c.index);
    Mask film = has_film(c);
    if (some(film)) {
        share = select(film, film_over_border_spectrum(c, cosine), share);
    }
    return share;
}

FN Spectrum film_over_metal(IN(Closure) c, Float cosine) {
    Float at = max(cosine, Float(1.0e-3f));
    return vec4_of(film_reflectance(at, c.film.x, c.film_index, index_that_reflects(c.color.x)),
                   film_reflectance(at, c.film.y, c.film_index, index_that_reflects(c.color.y)),
                   film_reflectance(at, c.film.z, c.film_index, index_that_reflects(c.color.z)),
                   film_reflectance(at, c.film.w, c.film_index, index_that_reflects(c.color.w)));
}

NAMESPACE_END

#endif
