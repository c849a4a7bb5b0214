// The kernel's own elementary functions against the C library's in double.
#include "lancer/kernel/math.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

namespace lancer {
namespace {

constexpr double promised = 3e-7;  // relative, as math.h says

// Calls check(x) for `count` floats from low to high, evenly spaced in their logarithm where `ratio`.
template <class Check>
void for_floats(double low, double high, int count, bool ratio, const Check& check) {
    for (int i = 0; i <= count; ++i) {
        const double t = static_cast<double>(i) / count;
        check(static_cast<float>(ratio ? low * std::pow(high / low, t) : low + (high - low) * t));
    }
}

double relative_error(float value, double exact) { return std::abs(static_cast<double>(value) - exact) / std::abs(exact); }

TEST(KernelMath, PowerOf2) {
    double worst = 0.0;
    for_floats(-126.0, 127.0, 500000, false,
               [&](float x) { worst = std::max(worst, relative_error(kernel::power_of_2(x), std::exp2(static_cast<double>(x)))); });
    EXPECT_LT(worst, promised);
    for (int n = -126; n <= 127; ++n) {
        EXPECT_EQ(kernel::power_of_2(static_cast<float>(n)), std::ldexp(1.0f, n)) << n;
    }
    EXPECT_EQ(kernel::power_of_2(-127.0f), 0.0f);
    EXPECT_EQ(kernel::power_of_2(-1e30f), 0.0f);
    EXPECT_EQ(kernel::power_of_2(1e30f), std::ldexp(1.0f, 127));
}

TEST(KernelMath, Log2) {
    double worst = 0.0, worst_near_1 = 0.0;
    for_floats(1.2e-38, 3e38, 500000, true, [&](float x) {
        const double exact = std::log2(static_cast<double>(x));
        if (exact != 0.0) {
            worst = std::max(worst, relative_error(kernel::log_2(x), exact));
        }
    });
    for_floats(0.5, 2.0, 500000, true, [&](float x) {
        const double exact = std::log2(static_cast<double>(x));
        if (exact != 0.0) {
            worst_near_1 = std::max(worst_near_1, relative_error(kernel::log_2(x), exact));
        }
    });
    EXPECT_LT(worst, promised);
    EXPECT_LT(worst_near_1, promised);
    for (int n = -126; n <= 127; ++n) {
        EXPECT_EQ(kernel::log_2(std::ldexp(1.0f, n)), static_cast<float>(n));
    }
}

TEST(KernelMath, Exponential) {
    for_floats(-87.0, 88.0, 200000, false, [](float x) {
        // The product with log2(e) rounds: the error grows with x.
        ASSERT_LT(relative_error(kernel::exponential(x), std::exp(static_cast<double>(x))),
                  promised + 1.5e-7 * std::abs(static_cast<double>(x)))
            << x;
    });
    EXPECT_EQ(kernel::exponential(0.0f), 1.0f);
    EXPECT_EQ(kernel::exponential(-0.0f), 1.0f);
    EXPECT_EQ(kernel::exponential(-1e30f), 0.0f);
}

TEST(KernelMath, Power) {
    for (const float y : {0.25f, 1.0f / 2.4f, 1.0f, 2.0f, 5.0f, 50.0f, 1000.0f}) {
        for_floats(1e-6, 1.0, 50000, true, [&](float x) {
            const double exact = std::pow(static_cast<double>(x), static_cast<double>(y));
            if (exact > 1.2e-38) {
                const double turns = std::abs(static_cast<double>(y) * std::log2(static_cast<double>(x)));
                ASSERT_LT(relative_error(kernel::power(x, y), exact), promised + 2.5e-7 * turns) << x << " ^ " << y;
            } else {
                ASSERT_LT(kernel::power(x, y), 1.3e-38f);
            }
        });
        EXPECT_EQ(kernel::power(1.0f, y), 1.0f);
        EXPECT_EQ(kernel::power(0.0f, y), 0.0f);
    }
}

TEST(KernelMath, AngleOf) {
    double worst = 0.0;
    for (const double size : {1e-30, 1.0, 1e30}) {
        for (int i = -100000; i <= 100000; ++i) {
            const double angle = std::numbers::pi * i / 100000.0;
            const auto y = static_cast<float>(size * std::sin(angle)), x = static_cast<float>(size * std::cos(angle));
            const double exact = std::atan2(static_cast<double>(y), static_cast<double>(x));
            const double off = std::abs(static_cast<double>(kernel::angle_of(y, x)) - exact);
            worst = std::max(worst, std::min(off, 2.0 * std::numbers::pi - off));  // pi and -pi are one direction
        }
    }
    EXPECT_LT(worst, 5e-7);
    EXPECT_EQ(kernel::angle_of(0.0f, 0.0f), 0.0f);
    EXPECT_EQ(kernel::angle_of(0.0f, 2.0f), 0.0f);
    EXPECT_FLOAT_EQ(kernel::angle_of(3.0f, 0.0f), std::numbers::pi_v<float> / 2);
    EXPECT_FLOAT_EQ(kernel::angle_of(-3.0f, 0.0f), -std::numbers::pi_v<float> / 2);
    EXPECT_FLOAT_EQ(kernel::angle_of(0.0f, -1.0f), std::numbers::pi_v<float>);
    EXPECT_FLOAT_EQ(kernel::angle_of(-0.0f, -1.0f), std::numbers::pi_v<float>) << "no sign is read off a zero";
}

TEST(KernelMath, SmallThings) {
    EXPECT_EQ(kernel::clamp01(-1.0f), 0.0f);
    EXPECT_EQ(kernel::clamp01(0.25f), 0.25f);
    EXPECT_EQ(kernel::clamp01(7.0f), 1.0f);
    EXPECT_EQ(kernel::with_sign_of(2.0f, -0.5f), -2.0f);
    EXPECT_EQ(kernel::with_sign_of(2.0f, 0.5f), 2.0f);
    EXPECT_EQ(kernel::with_sign_of(2.0f, -0.0f), 2.0f);
    EXPECT_EQ(kernel::ROUNDING, std::numeric_limits<float>::epsilon() / 2);
    EXPECT_EQ(kernel::SMALLEST, std::numeric_limits<float>::min());
    EXPECT_TRUE(std::isfinite(1.0f / kernel::SMALLEST));
}

}  // namespace
}  // namespace lancer
