// Phase functions: into which directions a medium scatters, as BSDFs of points in space. `wo` points to where the path came from, wi to where it
// goes; there is no cosine. Each is the density with which its own directions are drawn, so that what is drawn always weighs 1.
#ifndef LANCER_KERNEL_VOLUME_PHASE_H
#define LANCER_KERNEL_VOLUME_PHASE_H

#include "lancer/kernel/bsdf/closure.h"
#include "lancer/kernel/frame.h"
#include "lancer/kernel/warp.h"

NAMESPACE_BEGIN

FN Mask is_phase(IN(Closure) c) { return is_above(c.kind, Int(PHASE_HENYEY_GREENSTEIN - 1)); }

// `cosine` of the angle by which light is turned: 1 goes straight on. Per solid angle [Henyey and Greenstein 1941].
FN Float henyey_greenstein(Float g, Float cosine) {
    Float rest = Float(1.0f) - g;
    Float d = max(rest * rest + Float(2.0f) * g * (Float(1.0f) - cosine), Float(SMALLEST));
    return (Float(1.0f) - g * g) / (Float(4.0f * PI) * d * sqrt(d));
}

// A cosine drawn from it, for u in [0, 1). The usual inverse times 2 g, divided through so that nothing is lost where g is small.
FN Float henyey_greenstein_cosine(Float g, Float u) {
    Float s = Float(2.0f) * u - Float(1.0f);
    Float d = Float(1.0f) + g * s;
    Float n = s + g * (Float(0.5f) * (s * s + Float(3.0f)) + g * (s + g * Float(0.5f) * (s * s - Float(1.0f))));
    return min(max(n / (d * d), Float(-1.0f)), Float(1.0f));
}

// Of what is much smaller than the wavelength, such as the air's molecules; the wavelength's fourth power belongs to the coefficients
// [Rayleigh 1871].
FN Float rayleigh(Float cosine) { return Float(3.0f / (16.0f * PI)) * (Float(1.0f) + cosine * cosine); }

// The root of the cubic that its cumulative share is.
FN Float rayleigh_cosine(Float u) {
    Float q = Float(4.0f) * u - Float(2.0f);
    Float size = abs(q);
    Float a = power(size + sqrt(size * size + Float(1.0f)), Float(1.0f / 3.0f));
    return with_sign_of(min(a - Float(1.0f) / a, Float(1.0f)), q);
}

FN Float phase_density(IN(Closure) c, Vec3 wo, Vec3 wi) {
    Float cosine = -dot(wo, wi);
    Float p = henyey_greenstein(c.roughness_x, cosine);
    return select(is_equal(c.kind, Int(PHASE_RAYLEIGH)), rayleigh(cosine), p);
}

FN BsdfValue phase_value(IN(Closure) c, Vec3 wo, Vec3 wi) {
    BsdfValue v;
    v.density = phase_density(c, wo, wi);
    v.value = c.color * v.density;
    return v;
}

FN BsdfSample phase_sample(IN(Closure) c, Vec3 wo, Vec2 u) {
    BsdfSample s = no_sample();
    Mask small_ones = is_equal(c.kind, Int(PHASE_RAYLEIGH));
    Float cosine = henyey_greenstein_cosine(c.roughness_x, u.x);
    cosine = select(small_ones, rayleigh_cosine(u.x), cosine);
    Float sine = sqrt(max(Float(1.0f) - cosine * cosine, Float(0.0f)));
    Vec2 around = on_circle(u.y);
    s.wi = to_world(frame_around(-wo), vec3_of(sine * around.x, sine * around.y, cosine));
    s.density = select(small_ones, rayleigh(cosine), henyey_greenstein(c.roughness_x, cosine));
    s.weight = c.color;
    s.valid = s.density > Float(0.0f);
    return s;
}

// What light meets at a point of a medium.
FN Closure phase_closure(Int kind, Float asymmetry) {
    Closure c = no_closure();
    c.kind = kind;
    c.color = vec4_all(Float(1.0f));
    c.roughness_x = asymmetry;
    return c;
}

NAMESPACE_END

#endif
