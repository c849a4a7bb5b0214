// Light at the few wavelengths of one path, or as linear RGB.
//
// A path carries four wavelengths: the first is drawn at random, the others follow a quarter of the distribution apart, so that together they
// cover it [Wilkie et al. 2014]. With `world.spectral == 0` the same code carries linear RGB in the first three places and 0 in the last.
#ifndef LANCER_KERNEL_SPECTRUM_H
#define LANCER_KERNEL_SPECTRUM_H

#include "lancer/kernel/math.h"
#include "lancer/kernel/tables.h"

NAMESPACE_BEGIN

#ifdef __cplusplus
using Spectrum = Vec4;
#else
#define Spectrum Vec4
#endif

const float FIRST_WAVELENGTH = 360.0f;  // nanometres
const float LAST_WAVELENGTH = 830.0f;
const int WAVELENGTH_COUNT = 471;  // tables hold one value for each nanometre

// Wavelengths are drawn from a logistic distribution cut to the visible, which is easy to invert: near the curve of the eye's sensitivity
// [Radziszewski et al. 2009]. Of four wavelengths of D65 these constants leave a variance of 0.02, 0.001 and 0.34 in linear red,
// green and blue. A lower middle would spread it more evenly (0.09, 0.0002 and 0.15 at 515), but most scenes are warm, and blue weighs least.
const float WAVELENGTH_MIDDLE = 538.0f;
const float WAVELENGTH_SPREAD = 69.0f;

FN Spectrum black() { return vec4_all(Float(0.0f)); }

FN Float largest(Spectrum s) { return max(max(s.x, s.y), max(s.z, s.w)); }

FN Float mean(Spectrum s) { return (s.x + s.y + s.z + s.w) * Float(0.25f); }

FN Mask is_black(Spectrum s) { return largest(s) <= Float(0.0f); }

FN Float natural_log(Float x) { return log_2(x) * Float(0.69314718f); }

// The share of the logistic distribution below a wavelength.
FN Float wavelength_share(Float nanometres) {
    return Float(1.0f) / (Float(1.0f) + exponential((Float(WAVELENGTH_MIDDLE) - nanometres) * Float(1.0f / WAVELENGTH_SPREAD)));
}

FN Float wavelength_at(Float u) {
    Float low = wavelength_share(Float(FIRST_WAVELENGTH));
    Float high = wavelength_share(Float(LAST_WAVELENGTH));
    Float share = low + (high - low) * u;
    Float x = Float(WAVELENGTH_MIDDLE) + Float(WAVELENGTH_SPREAD) * natural_log(share / (Float(1.0f) - share));
    return min(max(x, Float(FIRST_WAVELENGTH)), Float(LAST_WAVELENGTH));
}

// Density per nanometre.
FN Float wavelength_density(Float nanometres) {
    Float share = wavelength_share(nanometres);
    Float all = wavelength_share(Float(LAST_WAVELENGTH)) - wavelength_share(Float(FIRST_WAVELENGTH));
    return share * (Float(1.0f) - share) / (Float(WAVELENGTH_SPREAD) * all);
}

FN Float fraction(Float x) { return x - floor(x); }

// Four wavelengths for one random number; the first is the one that stays when a path can carry only one.
FN Vec4 wavelengths_at(Float u) {
    return vec4_of(wavelength_at(u), wavelength_at(fraction(u + Float(0.25f))), wavelength_at(fraction(u + Float(0.5f))),
                   wavelength_at(fraction(u + Float(0.75f))));
}

// The entry of a table of WAVELENGTH_COUNT values whose nanometre holds the wavelength.
FN Int wavelength_entry(Float nanometres) { return round_to_int(nanometres - Float(FIRST_WAVELENGTH)); }

// A tabulated spectrum at the path's wavelengths.
FN Spectrum curve_value(IN(WorldRecord) world, int curve, Vec4 nanometres, Mask mask) {
    Int first = Int(curve * WAVELENGTH_COUNT);
    return vec4_of(gather_float(world.curves, first + wavelength_entry(nanometres.x), mask),
                   gather_float(world.curves, first + wavelength_entry(nanometres.y), mask),
                   gather_float(world.curves, first + wavelength_entry(nanometres.z), mask),
                   gather_float(world.curves, first + wavelength_entry(nanometres.w), mask));
}

// Linear RGB of what a path brings: the observer's answer to each wavelength, divided by the density with which it was drawn.
FN Vec3 spectrum_to_rgb(IN(WorldRecord) world, Spectrum radiance, Vec4 nanometres, Mask mask) {
    Vec3 rgb = vec3_of(radiance.x, radiance.y, radiance.z);
    if (world.spectral != 0) {
        Spectrum share = vec4_of(radiance.x / wavelength_density(nanometres.x), radiance.y / wavelength_density(nanometres.y),
                                 radiance.z / wavelength_density(nanometres.z), radiance.w / wavelength_density(nanometres.w)) *
                         Float(0.25f);
        rgb = gather_vec3(world.observer, wavelength_entry(nanometres.x), mask) * share.x +
              gather_vec3(world.observer, wavelength_entry(nanometres.y), mask) * share.y +
              gather_vec3(world.observer, wavelength_entry(nanometres.z), mask) * share.z +
              gather_vec3(world.observer, wavelength_entry(nanometres.w), mask) * share.w;
    }
    return rgb;
}

NAMESPACE_END

#endif
