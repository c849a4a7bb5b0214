// Smooth spectra for linear sRGB [Jakob and Hanika 2019]: the look-up in the table that spectrum/upsample.h describes, lane by lane. The
// numbers here are those of spectrum/upsample.h; tests/unit/upsample_test.cpp compares both.
#ifndef LANCER_KERNEL_UPSAMPLE_H
#define LANCER_KERNEL_UPSAMPLE_H

#include "lancer/kernel/math.h"
#include "lancer/kernel/tables.h"

NAMESPACE_BEGIN

const int UPSAMPLING_HUES = 192;  // 32 in each sixth of the circle of hues
const int UPSAMPLING_SATURATIONS = 21;
const int UPSAMPLING_LIGHTNESSES = 49;

// Reflectance, 0 to 1, at a wavelength of 360 to 830 nm: 1/2 + p / (2 sqrt(1 + p^2)) of a parabola p, without the difference of nearly equal
// numbers.
FN Float sigmoid_polynomial(Vec3 coefficients, Float nanometres) {
    Float t = (nanometres - Float(595.0f)) * Float(1.0f / 235.0f);
    Float p = (coefficients.x * t + coefficients.y) * t + coefficients.z;
    Float squeezed = Float(1.0f) / (Float(1.0f) + p * p);
    Float dark = Float(0.5f) * squeezed / (Float(1.0f) + abs(p) * sqrt(squeezed));
    dark = select(squeezed < Float(1.0e-24f), Float(0.0f), dark);
    return select(p < Float(0.0f), dark, Float(1.0f) - dark);
}

// Three neighbours in a table of floats.
#ifdef LANCER_ISA
FN Vec3 gather_three(FloatTable table, Int index, Mask mask) {
    alignas(64) std::int32_t at[LANES];
    alignas(64) float x[LANES] = {};
    alignas(64) float y[LANES] = {};
    alignas(64) float z[LANES] = {};
    index.store_aligned(at);
    for (unsigned left = mask_bits(mask); left != 0; left &= left - 1) {
        const int lane = __builtin_ctz(left);
        x[lane] = table[at[lane]];
        y[lane] = table[at[lane] + 1];
        z[lane] = table[at[lane] + 2];
    }
    return vec3_of(Float::load_aligned(x), Float::load_aligned(y), Float::load_aligned(z));
}
#else
FN Vec3 gather_three(FloatTable table, Int index, Mask mask) {
    Vec3 value = vec3_all(Float(0.0f));
    if (mask) {
        value = vec3_of(Float(AT(table, index)), Float(AT(table, index + 1)), Float(AT(table, index + 2)));
    }
    return value;
}
#endif

// Between the entries of two hues at one saturation and lightness, which begin at `row`.
FN Vec3 between_hues(FloatTable table, Int row, Int hue, Int next_hue, Float fraction, Mask mask) {
    Vec3 a = gather_three(table, (row + hue) * Int(3), mask);
    Vec3 b = gather_three(table, (row + next_hue) * Int(3), mask);
    return a + (b - a) * fraction;
}

// The parabola whose reflectance looks like linear sRGB under D65. Components are moved into [0, 1]. Greys give constant spectra.
FN Vec3 reflectance_coefficients(FloatTable table, Vec3 rgb, Mask mask) {
    Vec3 color = vec3_of(clamp01(rgb.x), clamp01(rgb.y), clamp01(rgb.z));
    // The complements of bright colours are dark, and have the opposite parabola.
    Mask bright = max(max(color.x, color.y), color.z) + min(min(color.x, color.y), color.z) > Float(1.0f);
    color = select(bright, vec3_all(Float(1.0f)) - color, color);
    Float high = max(max(color.x, color.y), color.z);
    Float low = min(min(color.x, color.y), color.z);
    Float chroma = high - low;
    Float lightness = min(Float(0.5f) * (high + low), Float(0.5f));

    // From 0 to 6: red, yellow, green, cyan, blue, magenta, red.
    Float scale = Float(1.0f) / max(chroma, Float(SMALLEST));
    Float hue = select(color.y < high, Float(4.0f) + (color.x - color.y) * scale, Float(2.0f) + (color.z - color.x) * scale);
    hue = select(color.x < high, hue, (color.y - color.z) * scale);
    hue = select(hue < Float(0.0f), hue + Float(6.0f), hue);
    Float sixth = floor(hue);
    Float u = (sixth + to_even_ends(hue - sixth)) * Float(32.0f);
    Float saturation = min(chroma / max(high + low, Float(SMALLEST)), Float(1.0f));
    Float v = (Float(1.0f) - sqrt(Float(1.0f) - saturation)) * Float(20.0f);
    Float w = to_even_ends(Float(2.0f) * lightness) * Float(48.0f);

    Float u_floor = floor(u);
    Float v_floor = min(floor(v), Float(19.0f));
    Float w_floor = min(floor(w), Float(47.0f));
    // Red stands at both ends of the circle.
    Float u_first = select(u_floor < Float(192.0f), u_floor, u_floor - Float(192.0f));
    Float u_next = select(u_first < Float(191.0f), u_first + Float(1.0f), Float(0.0f));
    Int hue_entry = round_to_int(u_first);
    Int next_hue = round_to_int(u_next);
    Int row = (round_to_int(w_floor) * Int(UPSAMPLING_SATURATIONS) + round_to_int(v_floor)) * Int(UPSAMPLING_HUES);
    const int next_saturation = UPSAMPLING_HUES;
    const int next_lightness = UPSAMPLING_HUES * UPSAMPLING_SATURATIONS;

    Float along = u - u_floor;
    Vec3 a = between_hues(table, row, hue_entry, next_hue, along, mask);
    Vec3 b = between_hues(table, row + Int(next_saturation), hue_entry, next_hue, along, mask);
    Vec3 c = between_hues(table, row + Int(next_lightness), hue_entry, next_hue, along, mask);
    Vec3 d = between_hues(table, row + Int(next_lightness + next_saturation), hue_entry, next_hue, along, mask);
    Vec3 darker = a + (b - a) * (v - v_floor);
    Vec3 lighter = c + (d - c) * (v - v_floor);
    Vec3 value = darker + (lighter - darker) * (w - w_floor);

    Float divisor = sqrt(max(lightness * (Float(1.0f) - lightness), Float(1.0e-30f)));
    value = vec3_of(value.x, value.y, value.z + (lightness - Float(0.5f))) / divisor;
    return select(bright, value * Float(-1.0f), value);
}

// What light of any strength is divided by before its smooth spectrum is looked up; its spectrum is this times the reflectance times D65.
FN Float emission_scale(Vec3 rgb) { return max(max(max(rgb.x, rgb.y), rgb.z) * Float(2.0f), Float(0.0f)); }

NAMESPACE_END

#endif
