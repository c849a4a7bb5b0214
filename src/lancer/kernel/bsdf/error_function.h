// The error function and its inverse, for surfaces whose slopes are normally distributed.
#ifndef LANCER_KERNEL_BSDF_ERROR_FUNCTION_H
#define LANCER_KERNEL_BSDF_ERROR_FUNCTION_H

#include "lancer/kernel/spectrum.h"

NAMESPACE_BEGIN

const float SQRT_PI = 1.7724539f;

// 1 - erf(x) for x >= 0, given exp(-x^2); absolute error below 2e-7 [Abramowitz and Stegun 1964, 7.1.26].
FN Float complementary_error_function(Float x, Float exp_of_minus_square) {
    Float t = Float(1.0f) / (Float(1.0f) + Float(0.3275911f) * x);
    Float series = Float(1.061405429f);
    series = series * t + Float(-1.453152027f);
    series = series * t + Float(1.421413741f);
    series = series * t + Float(-0.284496736f);
    series = series * t + Float(0.254829592f);
    return series * t * exp_of_minus_square;
}

FN Float error_function(Float x) {
    Float a = abs(x);
    return with_sign_of(Float(1.0f) - complementary_error_function(a, exponential(-a * a)), x);
}

// The x with erf(x) = y, -1 < y < 1; relative error below 5e-6 [Giles 2012].
FN Float inverse_error_function(Float y) {
    Float w = -natural_log((Float(1.0f) - y) * (Float(1.0f) + y));
    Float s = w - Float(2.5f);
    Float near = Float(2.81022636e-08f);
    near = near * s + Float(3.43273939e-07f);
    near = near * s + Float(-3.5233877e-06f);
    near = near * s + Float(-4.39150654e-06f);
    near = near * s + Float(0.00021858087f);
    near = near * s + Float(-0.00125372503f);
    near = near * s + Float(-0.00417768164f);
    near = near * s + Float(0.246640727f);
    near = near * s + Float(1.50140941f);
    Float t = sqrt(max(w, Float(0.0f))) - Float(3.0f);
    Float far = Float(-0.000200214257f);
    far = far * t + Float(0.000100950558f);
    far = far * t + Float(0.00134934322f);
    far = far * t + Float(-0.00367342844f);
    far = far * t + Float(0.00573950773f);
    far = far * t + Float(-0.0076224613f);
    far = far * t + Float(0.00943887047f);
    far = far * t + Float(1.00167406f);
    far = far * t + Float(2.83297682f);
    return y * select(w < Float(5.0f), near, far);
}

NAMESPACE_END

#endif
