// Elementary functions of our own: a library's variant depends on the processor, and these give the same bits everywhere.
// Relative error below 3e-7 unless a comment says otherwise; tests/unit/kernel_math_test.cpp measures it.
#ifndef LANCER_KERNEL_MATH_H
#define LANCER_KERNEL_MATH_H

#include "lancer/kernel/language.h"

NAMESPACE_BEGIN

const float PI = 3.14159265358979f;
const float FAR = 3.0e38f;               // "no hit": farther than anything
const float ROUNDING = 5.9604645e-8f;    // half an ulp of 1: the largest relative error of one float operation
const float SMALLEST = 1.17549435e-38f;  // smallest normal float; its reciprocal is finite

FN Float square(Float x) { return x * x; }

FN Float clamp01(Float x) { return min(max(x, Float(0.0f)), Float(1.0f)); }

FN Float with_sign_of(Float magnitude, Float sign) { return select(sign < Float(0.0f), -magnitude, magnitude); }

// 2^x. By Taylor's series around the nearest integer; 0 below -126, 2^127 above 127.
FN Float power_of_2(Float x) {
    Float y = min(max(x, Float(-127.0f)), Float(127.0f));
    Int whole = round_to_int(y);
    Float f = y - to_float(whole);
    Float s = Float(1.5252734e-5f);
    s = s * f + Float(1.5403530e-4f);
    s = s * f + Float(1.3333558e-3f);
    s = s * f + Float(9.6181291e-3f);
    s = s * f + Float(5.5504109e-2f);
    s = s * f + Float(2.4022651e-1f);
    s = s * f + Float(6.9314718e-1f);
    s = s * f + Float(1.0f);
    Float scale = bits_float((whole + Int(127)) << 23);
    return select(x < Float(-126.0f), Float(0.0f), s * scale);
}

// Binary logarithm of a positive normal number, by the series of artanh around the nearest power of 2.
FN Float log_2(Float x) {
    Int bits = float_bits(x);
    Int shifted = bits - Int(0x3f3504f3);  // the bits of sqrt(1/2): the mantissa left over lies between it and sqrt(2)
    Int exponent = shifted >> 23;
    Float m = bits_float(bits - (exponent << 23));
    Float s = (m - Float(1.0f)) / (m + Float(1.0f));
    Float z = s * s;
    Float series = Float(0.32059890f);
    series = series * z + Float(0.41219858f);
    series = series * z + Float(0.57707802f);
    series = series * z + Float(0.96179669f);
    series = series * z + Float(2.8853901f);
    return to_float(exponent) + s * series;
}

// x^y for x >= 0; 0^y is 0. The error grows with y: about |y log2 x| times 1e-7.
FN Float power(Float x, Float y) { return select(x < Float(SMALLEST), Float(0.0f), power_of_2(y * log_2(max(x, Float(SMALLEST))))); }

FN Float exponential(Float x) { return power_of_2(x * Float(1.44269504f)); }

// Angle of the point (x, y) seen from the origin, in (-pi, pi]; absolute error below 5e-7. Series of arctangent as in Cephes.
FN Float angle_of(Float y, Float x) {
    Float ax = abs(x);
    Float ay = abs(y);
    Float big = max(ax, ay);
    Float small_ = min(ax, ay);
    Float ratio = select(big > Float(0.0f), small_ / max(big, Float(SMALLEST)), Float(0.0f));
    Mask steep = ratio > Float(0.41421356f);
    Float r = select(steep, (ratio - Float(1.0f)) / (ratio + Float(1.0f)), ratio);
    Float z = r * r;
    Float series = Float(8.05374449538e-2f);
    series = series * z - Float(1.38776856032e-1f);
    series = series * z + Float(1.99777106478e-1f);
    series = series * z - Float(3.33329491539e-1f);
    Float angle = r + r * z * series;
    angle = select(steep, angle + Float(0.25f * PI), angle);
    angle = select(ay > ax, Float(0.5f * PI) - angle, angle);
    angle = select(x < Float(0.0f), Float(PI) - angle, angle);
    return with_sign_of(angle, y);
}

// (cos, sin) of a part of a full turn, 0 <= turn < 2^20: by quadrants and Taylor's series; absolute error below 2e-7.
FN Vec2 on_circle(Float turn) {
    Float quarters = turn * Float(4.0f);
    Int quadrant = round_to_int(quarters);
    Float a = (quarters - to_float(quadrant)) * Float(0.5f * PI);
    Float z = a * a;
    Float sine = a + a * z * (Float(-1.6666667e-1f) + z * (Float(8.3333333e-3f) + z * (Float(-1.9841270e-4f) + z * Float(2.7557319e-6f))));
    Float cosine = Float(1.0f) + z * (Float(-0.5f) + z * (Float(4.1666667e-2f) + z * (Float(-1.3888889e-3f) + z * Float(2.4801587e-5f))));
    Mask odd = is_equal(quadrant & Int(1), Int(1));
    Float x = select(odd, -sine, cosine);
    Float y = select(odd, cosine, sine);
    Mask turned = is_equal(quadrant & Int(2), Int(2));
    return vec2_of(select(turned, -x, x), select(turned, -y, y));
}

// From 0 to 1 and 0 to 1, steep at both ends: even steps of the result are small steps of `v` there.
FN Float to_even_ends(Float v) {
    Float lower = sqrt(max(Float(0.5f) * v, Float(0.0f)));
    Float upper = Float(1.0f) - sqrt(max(Float(0.5f) - Float(0.5f) * v, Float(0.0f)));
    return select(v < Float(0.5f), lower, upper);
}

NAMESPACE_END

#endif
