#include "analytic/slab.h"

#include <cmath>
#include <numbers>

namespace lancer::tests {

namespace {

using Matrix = std::vector<std::vector<double>>;

constexpr int directions = 24;  // of Gauss's rule over a hemisphere
constexpr int doublings = 30;

double legendre(int n, double x) {
    double before = 1.0, value = x;
    if (n == 0) {
        return 1.0;
    }
    for (int k = 2; k <= n; ++k) {
        const double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
        before = value;
        value = next;
    }
    return value;
}

// Gauss's rule on 0 to 1.
void gauss(std::vector<double>& nodes, std::vector<double>& weights) {
    for (int i = 0; i < directions; ++i) {
        double x = std::cos(std::numbers::pi * (i + 0.75) / (directions + 0.5));
        double slope = 1.0;
        for (int step = 0; step < 100; ++step) {
            slope = directions * (x * legendre(directions, x) - legendre(directions - 1, x)) / (x * x - 1.0);
            x -= legendre(directions, x) / slope;
        }
        nodes.push_back(0.5 * (1.0 - x));
        weights.push_back(1.0 / ((1.0 - x * x) * slope * slope));
    }
}

// Averaged over azimuth; its mean over all cosines is 1. Terms beyond what the rule resolves are left out, as its own answer needs them to be.
double phase(double g, double a, double b) {
    double sum = 0.0, power = 1.0;
    for (int l = 0; l < 2 * directions; ++l) {
        sum += (2 * l + 1) * power * legendre(l, a) * legendre(l, b);
        power *= g;
    }
    return sum;
}

Matrix times(const Matrix& a, const Matrix& b) {
    const std::size_t n = a.size();
    Matrix c(n, std::vector<double>(n));
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = 0; k < n; ++k) {
            for (std::size_t j = 0; j < n; ++j) {
                c[i][j] += a[i][k] * b[k][j];
            }
        }
    }
    return c;
}

// The x of (1 - a) x = b, by elimination.
Matrix solve_one_minus(Matrix a, Matrix b) {
    const std::size_t n = a.size();
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            a[i][j] = (i == j ? 1.0 : 0.0) - a[i][j];
        }
    }
    for (std::size_t k = 0; k < n; ++k) {
        for (std::size_t i = 0; i < n; ++i) {
            if (i == k) {
                continue;
            }
            const double factor = a[i][k] / a[k][k];
            for (std::size_t j = 0; j < n; ++j) {
                a[i][j] -= factor * a[k][j];
                b[i][j] -= factor * b[k][j];
            }
        }
    }
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            b[i][j] /= a[i][i];
        }
    }
    return b;
}

}  // namespace

SlabLight light_of_slab(const Layer& layer, double cosine) {
    // Radiances along the rule's directions; then along the one that is asked for, which lights nothing; then the beam's irradiance.
    std::vector<double> mu, weight;
    gauss(mu, weight);
    mu.push_back(cosine);
    weight.push_back(0.0);
    const std::size_t beam = mu.size();
    const std::size_t n = beam + 1;
    Matrix reflect(n, std::vector<double>(n)), transmit(n, std::vector<double>(n));
    const double thin = layer.thickness / std::pow(2.0, doublings);
    for (std::size_t i = 0; i < beam; ++i) {
        for (std::size_t j = 0; j < beam; ++j) {
            const double share = thin / mu[i] * layer.albedo / 2.0 * weight[j];
            reflect[i][j] = share * phase(layer.asymmetry, mu[i], -mu[j]);
            transmit[i][j] = share * phase(layer.asymmetry, mu[i], mu[j]);
        }
        transmit[i][i] += 1.0 - thin / mu[i];
        const double share = thin / mu[i] * layer.albedo / (4.0 * std::numbers::pi);
        reflect[i][beam] = share * phase(layer.asymmetry, mu[i], -1.0);
        transmit[i][beam] = share * phase(layer.asymmetry, mu[i], 1.0);
    }
    transmit[beam][beam] = 1.0 - thin;
    for (int i = 0; i < doublings; ++i) {
        // Between two equal layers light goes back and forth.
        const Matrix between = solve_one_minus(times(reflect, reflect), transmit);
        const Matrix back = times(transmit, times(reflect, between));
        transmit = times(transmit, between);
        for (std::size_t a = 0; a < n; ++a) {
            for (std::size_t b = 0; b < n; ++b) {
                reflect[a][b] += back[a][b];
            }
        }
    }
    return {reflect[beam - 1][beam], transmit[beam - 1][beam]};
}

}  // namespace lancer::tests
