// What a surface looks like in even light, about: the share of the light that comes back towards a direction, without following any.
//
// Right for diffuse surfaces, smooth metals and whatever is clear; of layers an estimate, since what they do to each other is left out.
#ifndef LANCER_KERNEL_BSDF_VISIBLE_COLOR_H
#define LANCER_KERNEL_BSDF_VISIBLE_COLOR_H

#include "lancer/kernel/bsdf/closure.h"
#include "lancer/kernel/bsdf/fresnel.h"

NAMESPACE_BEGIN

FN Spectrum between_colors(Spectrum a, Spectrum b, Float share) { return a * (Float(1.0f) - share) + b * share; }

// `cosine`: of the angle to the normal.
FN Spectrum visible_color(IN(Closure) c, Float cosine) {
    Spectrum color = c.color;
    Mask metal = is_equal(c.kind, Int(BSDF_CONDUCTOR));
    if (some(metal)) {
        color = select(metal, c.color * fresnel_conductor_spectrum(cosine, c.index, c.extinction), color);
    }
    Mask principled = either(is_equal(c.kind, Int(BSDF_PRINCIPLED)), is_equal(c.kind, Int(BSDF_BURLEY)));
    Mask coated = either(principled, is_equal(c.kind, Int(BSDF_PLASTIC)));
    if (some(coated)) {
        Float off = Float(1.0f) - clamp01(cosine);
        Float grazing = off * off * off * off * off;
        Float cos_t = Float(0.0f);
        Spectrum border = select(is_equal(c.kind, Int(BSDF_BURLEY)), vec4_all(Float(1.0f)), c.extinction);
        Spectrum plastic = between_colors(c.color, border, fresnel(cosine, c.index.x, cos_t));
        Spectrum shiny = between_colors(c.color, vec4_all(Float(1.0f)), grazing);
        Spectrum base = between_colors(between_colors(plastic, c.color, c.transmission), shiny, c.metalness);
        Float coat = c.coat * fresnel(cosine, c.coat_index, cos_t);
        base = between_colors(base, vec4_all(Float(1.0f)), coat);
        color = select(coated, select(principled, base, plastic), color);
    }
    return select(is_equal(c.kind, Int(BSDF_NONE)), black(), color);
}

NAMESPACE_END

#endif
