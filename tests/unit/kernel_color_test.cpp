#include "lancer/kernel/color.h"

#include <cmath>

#include <gtest/gtest.h>

#include "lancer/image/image.h"
#include "lancer/spectrum/observer.h"

namespace lancer {
namespace {

TEST(KernelColor, LuminanceIsYOfXyz) {
    for (int channel = 0; channel < 3; ++channel) {
        glm::dvec3 rgb(0.0);
        rgb[channel] = 1.0;
        const kernel::Vec3 v = kernel::vec3_of(static_cast<float>(rgb.x), static_cast<float>(rgb.y), static_cast<float>(rgb.z));
        EXPECT_NEAR(static_cast<double>(kernel::luminance(v)), rgb_to_xyz(rgb).y, 5e-5);
    }
    EXPECT_NEAR(kernel::luminance(kernel::vec3_all(1.0f)), 1.0f, 1e-6f);
}

TEST(KernelColor, SrgbCurve) {
    for (int i = 0; i <= 100000; ++i) {
        const float x = static_cast<float>(i) / 100000.0f;
        ASSERT_NEAR(kernel::srgb_curve(x), srgb_encode(x), 1e-6f) << x;
    }
    EXPECT_EQ(kernel::srgb_curve(0.0f), 0.0f);
    EXPECT_EQ(kernel::srgb_curve(-3.0f), 0.0f);
    EXPECT_NEAR(kernel::srgb_curve(1.0f), 1.0f, 1e-6f);
    EXPECT_EQ(kernel::srgb_curve(9.0f), kernel::srgb_curve(1.0f));
    EXPECT_NEAR(kernel::srgb_curve(0.214041f), 0.5f, 1e-5f);
}

}  // namespace
}  // namespace lancer
