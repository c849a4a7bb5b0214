#include "lancer/image/probability.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace lancer {
namespace {

constexpr double tiny = 1e-300;
constexpr double enough = 1e-15;
constexpr int most_steps = 10000;

double away_from_zero(double x) { return std::fabs(x) < tiny ? tiny : x; }

// std::lgamma writes to a global; for positive arguments its sign, the only thing written, is of no interest.
double log_gamma(double x) {
    int sign = 0;
    return ::lgamma_r(x, &sign);
}

// The continued fraction of I_x(a, b) [DLMF, 8.17.22], from the front by the modified method of Lentz [Lentz 1976].
double beta_fraction(double x, double a, double b) {
    double c = 1.0, d = 1.0 / away_from_zero(1.0 - (a + b) * x / (a + 1.0)), value = d;
    for (int step = 1; step < most_steps; ++step) {
        const double m = static_cast<double>(step);
        const double even = m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m));
        const double odd = -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0));
        for (const double term : {even, odd}) {
            d = 1.0 / away_from_zero(1.0 + term * d);
            c = away_from_zero(1.0 + term / c);
            value *= d * c;
        }
        if (std::fabs(d * c - 1.0) < enough) {
            break;
        }
    }
    return value;
}

}  // namespace

double incomplete_beta(double x, double a, double b) {
    if (x <= 0.0 || x >= 1.0) {
        return x <= 0.0 ? 0.0 : 1.0;
    }
    const double front = std::exp(log_gamma(a + b) - log_gamma(a) - log_gamma(b) + a * std::log(x) + b * std::log1p(-x));
    // The fraction converges quickly on the side of the mean.
    return x < (a + 1.0) / (a + b + 2.0) ? front * beta_fraction(x, a, b) / a : 1.0 - front * beta_fraction(1.0 - x, b, a) / b;
}

double upper_incomplete_gamma(double a, double x) {
    if (x <= 0.0) {
        return 1.0;
    }
    const double front = std::exp(a * std::log(x) - x - log_gamma(a));
    if (x < a + 1.0) {  // the series of the lower one [DLMF, 8.7.1]
        double term = 1.0 / a, sum = term;
        for (int step = 1; step < most_steps && term > sum * enough; ++step) {
            term *= x / (a + static_cast<double>(step));
            sum += term;
        }
        return 1.0 - front * sum;
    }
    double b = x + 1.0 - a, c = 1.0 / tiny, d = 1.0 / away_from_zero(b), value = d;  // [DLMF, 8.9.2]
    for (int step = 1; step < most_steps; ++step) {
        const double i = static_cast<double>(step), term = -i * (i - a);
        b += 2.0;
        d = 1.0 / away_from_zero(term * d + b);
        c = away_from_zero(b + term / c);
        value *= d * c;
        if (std::fabs(d * c - 1.0) < enough) {
            break;
        }
    }
    return front * value;
}

double student_two_sided(double t, double freedom) {
    if (std::isnan(t)) {
        return 1.0;
    }
    if (std::isinf(t)) {
        return 0.0;
    }
    if (std::isinf(freedom)) {
        return std::erfc(std::fabs(t) / std::numbers::sqrt2);
    }
    if (freedom > 1e5) {  // where the logarithms of the factorials lose digits [Abramowitz and Stegun 1964, 26.7.8]
        const double z = t * (1.0 - 0.25 / freedom) / std::sqrt(1.0 + 0.5 * t * t / freedom);
        return std::erfc(std::fabs(z) / std::numbers::sqrt2);
    }
    return incomplete_beta(freedom / (freedom + t * t), 0.5 * freedom, 0.5);
}

double chi_squared_above(double chi2, double freedom) {
    if (freedom > 1e5) {  // [Wilson and Hilferty 1931]; the series would take long
        const double spread = 2.0 / (9.0 * freedom);
        return 0.5 * std::erfc((std::cbrt(chi2 / freedom) - (1.0 - spread)) / std::sqrt(2.0 * spread));
    }
    return upper_incomplete_gamma(0.5 * freedom, 0.5 * chi2);
}

double normal_from_two_sided(double p) {
    if (p >= 1.0) {
        return 0.0;
    }
    if (p < 1e-300) {
        return farthest_normal;
    }
    // To 0.0005 [Abramowitz and Stegun 1964, 26.2.23], then Halley's steps, each of which triples the digits.
    const double t = std::sqrt(-2.0 * std::log(0.5 * p));
    double z = t - (2.515517 + t * (0.802853 + t * 0.010328)) / (1.0 + t * (1.432788 + t * (0.189269 + t * 0.001308)));
    for (int step = 0; step < 3; ++step) {
        const double slope = -std::sqrt(2.0 / std::numbers::pi) * std::exp(-0.5 * z * z);
        const double newton = (std::erfc(z / std::numbers::sqrt2) - p) / slope;
        z -= newton / (1.0 + 0.5 * z * newton);
    }
    return std::max(0.0, z);
}

}  // namespace lancer
