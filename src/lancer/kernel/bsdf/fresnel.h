// How much light a border reflects.
#ifndef LANCER_KERNEL_BSDF_FRESNEL_H
#define LANCER_KERNEL_BSDF_FRESNEL_H

#include "lancer/kernel/refraction.h"
#include "lancer/kernel/spectrum.h"

NAMESPACE_BEGIN

// Of a metal with index n + ik, from vacuum, unpolarised [Fresnel 1823; Born and Wolf 1999, 14.2].
FN Float fresnel_conductor(Float cosine, Float n, Float k) {
    Float c2 = cosine * cosine;
    Float s2 = Float(1.0f) - c2;
    Float t0 = n * n - k * k - s2;
    Float a2_b2 = sqrt(t0 * t0 + Float(4.0f) * n * n * k * k);
    Float a = sqrt(max(Float(0.5f) * (a2_b2 + t0), Float(0.0f)));
    Float across = (a2_b2 + c2 - Float(2.0f) * a * cosine) / max(a2_b2 + c2 + Float(2.0f) * a * cosine, Float(SMALLEST));
    Float t3 = a2_b2 * c2 + s2 * s2;
    Float t4 = Float(2.0f) * a * cosine * s2;
    Float along = across * (t3 - t4) / max(t3 + t4, Float(SMALLEST));  // straight on, where n and k are 0, nothing is left to divide
    return Float(0.5f) * (across + along);
}

FN Spectrum fresnel_conductor_spectrum(Float cosine, Spectrum n, Spectrum k) {
    return vec4_of(fresnel_conductor(cosine, n.x, k.x), fresnel_conductor(cosine, n.y, k.y), fresnel_conductor(cosine, n.z, k.z),
                   fresnel_conductor(cosine, n.w, k.w));
}

// Of a clear border at each wavelength; `eta`: index behind over index in front.
FN Spectrum fresnel_spectrum(Float cosine, Spectrum eta) {
    Float cos_t = Float(0.0f);
    Spectrum r;
    r.x = fresnel(cosine, eta.x, cos_t);
    r.y = fresnel(cosine, eta.y, cos_t);
    r.z = fresnel(cosine, eta.z, cos_t);
    r.w = fresnel(cosine, eta.w, cos_t);
    return r;
}

// What a pane reflects of all the light that goes to and fro inside of it: r + t r t + t r^3 t + ... with t = 1 - r.
FN Spectrum pane_spectrum(Float cosine, Spectrum eta) {
    Spectrum once = fresnel_spectrum(cosine, eta);
    return once * Float(2.0f) / (vec4_all(Float(1.0f)) + once);
}

NAMESPACE_END

#endif
