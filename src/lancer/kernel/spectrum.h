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

// Wavelengths are drawn with a density that is the same within each nanometre: 1 / WAVELENGTH_SLOTS at least. world/wavelengths.h says which. For
// each of so many equal shares of the random number a table says in which nanometre it begins.
const int WAVELENGTH_SLOTS = 8192;

FN Spectrum black() { return vec4_all(Float(0.0f)); }

FN Float largest(Spectrum s) { return max(max(s.x, s.y), max(s.z, s.w)); }

FN Float mean(Spectrum s) { return (s.x + s.y + s.z + s.w) * Float(0.25f); }

// What is not a number is not black: it has to be seen.
FN Mask is_black(Spectrum s) { return both(both(s.x <= Float(0.0f), s.y <= Float(0.0f)), both(s.z <= Float(0.0f), s.w <= Float(0.0f))); }

FN Spectrum rgb_value(Vec3 rgb) { return vec4_of(rgb.x, rgb.y, rgb.z, Float(0.0f)); }

FN Float natural_log(Float x) { return log_2(x) * Float(0.69314718f); }

// The entry of a table of WAVELENGTH_COUNT values whose nanometre holds the wavelength.
FN Int wavelength_entry(Float nanometres) { return round_to_int(nanometres - Float(FIRST_WAVELENGTH)); }

FN Float wavelength_at(IN(WorldRecord) world, Float u, Mask mask) {
    Int entry = gather_int(world.wavelength_slots, round_to_int(floor(u * Float(float(WAVELENGTH_SLOTS)))), mask);
    Float lower = gather_float(world.wavelength_edges, entry, mask);
    Float upper = gather_float(world.wavelength_edges, entry + Int(1), mask);
    // A share is no longer than a nanometre's: it ends in this one or in the next.
    Mask beyond = u >= upper;
    Float last = gather_float(world.wavelength_edges, entry + Int(2), mask);
    entry = select(beyond, entry + Int(1), entry);
    Float share = (u - select(beyond, upper, lower)) / select(beyond, last - upper, upper - lower);
    Float place = min(max(share, Float(0.001f)), Float(0.999f)) + to_float(entry) + Float(FIRST_WAVELENGTH - 0.5f);
    return min(max(place, Float(FIRST_WAVELENGTH)), Float(LAST_WAVELENGTH));
}

// Density per nanometre.
FN Float wavelength_density(IN(WorldRecord) world, Float nanometres, Mask mask) {
    return gather_float(world.wavelength_densities, wavelength_entry(nanometres), mask);
}

FN Float fraction(Float x) { return x - floor(x); }

// Four wavelengths for one random number; the first is the one that stays when a path can carry only one.
FN Vec4 wavelengths_at(IN(WorldRecord) world, Float u, Mask mask) {
    return vec4_of(wavelength_at(world, u, mask), wavelength_at(world, fraction(u + Float(0.25f)), mask),
                   wavelength_at(world, fraction(u + Float(0.5f)), mask), wavelength_at(world, fraction(u + Float(0.75f)), mask));
}

// Of each of the four; 1 in lanes that are off.
FN Vec4 wavelength_densities(IN(WorldRecord) world, Vec4 nanometres, Mask mask) {
    Vec4 density = vec4_of(wavelength_density(world, nanometres.x, mask), wavelength_density(world, nanometres.y, mask),
                           wavelength_density(world, nanometres.z, mask), wavelength_density(world, nanometres.w, mask));
    return vec4_of(select(mask, density.x, Float(1.0f)), select(mask, density.y, Float(1.0f)), select(mask, density.z, Float(1.0f)),
                   select(mask, density.w, Float(1.0f)));
}

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
        Vec4 density = wavelength_densities(world, nanometres, mask);
        Spectrum share =
            vec4_of(radiance.x / density.x, radiance.y / density.y, radiance.z / density.z, radiance.w / density.w) * Float(0.25f);
        rgb = gather_vec3(world.observer, wavelength_entry(nanometres.x), mask) * share.x +
              gather_vec3(world.observer, wavelength_entry(nanometres.y), mask) * share.y +
              gather_vec3(world.observer, wavelength_entry(nanometres.z), mask) * share.z +
              gather_vec3(world.observer, wavelength_entry(nanometres.w), mask) * share.w;
    }
    return rgb;
}

NAMESPACE_END

#endif
