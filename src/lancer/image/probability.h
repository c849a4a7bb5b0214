// The distributions that tests of means need.
#pragma once

namespace lancer {

// I_x(a, b), the regularised incomplete beta function; 0 <= x <= 1, a and b > 0. To about 13 digits.
double incomplete_beta(double x, double a, double b);

// Q(a, x), the regularised upper incomplete gamma function; x >= 0, a > 0. To about 13 digits.
double upper_incomplete_gamma(double a, double x);

// The chance that |t| is exceeded under Student's t with `freedom` degrees [Student 1908]; infinite freedom is the normal distribution.
double student_two_sided(double t, double freedom);

// The chance that `chi2` is exceeded under chi-squared with `freedom` degrees [Pearson 1900].
double chi_squared_above(double chi2, double freedom);

// The z >= 0 that a normal variable exceeds in size with chance p in [0, 1]; the other way round than student_two_sided(z, infinity). At most
// `farthest_normal`, for what is rarer than any double tells.
inline constexpr double farthest_normal = 37.0;
double normal_from_two_sided(double p);

}  // namespace lancer
