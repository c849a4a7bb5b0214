#include "lancer/world/generator/facet_meetings.h"

#include <algorithm>
#include <cmath>

namespace lancer {

using namespace kernel_double;

namespace {

double smooth_step(double x) { return x * x * (3.0 - 2.0 * x); }
double smooth_step_slope(double x) { return 6.0 * x * (1.0 - x); }

// Light along wo that meets a facet whose normal is m, at a cosine of o > 0.
template <class Seen>
void add_meeting(Meeting& meeting, double eta, const Vec3& wo, const Vec3& m, double o, double weight, double reflected, const Seen& seen) {
    double cos_t = o;
    const double share = eta == mirror_eta ? 1.0 : eta == 1.0 ? 0.0 : fresnel(o, eta, cos_t);
    double passed = 0.0;
    if (share < 1.0) {
        const Vec3 bent = m * (o / eta - cos_t) - wo / eta;
        passed = bent.z < 0.0 ? seen(bent) : 0.0;
    }
    meeting.reflected += weight * share * reflected;
    meeting.lost -= weight * (share * reflected + (1.0 - share) * passed);
}

}  // namespace

std::vector<Meeting> meetings(const Facets& f, const Vec3& wo, const std::vector<double>& etas) {
    std::vector<Meeting> sums(etas.size(), Meeting{1.0, 0.0});
    const bool round = f.x == f.y;
    const bool smooth = f.x <= 1e-6 && f.y <= 1e-6;
    // So many facets in each of the two ways; of round ones those on one half: both are alike.
    const int fineness = smooth ? 1 : round ? 48 : 32;
    const int others = smooth ? 1 : round ? fineness / 2 : fineness;
    const double lambda = facets_lambda(f, wo);
    const auto seen = [&](const Vec3& wi) { return smooth ? 1.0 : facets_seen_both(f, wo, wi) * (1.0 + lambda); };
    for (int i = 0; i < fineness * others; ++i) {
        // Denser towards the ends, where slopes have no bound; GGX's normals go round with the second number.
        const double x = (i % fineness + 0.5) / fineness;
        const double y = (i / fineness + 0.5) / others;
        const double weight = smooth_step_slope(x) * (f.beckmann ? smooth_step_slope(y) : 1.0) / (fineness * others);
        const double second = (f.beckmann ? smooth_step(y) : y) * (round ? 0.5 : 1.0);
        const Vec3 m = smooth ? vec3_of(0.0, 0.0, 1.0) : facets_visible_normal(f, wo, vec2_of(smooth_step(x), second));
        const double o = dot(wo, m);
        if (o <= 0.0) {
            continue;
        }
        const Vec3 mirrored = m * (2.0 * o) - wo;
        const double reflected = mirrored.z > 0.0 ? seen(mirrored) : 0.0;
        for (std::size_t k = 0; k < etas.size(); ++k) {
            add_meeting(sums[k], etas[k], wo, m, o, smooth ? 1.0 : weight, reflected, seen);
        }
    }
    for (Meeting& sum : sums) {
        sum.lost = std::max(sum.lost, 0.0);
        sum.reflected = std::min(sum.reflected, 1.0);
    }
    return sums;
}

}  // namespace lancer
