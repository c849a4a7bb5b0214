// How far one picture is from another, in numbers.
#pragma once

#include <cstdint>
#include <span>

namespace lancer {

// Added to the square of the reference in relMSE [Rousselle et al. 2011]: keeps dark pixels from counting without bound.
inline constexpr double relative_epsilon = 0.01;

// Of one channel. d is the picture minus the reference r, pixel by pixel; means are over the pixels in which both are finite.
struct ChannelErrors {
    std::uint64_t pixels = 0;   // compared
    std::uint64_t skipped = 0;  // infinite or no number in either
    double mean = 0.0;
    double reference_mean = 0.0;
    double bias = 0.0;     // mean of d
    double mse = 0.0;      // mean of d^2
    double rel_mse = 0.0;  // mean of d^2 / (r^2 + relative_epsilon)
    double mae = 0.0;      // mean of |d|
    double largest = 0.0;  // |d|
};

// Both spans have the same size.
ChannelErrors channel_errors(std::span<const float> picture, std::span<const float> reference);

// All the channels as one: means weighted by the pixels compared, the largest of the largest.
ChannelErrors joined(std::span<const ChannelErrors> channels);

// Decibels below `peak`, the largest value that a picture for displays can have; infinite when mse is 0.
double peak_signal_to_noise(double mse, double peak);

}  // namespace lancer
