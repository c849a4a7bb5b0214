// Runs when lancer is built: makes the table of what rough surfaces reflect (see kernel/bsdf/albedo.h) and writes it to the file that its only
// argument names. In double precision, with the kernel's own facets. The stretched ones take the most time.
#define LANCER_DOUBLE

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <thread>
#include <utility>
#include <vector>

#include "lancer/kernel/bsdf/fresnel.h"
#include "lancer/kernel/bsdf/sheen.h"
#include "lancer/kernel/bsdf/stretched.h"

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

    // After make(), whose part is looked up as the kernel does.
    void make_stretched() {
        const std::vector<float> round = in_float();
        WorldRecord world{};
        world.albedo = round.data();
        std::vector<std::thread> threads;
        for (const bool beckmann : {false, true}) {
            threads.emplace_back([this, beckmann, world] {
                add_stretched(world, stretched_mirrors(), beckmann);
                add_stretched(world, stretched_borders(), beckmann);
            });
        }
        for (std::thread& thread : threads) {
            thread.join();
        }
        const std::vector<float> complete = in_float();
        world.albedo = complete.data();
        for (const bool beckmann : {false, true}) {
            add_means(world, stretched_mirrors(), beckmann);
            add_means(world, stretched_borders(), beckmann);
        }
    }

    bool write(const char* path) const {
        const std::vector<float> floats = in_float();
        std::FILE* const file = std::fopen(path, "wb");
        const bool written = file && std::fwrite(floats.data(), sizeof(float), floats.size(), file) == floats.size();
        return (file && std::fclose(file) == 0) && written;
    }

    bool is_right() const {
        // A sheen of little roughness is too bright from the side, which the kernel sees to.
        for (int i = 0; i < STRETCHED_MIRRORS; ++i) {
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

    std::vector<float> in_float() const { return std::vector<float>(values_.begin(), values_.end()); }

    // The indices and sides of a grid's sheets of one distribution; the mirror has no index.
    struct Side {
        int sheet;
        double eta;
    };
    static std::vector<Side> sides_of(const StretchedGrid& grid, bool beckmann) {
        if (grid.first == STRETCHED_MIRRORS) {
            return {{beckmann ? 1 : 0, 0.0}};
        }
        std::vector<Side> sides;
        for (int side = 0; side < 2; ++side) {
            for (int i = 0; i < BORDER_INDICES; ++i) {
                const double root = std::fmax(static_cast<double>(i) / (BORDER_INDICES - 1), 1e-3);
                const double ratio = static_cast<double>(ALBEDO_LARGEST_RATIO) * root * root;
                const double eta = (1.0 + ratio) / (1.0 - ratio);
                sides.push_back({((beckmann ? 2 : 0) + side) * BORDER_INDICES + i, side == 0 ? eta : 1.0 / eta});
            }
        }
        return sides;
    }

    static double looked_up(const WorldRecord& world, const Facets& f, double eta, const Vec3& w) {
        return eta == 0.0 ? facet_loss(world, f, w, true) : border_lost(world, f, eta, w, true);
    }

    // What stretched facets lose beyond what is looked up for round ones.
    void add_stretched(const WorldRecord& world, const StretchedGrid& grid, bool beckmann) {
        const std::vector<Side> sides = sides_of(grid, beckmann);
        const int of_sheet = grid.roughnesses * grid.ratios * grid.cosines * grid.turns;
        for (int rough = 1; rough < grid.roughnesses; ++rough) {
            for (int ratio = 1; ratio < grid.ratios; ++ratio) {
                const Facets f = stretched(rough, ratio, grid, beckmann);
                for (int cosine = 0; cosine < grid.cosines; ++cosine) {
                    for (int turn = 0; turn < grid.turns; ++turn) {
                        const double t = static_cast<double>(cosine) / (grid.cosines - 1);
                        const double mu = std::fmax(t * t, 1e-4);
                        const double y = static_cast<double>(turn) / (grid.turns - 1), x = 1.0 - y;
                        const double sine = std::sqrt(1.0 - mu * mu) / std::sqrt(x * x + y * y);
                        const Vec3 w = vec3_of(sine * x, sine * y, mu);
                        const std::vector<double> losses = losses_of(f, w, sides);
                        const int place = ((rough * grid.ratios + ratio) * grid.cosines + cosine) * grid.turns + turn;
                        for (std::size_t i = 0; i < sides.size(); ++i) {
                            // The parts for stretched facets are still 0 in what is looked up.
                            values_[static_cast<std::size_t>(grid.first + sides[i].sheet * of_sheet + place)] =
                                losses[i] - looked_up(world, f, sides[i].eta, w);
                        }
                    }
                }
            }
        }
    }

    // With that in the table: of both together.
    void add_means(const WorldRecord& world, const StretchedGrid& grid, bool beckmann) {
        for (const Side& side : sides_of(grid, beckmann)) {
            for (int rough = 0; rough < grid.roughnesses; ++rough) {
                for (int ratio = 0; ratio < grid.ratios; ++ratio) {
                    const int place = (side.sheet * grid.roughnesses + rough) * grid.ratios + ratio;
                    values_[static_cast<std::size_t>(grid.first_mean + place)] =
                        mean_looked_up(world, stretched(rough, ratio, grid, beckmann), side.eta);
                }
            }
        }
    }

    // The rougher way is x.
    static Facets stretched(int rough, int ratio, const StretchedGrid& grid, bool beckmann) {
        const double root = static_cast<double>(rough) / (grid.roughnesses - 1);
        const double times = std::pow(10.0, static_cast<double>(ratio) / (grid.ratios - 1));
        Facets f;
        f.y = std::fmax(root * root * std::sqrt(2.0 / (1.0 + times * times)), 1e-6);
        f.x = f.y * times;
        f.beckmann = beckmann;
        f.separate = false;
        f.once = false;
        return f;
    }

    static std::vector<double> losses_of(const Facets& f, const Vec3& wo, const std::vector<Side>& sides) {
        constexpr int fine = 32;
        const double lambda = facets_lambda(f, wo);
        const auto seen = [&](const Vec3& wi) { return (1.0 + lambda) / (1.0 + lambda + facets_lambda(f, wi)); };
        std::vector<double> losses(sides.size(), 1.0);
        for (int i = 0; i < fine * fine; ++i) {
            // Denser towards the ends, where slopes have no bound; GGX's normals go round with the second number.
            const double x = (i % fine + 0.5) / fine;
            const double y = (i / fine + 0.5) / fine;
            const double weight = 6.0 * x * (1.0 - x) * (f.beckmann ? 6.0 * y * (1.0 - y) : 1.0) / (fine * fine);
            const Vec3 m = facets_visible_normal(f, wo, vec2_of(x * x * (3.0 - 2.0 * x), f.beckmann ? y * y * (3.0 - 2.0 * y) : y));
            const double o = dot(wo, m);
            if (o <= 0.0) {
                continue;
            }
            const Vec3 mirrored = m * (2.0 * o) - wo;
            const double reflected = mirrored.z > 0.0 ? seen(mirrored) : 0.0;
            for (std::size_t k = 0; k < sides.size(); ++k) {
                double cos_t = 0.0;
                const double share = sides[k].eta == 0.0 ? 1.0 : fresnel(o, sides[k].eta, cos_t);
                double passed = 0.0;
                if (share < 1.0) {
                    const Vec3 bent = m * (o / sides[k].eta - cos_t) - wo / sides[k].eta;
                    passed = bent.z < 0.0 ? seen(bent) : 0.0;
                }
                losses[k] -= weight * (share * reflected + (1.0 - share) * passed);
            }
        }
        return losses;
    }

    // Over directions, by their cosine, of what the kernel looks up.
    static double mean_looked_up(const WorldRecord& world, const Facets& f, double eta) {
        constexpr int cosines = 48, turns = 24;
        double sum = 0.0;
        for (int i = 0; i < cosines * turns; ++i) {
            const double t = (i / turns + 0.5) / cosines;  // the root of the cosine
            const double angle = 0.5 * 3.14159265358979323846 * (i % turns + 0.5) / turns;
            const double z = t * t, sine = std::sqrt(1.0 - z * z);
            sum += looked_up(world, f, eta, vec3_of(sine * std::cos(angle), sine * std::sin(angle), z)) * 4.0 * t * t * t;
        }
        return sum / (cosines * turns);
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
    table.make_stretched();
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
