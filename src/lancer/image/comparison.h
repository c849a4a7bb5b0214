// Two pictures, or two groups of pictures of the same thing, held against each other.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lancer/image/flip.h"
#include "lancer/image/layers.h"
#include "lancer/image/metrics.h"
#include "lancer/image/significance.h"

namespace lancer {

// A picture, by as many runs of it as there are; all of the same size. They must not share their random numbers.
struct Runs {
    std::vector<std::string> names;  // of the files, for messages
    std::vector<LayeredImage> images;

    // Reads them. Throws as `read_layers` does, and std::runtime_error when sizes differ.
    static Runs read(const std::vector<std::string>& paths);
};

// One channel of the mean of the runs against the mean of the reference's.
struct ChannelComparison {
    std::string name;
    ChannelErrors errors;
};

// The test of one channel, or of luminance, for differences that noise does not explain.
struct BiasTest {
    std::string name;
    double reference_mean = 0.0;
    WelchTest means;
    std::optional<CellTests> pixels, blocks;  // not of luminance
};

struct Comparison {
    int width = 0;
    int height = 0;
    std::vector<ChannelComparison> colors;  // R, G and B; or Y; or the spectrum's S0.*; or else whatever both have
    std::vector<ChannelComparison> others;  // the other channels that both have, if asked for
    std::size_t more_channels = 0;          // how many others there are
    ChannelErrors all;                      // of the colours

    bool display = false;         // one of the two can't hold more than a display shows
    std::optional<double> psnr;   // for displays: of the encoded values, whose peak is 1
    std::optional<FlipMap> flip;  // of RGB, and of Y taken as grey
    std::optional<FlipExposures> exposures;
    Image mean, reference_mean;  // the colours, three channels for RGB and Y

    std::vector<BiasTest> bias;       // luminance first where there are R, G and B; empty when nothing is known of the noise
    bool picture_is_exact = false;    // a single run without variances
    bool reference_is_exact = false;  // the same
    std::size_t headline = 0;         // into bias: luminance, or the channel that differs where luminance does not
    double headline_p = 1.0;          // of the means; of a channel times the number of channels
    std::size_t worst_block = 0;      // into bias: the channel with the worst block
    double worst_block_p = 1.0;       // of all blocks of all channels
};

struct ComparisonOptions {
    int block = 16;              // side of a block, pixels
    bool others = false;         // compare the other channels, too
    double significance = 0.01;  // p below which a difference counts
    double pixels_per_degree = flip_pixels_per_degree;
};

// Throws std::runtime_error with a sentence when sizes differ or no channel is in both.
Comparison compare(const Runs& picture, const Runs& reference, const ComparisonOptions& options);

// "the means differ by +0.13 % +- 0.05 % (p = 0.012)": one sentence without its full stop.
std::string verdict(const Comparison& comparison, const ComparisonOptions& options);

}  // namespace lancer
