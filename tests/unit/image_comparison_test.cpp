#include "lancer/image/comparison.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "lancer/image/exact.h"

namespace {

using namespace lancer;

constexpr int width = 32, height = 16;

Channel filled(const std::string& name, float value) { return {name, Stored::float32, std::vector<float>(width * height, value), {}}; }

LayeredImage flat(float r, float g, float b) { return {width, height, {filled("R", r), filled("G", g), filled("B", b)}, {}}; }

// Noise of spread 0.1 around a colour, with the variances that a renderer would tell.
LayeredImage noisy(unsigned seed, float r, float g, float b, bool with_variances) {
    LayeredImage image = flat(r, g, b);
    std::mt19937 random(seed);
    std::normal_distribution<float> normal(0.0f, 0.1f);
    for (Channel& channel : image.channels) {
        for (float& value : channel.values) {
            value += normal(random);
        }
    }
    if (with_variances) {
        for (const char* name : {"variance.R", "variance.G", "variance.B"}) {
            image.channels.push_back(filled(name, 0.01f));
        }
    }
    return image;
}

Runs group(std::vector<LayeredImage> images) {
    Runs runs;
    for (std::size_t i = 0; i < images.size(); ++i) {
        runs.names.push_back("run " + std::to_string(i));
    }
    runs.images = std::move(images);
    return runs;
}

TEST(Comparison, OfTheSameFindsNothing) {
    const Comparison found = compare(group({flat(0.5f, 0.25f, 2.0f)}), group({flat(0.5f, 0.25f, 2.0f)}), {});
    EXPECT_EQ(found.all.mse, 0.0);
    EXPECT_EQ(found.flip->mean(), 0.0);
    EXPECT_FALSE(found.psnr);
    EXPECT_TRUE(found.exposures);
    EXPECT_TRUE(found.bias.empty());
    EXPECT_EQ(verdict(found, {}), "whether the means differ can't be told, for nothing is known of the noise");
}

TEST(Comparison, TellsErrorsByChannel) {
    const Comparison found = compare(group({flat(0.5f, 0.5f, 0.5f)}), group({flat(0.5f, 0.25f, 0.0f)}), {});
    ASSERT_EQ(found.colors.size(), 3u);
    EXPECT_EQ(found.colors[0].name, "R");
    EXPECT_DOUBLE_EQ(found.colors[1].errors.mse, 0.0625);
    EXPECT_DOUBLE_EQ(found.all.mse, (0.0625 + 0.25) / 3.0);
    EXPECT_GT(found.flip->mean(), 0.1);
}

// Runs are averaged before they are compared: 1 and 3 against 2.
TEST(Comparison, AveragesRuns) {
    const Comparison found = compare(group({flat(1, 1, 1), flat(3, 3, 3)}), group({flat(2, 2, 2)}), {});
    EXPECT_EQ(found.all.mse, 0.0);
    EXPECT_TRUE(found.reference_is_exact);
    EXPECT_FALSE(found.picture_is_exact);
}

// Means of 512 pixels of spread 0.1 are known to 0.0044, their difference to 0.00625: 0.05 is 8 standard deviations, and most
// likely 1 % of 5.
TEST(Comparison, TellsABiasFromNoiseByVariances) {
    const Comparison biased = compare(group({noisy(1, 5.05f, 5.05f, 5.05f, true)}), group({noisy(2, 5.0f, 5.0f, 5.0f, true)}), {});
    ASSERT_EQ(biased.bias.size(), 4u);
    EXPECT_EQ(biased.bias[0].name, "luminance");
    EXPECT_LT(biased.headline_p, 1e-6);
    EXPECT_NEAR(biased.bias[0].means.difference, 0.05, 0.02);
    EXPECT_NEAR(biased.bias[0].means.error, 0.1 * std::sqrt(2.0 / 512.0), 1e-4);
    EXPECT_NE(verdict(biased, {}).find("the means differ by +"), std::string::npos) << verdict(biased, {});
    EXPECT_NE(verdict(biased, {}).find(" % +- 0.1"), std::string::npos) << verdict(biased, {});

    const Comparison same = compare(group({noisy(3, 5, 5, 5, true)}), group({noisy(4, 5, 5, 5, true)}), {});
    EXPECT_GT(same.headline_p, 0.01);
    EXPECT_GT(same.worst_block_p, 0.01);
    EXPECT_NE(verdict(same, {}).find("the means differ no more than noise does"), std::string::npos) << verdict(same, {});
    EXPECT_EQ(same.more_channels, 3u);
}

TEST(Comparison, TellsABiasFromNoiseByRuns) {
    const auto runs = [](unsigned first, float mean) {
        std::vector<LayeredImage> images;
        for (unsigned i = 0; i < 4; ++i) {
            images.push_back(noisy(first + i, mean, mean, mean, false));
        }
        return group(std::move(images));
    };
    EXPECT_LT(compare(runs(10, 5.05f), runs(20, 5.0f), {}).headline_p, 1e-3);
    EXPECT_GT(compare(runs(30, 5.0f), runs(40, 5.0f), {}).headline_p, 0.01);
}

// Blue weighs 7 % of luminance: there its bias drowns.
TEST(Comparison, NamesTheChannelThatLuminanceHides) {
    const Comparison found = compare(group({noisy(1, 5, 5, 5.03f, true)}), group({noisy(2, 5, 5, 5, true)}), {});
    ASSERT_LT(found.headline_p, 0.01);
    EXPECT_EQ(found.bias[found.headline].name, "B");
    EXPECT_NE(verdict(found, {}).find("the means of B differ by +"), std::string::npos) << verdict(found, {});
}

TEST(Comparison, FindsABlockThatDiffersWhereMeansDoNot) {
    LayeredImage picture = noisy(3, 5, 5, 5, true);
    for (int y = 8; y < 16; ++y) {
        for (int x = 16; x < 32; ++x) {  // brighter left, darker right
            picture.channels[1].values[static_cast<std::size_t>(width * y + x)] += x < 24 ? 0.1f : -0.1f;
        }
    }
    ComparisonOptions options;
    options.block = 8;
    const Comparison found = compare(group({picture}), group({noisy(4, 5, 5, 5, true)}), options);
    EXPECT_GT(found.headline_p, 0.01);
    EXPECT_LT(found.worst_block_p, 1e-3);
    EXPECT_EQ(found.bias[found.worst_block].name, "G");
    EXPECT_NE(verdict(found, options).find("but some blocks of 8 x 8 pixels do, most of all G at "), std::string::npos)
        << verdict(found, options);
}

TEST(Comparison, OfDisplaysHasItsOwnMeasures) {
    LayeredImage a = flat(1, 1, 1), b = flat(0, 0, 0);
    a.display = b.display = true;
    const Comparison found = compare(group({a}), group({b}), {});
    EXPECT_FALSE(found.exposures);
    EXPECT_DOUBLE_EQ(*found.psnr, 0.0);  // white against black
    EXPECT_NEAR(found.flip->mean(), 0.96738, 1e-4);
}

TEST(Comparison, TakesGreyAndOtherChannels) {
    const LayeredImage grey{width, height, {filled("Y", 1.0f), filled("depth.Z", 3.0f)}, {}};
    const LayeredImage other{width, height, {filled("Y", 1.5f), filled("depth.Z", 5.0f), filled("A", 1.0f)}, {}};
    ComparisonOptions options;
    options.others = true;
    const Comparison found = compare(group({grey}), group({other}), options);
    EXPECT_EQ(found.colors[0].name, "Y");
    EXPECT_TRUE(found.flip);
    ASSERT_EQ(found.others.size(), 1u);
    EXPECT_DOUBLE_EQ(found.others[0].errors.mse, 4.0);
    const LayeredImage depth{width, height, {filled("depth.Z", 3.0f)}, {}};
    EXPECT_FALSE(compare(group({depth}), group({other}), {}).flip);
}

TEST(Comparison, TakesSpectraBandByBand) {
    LayeredImage image{width, height, {}, {}};
    for (const char* name : {"S0.400,000000nm", "S0.500,000000nm", "depth.Z", "samples"}) {
        image.channels.push_back(filled(name, 2.0f));
    }
    LayeredImage noisier = image;
    noisier.channels.push_back(filled("variance.S0.500,000000nm", 0.01f));
    const Comparison found = compare(group({image}), group({noisier}), {});
    ASSERT_EQ(found.colors.size(), 2u);
    EXPECT_EQ(found.colors[1].name, "S0.500,000000nm");
    EXPECT_EQ(found.more_channels, 2u);
    EXPECT_FALSE(found.flip);
    ASSERT_EQ(found.bias.size(), 1u);  // nothing is known of the other band's noise
    EXPECT_EQ(found.bias[0].name, "S0.500,000000nm");
}

TEST(Comparison, RefusesWhatCantBeCompared) {
    const LayeredImage small{1, 1, {{"R", Stored::half, {1.0f}, {}}}, {}};
    EXPECT_THROW(compare(group({flat(1, 1, 1)}), group({small}), {}), std::runtime_error);
    const LayeredImage depth{width, height, {filled("depth.Z", 3.0f)}, {}};
    EXPECT_THROW(compare(group({flat(1, 1, 1)}), group({depth}), {}), std::runtime_error);
}

TEST(ExactDifference, LooksAtEveryBitAndNothingElse) {
    LayeredImage a = flat(1, 2, 3), b = a;
    b.metadata["lancer:command"] = "another";
    std::reverse(b.channels.begin(), b.channels.end());
    EXPECT_EQ(exact_difference(a, "a", b, "b"), "");
    b.channels[0].values[width + 5] = std::nextafter(3.0f, 4.0f);
    EXPECT_EQ(exact_difference(a, "a", b, "b"), "1 of 512 pixels differ; the first is channel B at 5,1: 3 in a, 3.0000002 in b");
    b = a;
    b.channels[2].values[0] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_NE(exact_difference(a, "a", b, "b"), "");
    EXPECT_EQ(exact_difference(b, "b", b, "b"), "");
    b = a;
    b.channels[0].stored = Stored::half;
    EXPECT_EQ(exact_difference(a, "a", b, "b"), "channel R is stored as float in a, as half in b");
    b = a;
    b.channels.push_back(filled("A", 1.0f));
    EXPECT_EQ(exact_difference(a, "a", b, "b"), "b has a channel A, a has none");
    EXPECT_EQ(exact_difference(b, "b", a, "a"), "b has a channel A, a has none");
}

}  // namespace
