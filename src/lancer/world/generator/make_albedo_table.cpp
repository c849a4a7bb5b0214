// Runs when lancer is built: makes the table of what rough surfaces reflect (see kernel/bsdf/albedo.h) and writes it to the file that its only
// argument names. In double precision, with the kernel's own facets. The stretched ones take the most time.
#define LANCER_DOUBLE

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <thread>
#include <utility>
#include <vector>

#include "lancer/kernel/bsdf/sheen.h"
#include "lancer/world/generator/facet_meetings.h"

namespace lancer {
namespace {

using namespace kernel_double;

// A relative index of refraction above 1, node i of so many.
double index_of(int i, int count) {
    const double root = static_cast<double>(i) / (count - 1);
    const double ratio = static_cast<double>(ALBEDO_LARGEST_RATIO) * root * root;
    return (1.0 + ratio) / (1.0 - ratio);
}

// What the kernel's place_of_cosine() turns round.
double cosine_at(double place, double critical) {
    if (critical == 0.0) {
        return place * place;
    }
    const double half = static_cast<double>(HALF_CRITICAL_PLACE), whole = static_cast<double>(CRITICAL_PLACE);
    const double low = place / half, high = (whole - place) / (whole - half), above = (place - whole) / (1.0 - whole);
    return place >= whole ? critical + (1.0 - critical) * above * above
                          : critical * (place < half ? 0.5 * low * low : 1.0 - 0.5 * high * high);
}
double slope_of_cosine_at(double place, double critical) {
    if (critical == 0.0) {
        return 2.0 * place;
    }
    const double half = static_cast<double>(HALF_CRITICAL_PLACE), whole = static_cast<double>(CRITICAL_PLACE);
    const double low = place / (half * half), high = (whole - place) / ((whole - half) * (whole - half));
    return place >= whole ? 2.0 * (1.0 - critical) * (place - whole) / ((1.0 - whole) * (1.0 - whole))
                          : critical * (place < half ? low : high);
}

// A direction of that cosine, on the way of the vector (x, y).
Vec3 direction_of(double cosine, double x, double y) {
    const double mu = std::fmax(cosine, 1e-4), sine = std::sqrt(1.0 - mu * mu) / std::sqrt(x * x + y * y);
    return vec3_of(sine * x, sine * y, mu);
}

class AlbedoTable {
public:
    AlbedoTable() : values_(static_cast<std::size_t>(ALBEDO_VALUES)) {}

    void make() {
        std::vector<std::thread> threads;
        for (int distribution = 0; distribution < ALBEDO_DISTRIBUTIONS; ++distribution) {
            threads.emplace_back([this, distribution] {
                for (int i = 0; i < ALBEDO_SHEET; ++i) {
                    add_facets(distribution, i / ALBEDO_COSINES, i % ALBEDO_COSINES);
                }
            });
        }
        for (std::thread& thread : threads) {
            thread.join();
        }
        for (int i = 0; i < ALBEDO_SHEET; ++i) {
            const int rough = i / ALBEDO_COSINES, cosine = i % ALBEDO_COSINES;
            value(ALBEDO_SHEEN, rough, cosine) =
                sheen(static_cast<double>(rough) / (ALBEDO_ROUGHNESSES - 1), direction_of(cosine_at(place_of(cosine), 0.0), 1.0, 0.0));
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
            for (const int part : {0, 1}) {
                threads.emplace_back([this, beckmann, part, world] {
                    add_stretched(world, stretched_mirrors(), beckmann, part);
                    add_stretched(world, stretched_borders(), beckmann, part);
                });
            }
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
    static double place_of(int cosine) { return static_cast<double>(cosine) / (ALBEDO_COSINES - 1); }

    void add_facets(int distribution, int rough, int cosine) {
        const double root = static_cast<double>(rough) / (ALBEDO_ROUGHNESSES - 1);
        Facets f;
        f.x = f.y = rough == 0 ? 1e-6 : root * root;
        f.beckmann = distribution % 2 == 1;
        f.separate = distribution >= 2;
        f.once = false;
        std::vector<double> outside{mirror_eta};
        for (int j = 0; j < ALBEDO_INDICES; ++j) {
            outside.push_back(index_of(j, ALBEDO_INDICES));
        }
        const std::vector<Meeting> met = meetings(f, direction_of(cosine_at(place_of(cosine), 0.0), 1.0, 0.0), outside);
        value(ALBEDO_MIRROR + distribution, rough, cosine) = met[0].lost;
        for (int j = 0; j < ALBEDO_INDICES; ++j) {
            const Meeting& border = met[static_cast<std::size_t>(j) + 1];
            value(ALBEDO_COAT + distribution * ALBEDO_INDICES + j, rough, cosine) = border.reflected;
            value(ALBEDO_BORDER + distribution * 2 * ALBEDO_INDICES + j, rough, cosine) = border.lost;
            const double within = 1.0 / outside[static_cast<std::size_t>(j) + 1];
            const Vec3 wo = direction_of(cosine_at(place_of(cosine), critical_cosine_within(j)), 1.0, 0.0);
            value(ALBEDO_BORDER + (distribution * 2 + 1) * ALBEDO_INDICES + j, rough, cosine) = meetings(f, wo, {within})[0].lost;
        }
    }

    // Node j's, on the denser side. Where there is none the kernel asks beyond node 0, from a side that is hardly denser.
    static double critical_cosine_within(int j) { return std::fmax(critical_cosine(1.0 / index_of(j, ALBEDO_INDICES)), 1e-6); }

    static double sheen(double roughness, const Vec3& wo) {
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

    // 2 integral of albedo cos d cos, of what the kernel interpolates: straight lines over the place of the cosine; exact by Gauss's rule.
    double mean(int sheet, int rough) {
        const int border = sheet - ALBEDO_BORDER, side = border / ALBEDO_INDICES;
        const bool within = border >= 0 && sheet < ALBEDO_SHEEN && side % 2 == 1;
        const double critical = within ? critical_cosine_within(border % ALBEDO_INDICES) : 0.0;
        double sum = 0.0;
        const double step = 1.0 / (ALBEDO_COSINES - 1);
        for (int i = 0; i + 1 < ALBEDO_COSINES; ++i) {
            const double a = value(sheet, rough, i);
            const double b = value(sheet, rough, i + 1);
            for (const double part : {0.5 - std::sqrt(0.15), 0.5, 0.5 + std::sqrt(0.15)}) {
                const double t = (i + part) * step;
                const double weight = (part == 0.5 ? 4.0 / 9.0 : 5.0 / 18.0) * step;
                sum += weight * 2.0 * cosine_at(t, critical) * slope_of_cosine_at(t, critical) * (a + (b - a) * part);
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
            return {{beckmann ? 1 : 0, mirror_eta}};
        }
        std::vector<Side> sides;
        for (int side = 0; side < 2; ++side) {
            for (int i = 0; i < BORDER_INDICES; ++i) {
                const double eta = std::fmax(index_of(i, BORDER_INDICES), 1.0 + 1e-6);
                sides.push_back({((beckmann ? 2 : 0) + side) * BORDER_INDICES + i, side == 0 ? eta : 1.0 / eta});
            }
        }
        return sides;
    }

    static double looked_up(const WorldRecord& world, const Facets& f, double eta, const Vec3& w) {
        return eta == mirror_eta ? facet_loss(world, f, w, true) : border_lost(world, f, eta, w, true);
    }

    // What stretched facets lose beyond what is looked up for round ones. `part`: 0 or 1, every other roughness.
    void add_stretched(const WorldRecord& world, const StretchedGrid& grid, bool beckmann, int part) {
        std::vector<Side> outside, within;
        for (const Side& side : sides_of(grid, beckmann)) {
            (side.eta == mirror_eta || side.eta > 1.0 ? outside : within).push_back(side);
        }
        for (int rough = 1 + part; rough < grid.roughnesses; rough += 2) {
            for (int ratio = 1; ratio < grid.ratios; ++ratio) {
                const Facets f = stretched(rough, ratio, grid, beckmann);
                for (int view = 0; view < grid.cosines * grid.turns; ++view) {
                    const int place = (rough * grid.ratios + ratio) * grid.cosines * grid.turns + view;
                    add_stretched(world, grid, f, view, place, outside);
                    for (const Side& side : within) {
                        add_stretched(world, grid, f, view, place, {side});
                    }
                }
            }
        }
    }

    // At one place of the sheets of these sides, which are seen under the same angle.
    void add_stretched(const WorldRecord& world, const StretchedGrid& grid, const Facets& f, int view, int place,
                       const std::vector<Side>& sides) {
        const double eta = sides.front().eta;
        const double critical = eta == mirror_eta ? 0.0 : critical_cosine(eta);
        const double y = static_cast<double>(view % grid.turns) / (grid.turns - 1);
        const Vec3 w = direction_of(cosine_at(static_cast<double>(view / grid.turns) / (grid.cosines - 1), critical), 1.0 - y, y);
        std::vector<double> etas;
        for (const Side& side : sides) {
            etas.push_back(side.eta);
        }
        const std::vector<Meeting> met = meetings(f, w, etas);
        const int of_sheet = grid.roughnesses * grid.ratios * grid.cosines * grid.turns;
        for (std::size_t i = 0; i < sides.size(); ++i) {
            // The parts for stretched facets are still 0 in what is looked up.
            values_[static_cast<std::size_t>(grid.first + sides[i].sheet * of_sheet + place)] =
                met[i].lost - looked_up(world, f, sides[i].eta, w);
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

    // Over directions, by their cosine, of what the kernel looks up.
    static double mean_looked_up(const WorldRecord& world, const Facets& f, double eta) {
        constexpr int cosines = 96, turns = 24;
        const double critical = eta == mirror_eta ? 0.0 : critical_cosine(eta);
        double sum = 0.0;
        for (int i = 0; i < cosines * turns; ++i) {
            const double t = (i / turns + 0.5) / cosines;
            const double angle = 0.5 * 3.14159265358979323846 * (i % turns + 0.5) / turns;
            const double cosine = cosine_at(t, critical);
            const Vec3 w = direction_of(cosine, std::cos(angle), std::sin(angle));
            sum += looked_up(world, f, eta, w) * 2.0 * cosine * slope_of_cosine_at(t, critical);
        }
        return sum / (cosines * turns);
    }

    double& value(int sheet, int rough, int cosine) {
        return values_[static_cast<std::size_t>((sheet * ALBEDO_ROUGHNESSES + rough) * ALBEDO_COSINES + cosine)];
    }

    std::vector<double> values_;
};

}  // namespace
}  // namespace lancer

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: %s FILE\n", argv[0]);
        return 2;
    }
    lancer::AlbedoTable table;
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
