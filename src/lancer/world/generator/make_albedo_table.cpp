// Runs when lancer is built: makes the table of what rough surfaces reflect (see kernel/bsdf/albedo.h) and writes it to the file that its only
// argument names. In double precision, with the kernel's own facets.
#define LANCER_DOUBLE

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <vector>

#include "lancer/kernel/bsdf/albedo.h"
#include "lancer/kernel/bsdf/fresnel.h"
#include "lancer/kernel/bsdf/sheen.h"

namespace {

using namespace lancer::kernel_double;

// So many facets in each of the two ways, half of them around: both halves are alike.
constexpr int fineness = 64;
constexpr int halfway = fineness / 2;

class AlbedoTable {
public:
    AlbedoTable() : values_(static_cast<std::size_t>(ALBEDO_VALUES)) {}

    void make() {
        for (int rough = 0; rough < ALBEDO_ROUGHNESSES; ++rough) {
            for (int cosine = 0; cosine < ALBEDO_COSINES; ++cosine) {
                const double t = static_cast<double>(cosine) / (ALBEDO_COSINES - 1);
                const double mu = cosine == 0 ? 1e-4 : t * t;
                for (int distribution = 0; distribution < ALBEDO_DISTRIBUTIONS; ++distribution) {
                    add_facets(distribution, rough, cosine, mu);
                }
                value(ALBEDO_SHEEN, rough, cosine) = sheen(static_cast<double>(rough) / (ALBEDO_ROUGHNESSES - 1), mu);
            }
        }
        for (int sheet = 0; sheet < ALBEDO_SHEETS; ++sheet) {
            for (int rough = 0; rough < ALBEDO_ROUGHNESSES; ++rough) {
                values_[static_cast<std::size_t>(ALBEDO_MEANS + sheet * ALBEDO_ROUGHNESSES + rough)] = mean(sheet, rough);
            }
        }
    }

    bool write(const char* path) const {
        std::vector<float> floats;
        for (const double v : values_) {
            floats.push_back(static_cast<float>(v));
        }
        std::FILE* const file = std::fopen(path, "wb");
        const bool written = file && std::fwrite(floats.data(), sizeof(float), floats.size(), file) == floats.size();
        return (file && std::fclose(file) == 0) && written;
    }

    bool is_right() const {
        // A sheen of little roughness is too bright from the side, which the kernel sees to.
        for (int i = 0; i < ALBEDO_VALUES; ++i) {
            const int sheet = i < ALBEDO_MEANS ? i / ALBEDO_SHEET : (i - ALBEDO_MEANS) / ALBEDO_ROUGHNESSES;
            const double v = values_[static_cast<std::size_t>(i)];
            if (!(v >= 0.0 && v <= (sheet == ALBEDO_SHEEN ? 4.0 : 1.0))) {
                return false;
            }
        }
        return true;
    }

private:
    static double index_of(int i) {
        const double root = static_cast<double>(i) / (ALBEDO_INDICES - 1);
        const double ratio = static_cast<double>(ALBEDO_LARGEST_RATIO) * root * root;
        return (1.0 + ratio) / (1.0 - ratio);
    }

    void add_facets(int distribution, int rough, int cosine, double mu) {
        const double root = static_cast<double>(rough) / (ALBEDO_ROUGHNESSES - 1);
        Facets f;
        f.x = f.y = rough == 0 ? 1e-6 : root * root;
        f.beckmann = distribution % 2 == 1;
        f.separate = distribution >= 2;
        f.once = false;
        const Vec3 wo = vec3_of(std::sqrt(1.0 - mu * mu), 0.0, mu);
        const double lambda = facets_lambda(f, wo);

        double mirror = 0.0;
        std::vector<double> coat(ALBEDO_INDICES);
        std::vector<double> border(2 * ALBEDO_INDICES);
        for (int i = 0; i < fineness * halfway; ++i) {
            // Denser towards the ends, where slopes have no bound.
            const double x = (i % fineness + 0.5) / fineness;
            const double y = (i / fineness + 0.5) / halfway;
            const double weight = 36.0 * x * (1.0 - x) * y * (1.0 - y) / (fineness * halfway);
            const Vec2 u = vec2_of(x * x * (3.0 - 2.0 * x), 0.5 * y * y * (3.0 - 2.0 * y));
            const Vec3 m = rough == 0 ? vec3_of(0.0, 0.0, 1.0) : facets_visible_normal(f, wo, u);
            const double o = dot(wo, m);
            if (o <= 0.0) {
                continue;
            }
            const auto seen = [&](const Vec3& wi) { return facets_seen_both(f, wo, wi) * (1.0 + lambda); };
            const Vec3 mirrored = m * (2.0 * o) - wo;
            const double reflected = mirrored.z > 0.0 ? (rough == 0 ? 1.0 : seen(mirrored)) : 0.0;
            mirror += weight * reflected;
            for (int j = 0; j < ALBEDO_INDICES; ++j) {
                for (int side = 0; side < 2; ++side) {
                    const double eta = side == 0 ? index_of(j) : 1.0 / index_of(j);
                    double cos_t = 0.0;
                    const double share = j == 0 ? 0.0 : fresnel(o, eta, cos_t);
                    cos_t = j == 0 ? o : cos_t;
                    if (side == 0) {
                        coat[static_cast<std::size_t>(j)] += weight * share * reflected;
                    }
                    const Vec3 bent = m * (o / eta - cos_t) - wo / eta;
                    const double passed = share < 1.0 && bent.z < 0.0 ? (rough == 0 ? 1.0 : seen(bent)) : 0.0;
                    border[static_cast<std::size_t>(side * ALBEDO_INDICES + j)] += weight * (share * reflected + (1.0 - share) * passed);
                }
            }
        }
        value(ALBEDO_MIRROR + distribution, rough, cosine) = lost(mirror);
        for (int j = 0; j < ALBEDO_INDICES; ++j) {
            value(ALBEDO_COAT + distribution * ALBEDO_INDICES + j, rough, cosine) = std::fmin(coat[static_cast<std::size_t>(j)], 1.0);
            for (int side = 0; side < 2; ++side) {
                value(ALBEDO_BORDER + (distribution * 2 + side) * ALBEDO_INDICES + j, rough, cosine) =
                    lost(border[static_cast<std::size_t>(side * ALBEDO_INDICES + j)]);
            }
        }
    }

    static double lost(double albedo) { return std::fmax(1.0 - albedo, 0.0); }

    static double sheen(double roughness, double mu) {
        const Vec3 wo = vec3_of(std::sqrt(1.0 - mu * mu), 0.0, mu);
        constexpr int fine = 64;
        double sum = 0.0;
        for (int i = 0; i < fine; ++i) {
            // Even steps of the root of the cosine: fibres shine towards the horizon.
            const double t = (i + 0.5) / fine;
            const double z = t * t;
            for (int j = 0; j < fine; ++j) {
                const double angle = 3.14159265358979323846 * (j + 0.5) / fine;
                const double s = std::sqrt(1.0 - z * z);
                sum += sheen_value(wo, vec3_of(s * std::cos(angle), s * std::sin(angle), z), roughness) * 2.0 * t;
            }
        }
        return sum * 2.0 * 3.14159265358979323846 / (fine * fine);
    }

    // 2 integral of albedo cos d cos, of what the kernel interpolates: straight lines over t, the root of the cosine; exact by Gauss's rule.
    double mean(int sheet, int rough) {
        double sum = 0.0;
        const double step = 1.0 / (ALBEDO_COSINES - 1);
        for (int i = 0; i + 1 < ALBEDO_COSINES; ++i) {
            const double a = value(sheet, rough, i);
            const double b = value(sheet, rough, i + 1);
            for (const double part : {0.5 - std::sqrt(0.15), 0.5, 0.5 + std::sqrt(0.15)}) {
                const double t = (i + part) * step;
                sum += (part == 0.5 ? 4.0 / 9.0 : 5.0 / 18.0) * step * 4.0 * t * t * t * (a + (b - a) * part);
            }
        }
        return sum;
    }

    double& value(int sheet, int rough, int cosine) {
        return values_[static_cast<std::size_t>((sheet * ALBEDO_ROUGHNESSES + rough) * ALBEDO_COSINES + cosine)];
    }

    std::vector<double> values_;
};

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: %s FILE\n", argv[0]);
        return 2;
    }
    AlbedoTable table;
    table.make();
    if (!table.is_right()) {
        std::fprintf(stderr, "a surface reflects more than it receives\n");
        return 1;
    }
    if (!table.write(argv[1])) {
        std::fprintf(stderr, "cannot write %s\n", argv[1]);
        return 3;
    }
    return 0;
}
