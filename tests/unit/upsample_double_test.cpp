// The kernel's look-up in double precision: the reference's formula, not only its values.
#define LANCER_DOUBLE
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "lancer/kernel/upsample.h"
#include "lancer/spectrum/upsample.h"

namespace lancer {
namespace {

TEST(Upsampling, KernelInDoubleIsTheReference) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int i = 0; i < 5000; ++i) {
        const kernel_double::Vec3 color{unit(random), unit(random), unit(random)};
        const SmoothSpectrum expected = smooth_reflectance({color.x, color.y, color.z});
        const kernel_double::Vec3 c = kernel_double::reflectance_coefficients(upsampling_table().data(), color, true);
        EXPECT_NEAR(c.x, expected.coefficients.x, 1e-9 * (1.0 + std::fabs(c.x)));
        EXPECT_NEAR(c.y, expected.coefficients.y, 1e-9 * (1.0 + std::fabs(c.y)));
        EXPECT_NEAR(c.z, expected.coefficients.z, 1e-9 * (1.0 + std::fabs(c.z)));
    }
}

}  // namespace
}  // namespace lancer
