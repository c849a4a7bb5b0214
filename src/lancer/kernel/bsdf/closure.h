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
    Spectrum index;       // conductors: n; dielectrics: index behind the surface over the one in front
    Spectrum extinction;  // conductors: k
    Float roughness_x;
    Float roughness_y;
    Mask disperses;  // `index` differs from wavelength to wavelength: what is refracted goes on with the first only
};

FN Closure no_closure() {
    Closure c;
    c.kind = Int(BSDF_NONE);
    c.color = black();
    c.index = vec4_all(Float(1.0f));
    c.extinction = black();
    c.roughness_x = Float(0.0f);
    c.roughness_y = Float(0.0f);
    c.disperses = Float(1.0f) < Float(0.0f);
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
    s.discrete = either(both(mask, a.discrete), without(b.discrete, mask));
    s.transmits = either(both(mask, a.transmits), without(b.transmits, mask));
    s.valid = either(both(mask, a.valid), without(b.valid, mask));
    return s;
}

NAMESPACE_END

#endif
