// The sheen of cloth: fibres that stand off the surface, brightest seen from the side [Estevez and Kulla 2017].
#ifndef LANCER_KERNEL_BSDF_SHEEN_H
#define LANCER_KERNEL_BSDF_SHEEN_H

#include "lancer/kernel/bsdf/albedo.h"

NAMESPACE_BEGIN

const float SMOOTHEST_SHEEN = 0.07f;  // below this roughness its peak is too narrow for floats

FN Float sheen_curve(Float x, Float rest) {
    Float a = between(Float(21.5473f), Float(25.3245f), rest);
    Float b = between(Float(3.82987f), Float(3.32435f), rest);
    Float c = between(Float(0.19823f), Float(0.16801f), rest);
    Float d = between(Float(-1.97760f), Float(-1.27393f), rest);
    Float e = between(Float(-4.32054f), Float(-4.85967f), rest);
    return a / (Float(1.0f) + b * power(x, c)) + d * x + e;
}

FN Float sheen_lambda(Float cosine, Float alpha) {
    Float rest = square(Float(1.0f) - alpha);
    Mask steep = cosine < Float(0.5f);
    Float x = select(steep, cosine, Float(1.0f) - cosine);
    Float l = sheen_curve(x, rest);
    return exponential(select(steep, l, Float(2.0f) * sheen_curve(Float(0.5f), rest) - l));
}

// f cos wi of a white sheen; both directions above the surface.
FN Float sheen_value(Vec3 wo, Vec3 wi, Float roughness) {
    Float r = max(roughness, Float(SMOOTHEST_SHEEN));
    Float alpha = r * r;
    Vec3 m = normalize(wo + wi);
    Float sine_2 = max(Float(1.0f) - m.z * m.z, Float(0.0f));
    Float power_of_sine = Float(1.0f) / alpha;
    Float facets = (Float(2.0f) + power_of_sine) * power(sine_2, power_of_sine * Float(0.5f)) * Float(0.5f / PI);
    Float seen = Float(1.0f) / (Float(1.0f) + sheen_lambda(wo.z, alpha) + sheen_lambda(wi.z, alpha));
    return facets * seen * Float(0.25f) / max(wo.z, Float(1.0e-4f));
}

// What a white sheen reflects. More than arrives where the roughness is small and the sight is slanted: divide the value by it there.
FN Float sheen_albedo(IN(WorldRecord) world, Float roughness, Float cosine, Mask mask) {
    TablePlace rough = place_in_table(max(roughness, Float(SMOOTHEST_SHEEN)), ALBEDO_ROUGHNESSES);
    TablePlace at = place_in_table(sqrt(max(cosine, Float(0.0f))), ALBEDO_COSINES);
    return albedo_of_sheet(world, Int(ALBEDO_SHEEN), rough, at, mask);
}

NAMESPACE_END

#endif
