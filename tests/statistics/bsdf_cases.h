// The BSDFs under test: each kind with several parameters. A kind that is missing here fails the test program.
#pragma once

#include <string>
#include <vector>

#include "lancer/kernel/bsdf/bsdf.h"

namespace lancer::statistics {

struct BsdfCase {
    std::string name;
    kernel::Closure closure;
    kernel::Closure other_side;  // the same surface met from within; `transmits` only
    bool transmits = false;
    bool white = false;  // nothing is swallowed: a white furnace stays white
    bool reciprocal = true;
    double furnace = 0.005;  // how far from white it may be
};

// For sampling and reciprocity, with colours; and the white ones, over all roughnesses.
std::vector<BsdfCase> bsdf_cases();
std::vector<BsdfCase> white_cases();

// Directions by their cosine.
kernel::Vec3 direction_of(double cosine, double angle);

kernel::BsdfValue value_of(const kernel::Closure& closure, const kernel::Vec3& wo, const kernel::Vec3& wi);
kernel::BsdfSample sample_of(const kernel::Closure& closure, const kernel::Vec3& wo, double choice, double u, double v);

}  // namespace lancer::statistics
