#include "lancer/image/metrics.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "lancer/image/magma.h"

namespace {

using namespace lancer;

TEST(ChannelErrors, VanishForTheSame) {
    const std::vector<float> picture = {0.0f, 1.0f, 2.0f, 1e30f};
    const ChannelErrors errors = channel_errors(picture, picture);
    EXPECT_EQ(errors.pixels, 4u);
    for (const double error : {errors.bias, errors.mse, errors.rel_mse, errors.mae, errors.largest}) {
        EXPECT_EQ(error, 0.0);
    }
    EXPECT_TRUE(std::isinf(peak_signal_to_noise(errors.mse, 1.0)));
}

// r = 1 and 3, d = 0.5 and -0.25.
TEST(ChannelErrors, FollowTheirFormulas) {
    const std::vector<float> picture = {1.5f, 2.75f}, reference = {1.0f, 3.0f};
    const ChannelErrors errors = channel_errors(picture, reference);
    EXPECT_DOUBLE_EQ(errors.mean, 2.125);
    EXPECT_DOUBLE_EQ(errors.reference_mean, 2.0);
    EXPECT_DOUBLE_EQ(errors.bias, 0.125);
    EXPECT_DOUBLE_EQ(errors.mse, (0.25 + 0.0625) / 2.0);
    EXPECT_DOUBLE_EQ(errors.rel_mse, (0.25 / 1.01 + 0.0625 / 9.01) / 2.0);
    EXPECT_DOUBLE_EQ(errors.mae, 0.375);
    EXPECT_DOUBLE_EQ(errors.largest, 0.5);
}

TEST(ChannelErrors, LeaveOutWhatIsNoNumber) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    const std::vector<float> picture = {nan, 2.0f, 1.0f, 5.0f}, reference = {1.0f, 1.0f, infinity, 4.0f};
    const ChannelErrors errors = channel_errors(picture, reference);
    EXPECT_EQ(errors.pixels, 2u);
    EXPECT_EQ(errors.skipped, 2u);
    EXPECT_DOUBLE_EQ(errors.mse, 1.0);
    const ChannelErrors nothing = channel_errors(std::vector<float>{nan}, std::vector<float>{nan});
    EXPECT_EQ(nothing.pixels, 0u);
    EXPECT_EQ(nothing.mse, 0.0);
}

TEST(ChannelErrors, AreJoinedByTheirPixels) {
    const std::array<ChannelErrors, 2> channels = {
        channel_errors(std::vector<float>{1.0f, 1.0f, 1.0f}, std::vector<float>{0.0f, 0.0f, 0.0f}),
        channel_errors(std::vector<float>{3.0f}, std::vector<float>{1.0f})};
    const ChannelErrors all = joined(channels);
    EXPECT_EQ(all.pixels, 4u);
    EXPECT_DOUBLE_EQ(all.mse, (3.0 * 1.0 + 4.0) / 4.0);
    EXPECT_DOUBLE_EQ(all.bias, (3.0 + 2.0) / 4.0);
    EXPECT_DOUBLE_EQ(all.largest, 2.0);
}

TEST(SignalToNoise, IsInDecibels) {
    EXPECT_NEAR(peak_signal_to_noise(0.01, 1.0), 20.0, 1e-12);
    EXPECT_NEAR(peak_signal_to_noise(0.01, 10.0), 40.0, 1e-12);
}

TEST(Magma, GrowsBrighterFromBlack) {
    EXPECT_EQ(magma(0.0f), (std::array<std::uint8_t, 3>{0, 0, 4}));
    EXPECT_EQ(magma(1.0f), (std::array<std::uint8_t, 3>{252, 253, 191}));
    EXPECT_EQ(magma(std::numeric_limits<float>::quiet_NaN()), magma(0.0f));
    EXPECT_EQ(magma(7.0f), magma(1.0f));
    double last = -1.0;
    for (int i = 0; i <= 100; ++i) {
        const auto color = magma(static_cast<float>(i) / 100.0f);
        const double brightness =
            0.2126 * std::pow(color[0] / 255.0, 2.2) + 0.7152 * std::pow(color[1] / 255.0, 2.2) + 0.0722 * std::pow(color[2] / 255.0, 2.2);
        EXPECT_GE(brightness, last - 1e-4) << i;
        last = brightness;
    }
}

}  // namespace
